class_name FuzzEdit
extends RefCounted
## One change of a world from outside, at a time. A change of what is not there is refused by the
## world, and then nothing has changed.

## What is changed.
enum Kind {
	ADD_LINE,
	MOVE_LINE,
	REMOVE_LINE,
	ADD_BALL,
	CHANGE_BALL,
	REMOVE_BALL,
	GRAVITY,
	BOUNCINESS,
	WALLS,
	NO_WALLS,
	FRICTION,
	STEADY_LINE,
	LINE_TO_AND_FRO,
	TURNING_LINE,
	BELT
}

## What it is.
var kind: Kind
## When, in seconds of the world; at once where that is over.
var time := 0.0
## Whether it waits for the next event after [member time], and happens exactly then.
var is_at_event := false
## Which line or ball is moved, changed or removed.
var place := 0
## A line: its ends. A new ball: place, radius, velocity, mass and spin. A changed ball: how far it
## is moved, by what its radius is multiplied, how its velocity is changed. Gravity, C, µ, or both
## corners of the walls. A line's velocity; its way and the seconds there and back; its pivot, turn
## and the pivot's velocity; the speed of its belt.
var numbers: PackedFloat64Array = []


## An edit of this kind.
static func of(
	with_kind: Kind, at: float, with_numbers: PackedFloat64Array = [], with_place: int = 0
) -> FuzzEdit:
	var made := FuzzEdit.new()
	made.kind = with_kind
	made.time = at
	made.numbers = with_numbers
	made.place = with_place
	return made


## An edit that shares nothing with this one.
func copy() -> FuzzEdit:
	var made := FuzzEdit.of(kind, time, numbers.duplicate(), place)
	made.is_at_event = is_at_event
	return made


## Whether its place is that of a line.
func names_line() -> bool:
	return kind == Kind.MOVE_LINE or kind == Kind.REMOVE_LINE or kind >= Kind.STEADY_LINE


## Whether its place is that of a ball.
func names_ball() -> bool:
	return kind == Kind.CHANGE_BALL or kind == Kind.REMOVE_BALL


## "" if its numbers can be used, else why not.
func problem() -> String:
	var found := ""
	match kind:
		Kind.ADD_LINE, Kind.MOVE_LINE:
			found = FuzzWorld.line_of(numbers).problem(FuzzWorld.LARGEST)
		Kind.ADD_BALL:
			found = FuzzWorld.ball_of(numbers).problem(FuzzWorld.LARGEST)
		Kind.CHANGE_BALL when not numbers[2] > 0.0:
			found = "A radius is multiplied by more than 0."
		Kind.BOUNCINESS:
			found = Bounce.problem_of_bounciness(numbers[0])
		Kind.WALLS:
			found = WorldLimits.problem_of_walls(_vector(0), _vector(2))
		Kind.FRICTION:
			found = Friction.problem_of(numbers[0], WorldLimits.MOST_FRICTION)
		Kind.STEADY_LINE, Kind.LINE_TO_AND_FRO, Kind.TURNING_LINE:
			found = motion().problem(FuzzWorld.LARGEST)
	return found


## The motion of a line that begins to move.
func motion() -> SegmentMotion:
	match kind:
		Kind.LINE_TO_AND_FRO:
			var times: PackedFloat64Array = [0.0, numbers[2], numbers[2] + numbers[3]]
			return SegmentMotion.along(times, [Vec2.zero(), _vector(0), Vec2.zero()], true)
		Kind.TURNING_LINE:
			return SegmentMotion.turning(_vector(0), numbers[2], _vector(3))
	return SegmentMotion.steady(_vector(0))


## Changes an event world now; "" or the refusal.
func apply(world: EventWorld) -> String:
	var refusal := ""
	match kind:
		Kind.ADD_LINE:
			refusal = world.add_segment(FuzzWorld.line_of(numbers))
		Kind.MOVE_LINE:
			refusal = world.move_segment(place, FuzzWorld.line_of(numbers))
		Kind.REMOVE_LINE:
			refusal = world.remove_segment(place)
		Kind.ADD_BALL:
			refusal = world.add_ball(FuzzWorld.ball_of(numbers))
		Kind.CHANGE_BALL:
			refusal = WorldLimits.problem_of_place(place, world.has_ball(place), "ball")
			if not refusal:
				refusal = world.change_ball(place, _changed(world.ball(place)))
		Kind.REMOVE_BALL:
			refusal = world.remove_ball(place)
		Kind.GRAVITY:
			refusal = world.set_gravity(_vector(0))
		Kind.BOUNCINESS:
			refusal = world.set_bounciness(numbers[0])
		Kind.WALLS:
			refusal = world.set_walls(_vector(0), _vector(2))
		Kind.NO_WALLS:
			world.remove_walls()
		Kind.FRICTION:
			refusal = world.set_friction(numbers[0])
		Kind.STEADY_LINE, Kind.LINE_TO_AND_FRO, Kind.TURNING_LINE:
			refusal = world.set_segment_motion(place, motion())
		Kind.BELT:
			refusal = world.set_belt_speed(place, numbers[0])
	return refusal


## Changes a world of one ball that is moved frame by frame; "" or the refusal. A line leaves no
## empty place there, and the ball keeps its radius. What such a world does not have, more balls and
## walls, is refused.
func apply_stepped(world: SteppedWorld) -> String:
	var lines := world.surroundings.segments.duplicate()
	match kind:
		Kind.ADD_LINE:
			lines.append(FuzzWorld.line_of(numbers))
		Kind.MOVE_LINE when place < lines.size():
			lines[place] = FuzzWorld.line_of(numbers)
		Kind.REMOVE_LINE when place < lines.size():
			lines.remove_at(place)
		Kind.CHANGE_BALL:
			var changed := _changed(world.balls[0].copy())
			return world.change_ball(0, changed.position, changed.velocity)
		Kind.GRAVITY:
			return world.surroundings.set_gravity(_vector(0))
		Kind.BOUNCINESS:
			return world.surroundings.set_bounciness(numbers[0])
		_:
			return "A world that is moved frame by frame does not have this."
	return world.surroundings.set_segments(lines)


## As a person can repeat it.
func text() -> String:
	var when := "at the next event after" if is_at_event else "at"
	return "%s %s s %s" % [when, DecimalText.of(time), _what()]


func _what() -> String:
	match kind:
		Kind.ADD_LINE, Kind.MOVE_LINE, Kind.WALLS:
			return "%s: %s" % [_name(), FuzzWorld.line_text(numbers)]
		Kind.ADD_BALL:
			return "%s: %s" % [_name(), FuzzWorld.ball_text(numbers)]
		Kind.CHANGE_BALL:
			var parts := [
				_name(),
				FuzzWorld.list_text(numbers.slice(0, 2)),
				DecimalText.of(numbers[2]),
				FuzzWorld.list_text(numbers.slice(3))
			]
			return "%s: moved by %s, radius times %s, velocity plus %s" % parts
		Kind.NO_WALLS, Kind.REMOVE_LINE, Kind.REMOVE_BALL:
			return _name()
		_:
			return "%s: %s" % [_name(), FuzzWorld.list_text(numbers)]


# Such as "move line 2".
func _name() -> String:
	var words: String = str(Kind.keys()[kind]).to_lower().replace("_", " ")
	return "%s %d" % [words, place] if names_line() or names_ball() else words


func _changed(ball: Ball) -> Ball:
	ball.position.add(_vector(0))
	ball.radius *= numbers[2]
	ball.velocity.add(_vector(3))
	return ball


func _vector(at: int) -> Vec2:
	return Vec2.new(numbers[at], numbers[at + 1])
