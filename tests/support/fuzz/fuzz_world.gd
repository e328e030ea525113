class_name FuzzWorld
extends RefCounted
## A random world as plain data: what is there at the start, and what is changed from outside while
## time goes on. Everything is copied where it is built, so that a judge changes nothing in it.

## No coordinate is larger than this, in pixels.
const LARGEST := WorldLimits.LARGEST

const _PER_LINE := 4
const _PER_BALL := 7

## px/s².
var gravity := Vec2.zero()
## C, 0..1.
var bounciness := 1.0
## µ, 0 or more.
var friction := 0.0
## The corners at the upper left and the lower right; empty where there are no walls.
var walls: Array[Vec2] = []
## The lines at the start.
var lines: Array[LineSegment] = []
## The balls at the start.
var balls: Array[Ball] = []
## What is changed from outside, in order.
var edits: Array[FuzzEdit] = []
## How long the world is looked at: from the start, or from the last edit where there are edits.
var seconds := 2.0


## A world that shares nothing with this one.
func copy() -> FuzzWorld:
	var made := FuzzWorld.new()
	for edit: FuzzEdit in edits:
		made.edits.append(edit.copy())
	made.walls.resize(walls.size())
	made.lines.resize(lines.size())
	made.balls.resize(balls.size())
	made.put_numbers(numbers())
	return made


## All numbers of the world in a fixed order, those of the edits included.
func numbers() -> PackedFloat64Array:
	var found: PackedFloat64Array = [seconds, gravity.x, gravity.y, bounciness, friction]
	for corner: Vec2 in walls:
		found.append_array([corner.x, corner.y])
	for line: LineSegment in lines:
		found.append_array(numbers_of_line(line))
	for ball: Ball in balls:
		found.append_array(numbers_of_ball(ball))
	for edit: FuzzEdit in edits:
		found.append(edit.time)
		found.append_array(edit.numbers)
	return found


## Takes other numbers, in the order of [method numbers].
func put_numbers(new_numbers: PackedFloat64Array) -> void:
	seconds = new_numbers[0]
	gravity = Vec2.new(new_numbers[1], new_numbers[2])
	bounciness = new_numbers[3]
	friction = new_numbers[4]
	var at := 5
	for corner: int in walls.size():
		walls[corner] = Vec2.new(new_numbers[at], new_numbers[at + 1])
		at += 2
	for place: int in lines.size():
		lines[place] = line_of(new_numbers.slice(at, at + _PER_LINE))
		at += _PER_LINE
	for index: int in balls.size():
		balls[index] = ball_of(new_numbers.slice(at, at + _PER_BALL))
		at += _PER_BALL
	for edit: FuzzEdit in edits:
		var size := edit.numbers.size()
		edit.time = new_numbers[at]
		edit.numbers = new_numbers.slice(at + 1, at + 1 + size)
		at += 1 + size


## "" if an event world takes all of this; else its refusal.
func problem() -> String:
	var made := EventWorld.new()
	var found := made.set_gravity(gravity)
	for refusal: String in [
		made.set_bounciness(bounciness),
		made.set_friction(friction),
		made.set_walls(walls[0], walls[1]) if walls else "",
		made.set_segments(lines),
		made.set_balls(balls),
		"" if seconds > 0.0 else "A world is looked at for more than 0 s, not %s." % seconds
	]:
		found = found if found else refusal
	for edit: FuzzEdit in edits:
		found = found if found else edit.problem()
	return found


## The event world at the start, before the edits.
func event_world(uses_grid: bool = true) -> WatchedWorld:
	var made := WatchedWorld.new()
	made.uses_grid = uses_grid
	Refusal.push(made.set_gravity(gravity))
	Refusal.push(made.set_bounciness(bounciness))
	Refusal.push(made.set_friction(friction))
	if walls:
		Refusal.push(made.set_walls(walls[0], walls[1]))
	Refusal.push(made.set_segments(lines))
	Refusal.push(made.set_balls(balls))
	return made


## The same, moved frame by frame. It has no walls, and its balls do not meet.
func stepped_world(mover: BallMover) -> SteppedWorld:
	var made := SteppedWorld.new(mover)
	Refusal.push(made.surroundings.set_gravity(gravity))
	Refusal.push(made.surroundings.set_bounciness(bounciness))
	Refusal.push(made.surroundings.set_segments(lines))
	Refusal.push(made.set_balls(balls))
	return made


## As a person can build it again: one thing a line, every number to its last bit.
func text() -> String:
	var parts: PackedStringArray = [
		"gravity %s, C = %s" % [list_text([gravity.x, gravity.y]), DecimalText.of(bounciness)]
	]
	if friction > 0.0:
		parts[0] += ", µ = %s" % DecimalText.of(friction)
	if walls:
		var low := list_text([walls[0].x, walls[0].y])
		parts.append("walls %s to %s" % [low, list_text([walls[1].x, walls[1].y])])
	for place: int in lines.size():
		parts.append("line %d: %s" % [place, line_text(numbers_of_line(lines[place]))])
	for index: int in balls.size():
		parts.append("ball %d: %s" % [index, ball_text(numbers_of_ball(balls[index]))])
	for edit: FuzzEdit in edits:
		parts.append(edit.text())
	parts.append("it goes on for %s s" % DecimalText.of(seconds))
	return "\n".join(parts)


## The link that opens it in the lesson on angled lines; "" where none can show it: the lesson has
## no walls and no friction, its balls do not meet, nothing changes it from outside, and its board
## ends somewhere.
func link(method: SteppingMethods.Method = SteppingMethods.Method.EVENT_WORLD) -> String:
	if walls or edits or friction > 0.0 or balls.size() != 1:
		return ""
	var ball := numbers_of_ball(balls[0])
	var in_play: PackedFloat64Array = [ball[0], ball[1], ball[3], ball[4]]
	var shown: Array[PackedFloat64Array] = [in_play + PackedFloat64Array([ball[2]])]
	var starts: Array[PackedFloat64Array] = [in_play]
	var linked_lines: Array[PackedFloat64Array] = []
	for line: LineSegment in lines:
		linked_lines.append(numbers_of_line(line))
	var linked := {
		"method": AngledLinesLink.METHODS[method],
		"bounciness": bounciness,
		"gravity": PackedFloat64Array([gravity.x, gravity.y]),
		"balls": shown,
		"starts": starts,
		"lines": linked_lines,
	}
	var whole := linked.merged({"scene": 0, "mistake": 0, "selected": 0, "endless": false})
	if AngledLinesLink.problem_in(whole):
		return ""
	# Against a base without values every one of them is named.
	var base := {}
	for name: String in linked:
		base[name] = ""
	return "angled_lines?" + LessonLink.text_of(linked, base)


## x and y of both ends.
static func numbers_of_line(line: LineSegment) -> PackedFloat64Array:
	return [line.start.x, line.start.y, line.end.x, line.end.y]


## The line of four such numbers.
static func line_of(ends: PackedFloat64Array) -> LineSegment:
	return LineSegment.new(Vec2.new(ends[0], ends[1]), Vec2.new(ends[2], ends[3]))


## Place, radius, velocity, mass and spin.
static func numbers_of_ball(ball: Ball) -> PackedFloat64Array:
	return [
		ball.position.x,
		ball.position.y,
		ball.radius,
		ball.velocity.x,
		ball.velocity.y,
		ball.mass,
		ball.spin,
	]


## The ball of seven such numbers.
static func ball_of(values: PackedFloat64Array) -> Ball:
	var at := Vec2.new(values[0], values[1])
	return Ball.new(at, values[2], Vec2.new(values[3], values[4]), values[5], values[6])


## Four numbers of a line as a text.
static func line_text(ends: PackedFloat64Array) -> String:
	return "%s to %s" % [list_text(ends.slice(0, 2)), list_text(ends.slice(2))]


## Seven numbers of a ball as a text.
static func ball_text(values: PackedFloat64Array) -> String:
	return (
		"at %s, r = %s, v = %s, m = %s, spin = %s"
		% [
			list_text(values.slice(0, 2)),
			DecimalText.of(values[2]),
			list_text(values.slice(3, 5)),
			DecimalText.of(values[5]),
			DecimalText.of(values[6])
		]
	)


## Numbers to the last bit, with commas.
static func list_text(values: PackedFloat64Array) -> String:
	return ", ".join(Array(values).map(DecimalText.of))
