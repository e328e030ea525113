class_name SteppingExercise
extends Exercise
## Asks what happens within one frame, with fresh whole numbers: which impact counts, what is left
## of the frame, when to reflect, how much gravity acts before the bounce.

## What is asked for.
enum Kind { EARLIEST, REST, MOVING_AWAY, GRAVITY }

# Five times unit normals with short decimals: from the triangle 3, 4, 5, and along the axes.
const _NORMALS: Array[Vector2i] = [
	Vector2i(3, 4), Vector2i(4, 3), Vector2i(-3, 4), Vector2i(4, -3), Vector2i(0, 5), Vector2i(5, 0)
]

const _RADIUS := 12.0
const _HALF_LINE := 90.0

## The world that the question is about, to be shown on the board.
var world := SteppedWorld.new(WholeFrameMover.new())

var _solution := ""


## A question with numbers drawn from [param rng].
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> SteppingExercise:
	var exercise := new()
	match kind:
		Kind.EARLIEST:
			exercise._ask_earliest(rng)
		Kind.REST:
			exercise._ask_rest(rng)
		Kind.MOVING_AWAY:
			exercise._ask_moving_away(rng)
		Kind.GRAVITY:
			exercise._ask_gravity(rng)
	return exercise


func solution() -> String:
	return _solution


func _ask_earliest(rng: RandomNumberGenerator) -> void:
	# Not at the origin: there, to forget the old position would make no difference.
	var old := Vec2.new(rng.randi_range(1, 9) * 10, rng.randi_range(-9, 9) * 10)
	old.x *= [-1.0, 1.0][rng.randi_range(0, 1)]
	var motion := Vec2.new(rng.randi_range(4, 16) * 8, -rng.randi_range(4, 9) * 8)
	var first := old.plus(motion.scaled(0.25))
	var last := old.plus(motion.scaled(0.75))
	prompt = (
		(
			tr("A ball at %s moves by %s in this frame. Line A is touched at t = 0.25, ")
			+ tr("line B at t = 0.75. Where is the point of impact?")
		)
		% [_text(old), _text(motion)]
	)
	_show(Ball.new(old, _RADIUS, motion.scaled(60.0)), [first, last], motion.normalized().negated())
	answer_titles = ["x =", "y ="]
	right_answer = [first.x, first.y]
	_solution = (
		tr("Line A is touched first: the old position + 0.25 of the motion = %s + 0.25 %s = %s.")
		% [_text(old), _text(motion), _text(first)]
	)
	_add_vector(
		last, tr("That is the last hit. The ball bounces off the line that it touches first.")
	)
	_add_vector(old.plus(motion), tr("That is the end of the frame: the ball has passed the line."))
	_add_vector(
		motion.scaled(0.25), tr("That is only the way to the impact: add the old position.")
	)


func _ask_rest(rng: RandomNumberGenerator) -> void:
	var speed := rng.randi_range(1, 9) * 10.0
	var tenths := rng.randi_range(1, 9)
	var share := tenths / 10.0
	prompt = (
		(
			tr(
				"A ball moves down by %s px a frame and touches the floor at t = %s. No gravity, C = 1. "
			)
			+ tr("How many px above the contact is it when the frame ends?")
		)
		% [NumberText.short(speed), NumberText.short(share)]
	)
	var start := Vec2.new(0.0, -share * speed)
	_show(Ball.new(start, _RADIUS, Vec2.new(0.0, 60.0 * speed)), [Vec2.new()], Vec2.new(0.0, -1.0))
	answer_titles = ["d ="]
	right_answer = [(1.0 - share) * speed]
	_solution = (
		tr("1 − t = %s of the frame is left, and the ball goes up: %s · %s = %s px.")
		% _texts([1.0 - share, 1.0 - share, speed, right_answer[0]])
	)
	add_mistake([0.0], tr("The rest of the frame was dropped: (1 − t) of it is still to be used."))
	# Up or down may be positive for the student.
	add_mistake_of_either_sign(
		[share * speed], tr("That is the way before the bounce; after it 1 − t is left.")
	)
	add_mistake_of_either_sign(
		[speed], tr("That is the way of a whole frame; a part of it was made before the touch.")
	)
	add_mistake(
		[-right_answer[0]],
		tr("That is its y, which points down. Px above the contact count as positive.")
	)


func _ask_moving_away(rng: RandomNumberGenerator) -> void:
	var triple := _NORMALS[rng.randi_range(0, _NORMALS.size() - 1)]
	var normal := Vec2.new(triple.x / 5.0, triple.y / 5.0)
	var velocity := Vec2.zero()
	while absf(velocity.dot(normal)) < 0.5:
		velocity.set_xy(rng.randi_range(-5, 5) * 5.0, rng.randi_range(-5, 5) * 5.0)
	var reflected := velocity.reflected(normal)
	prompt = (
		(
			tr(
				"A ball overlaps a line by 1 px. Its velocity is v = %s, the normal towards it n̂ = %s, "
			)
			+ tr("C = 1. What is its velocity after this frame's check?")
		)
		% [_text(velocity), _text(normal)]
	)
	_show(Ball.new(normal.negated(), _RADIUS, velocity), [Vec2.new()], normal)
	answer_titles = ["x =", "y ="]
	var along := [NumberText.short(velocity.dot(normal)), _text(velocity)]
	if Bounce.is_approaching(velocity, normal):
		right_answer = [reflected.x, reflected.y]
		along.append(_text(reflected))
		_solution = tr("v · n̂ = %s is negative: reflect %s, which gives %s.") % along
		_add_vector(velocity, tr("v · n̂ is negative: the ball approaches and must be reflected."))
		_add_vector(
			velocity.rejection(normal), tr("Subtracted once: that is C = 0. Twice for C = 1.")
		)
		_add_vector(
			velocity.plus(velocity.minus(reflected)),
			tr("The sign is wrong: subtract 2 (v · n̂) n̂ from v.")
		)
	else:
		right_answer = [velocity.x, velocity.y]
		_solution = tr("v · n̂ = %s is positive: the ball moves away, so v stays %s.") % along
		_add_vector(
			reflected,
			tr("v · n̂ is positive: it moves away already. Reflected once more, it sticks.")
		)


func _ask_gravity(rng: RandomNumberGenerator) -> void:
	var speed := rng.randi_range(20, 40) * 10.0
	var gravity := rng.randi_range(1, 2) * 5.0
	var tenths := rng.randi_range(1, 4)
	var before := speed + gravity * tenths / 5.0
	prompt = (
		(
			tr("A ball falls with %s px/s. A whole frame of gravity would add %s px/s. ")
			+ tr("It touches the floor at t = %s. How fast is it just before the bounce?")
		)
		% [NumberText.short(speed), NumberText.short(gravity), NumberText.short(tenths / 5.0)]
	)
	var way := (speed + gravity / 2.0) / 60.0
	var start := Vec2.new(0.0, -way * tenths / 5.0)
	_show(Ball.new(start, _RADIUS, Vec2.new(0.0, speed)), [Vec2.new()], Vec2.new(0.0, -1.0))
	Refusal.push(world.surroundings.set_gravity(Vec2.new(0.0, 60.0 * gravity)))
	answer_titles = ["v ="]
	right_answer = [before]
	_solution = (
		tr("Gravity has acted for t = %s of the frame: %s + %s · %s = %s px/s.")
		% _texts([tenths / 5.0, speed, tenths / 5.0, gravity, before])
	)
	add_mistake_of_either_sign(
		[speed + gravity],
		tr("That is the gravity of the whole frame: only the share t of it has acted.")
	)
	add_mistake_of_either_sign([speed], tr("Gravity acts, too: for the share t of the frame."))
	add_mistake_of_either_sign(
		[before - 2.0 * gravity * tenths / 5.0],
		tr("The sign is wrong: the ball falls, so gravity makes it faster.")
	)
	add_mistake(
		[-before],
		tr("A speed is never below 0. With y down, that is the velocity after the bounce.")
	)


# Puts up the ball, and lines with this normal which it touches when its centre is at `contacts`.
func _show(ball: Ball, contacts: Array[Vec2], normal: Vec2) -> void:
	var lines: Array[LineSegment] = []
	var half := normal.normal().scaled(_HALF_LINE)
	for contact in contacts:
		var foot := contact.minus(normal.scaled(_RADIUS))
		lines.append(LineSegment.new(foot.minus(half), foot.plus(half)))
	Refusal.push(world.surroundings.set_segments(lines))
	Refusal.push(world.set_balls([ball]))


func _add_vector(answer: Vec2, sentence: String) -> void:
	add_mistake([answer.x, answer.y], sentence)


static func _text(vector: Vec2) -> String:
	return NumberText.pair(vector.x, vector.y)


static func _texts(numbers: PackedFloat64Array) -> Array[String]:
	var texts: Array[String] = []
	for number in numbers:
		texts.append(NumberText.short(number))
	return texts
