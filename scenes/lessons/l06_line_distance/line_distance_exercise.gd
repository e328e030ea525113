class_name LineDistanceExercise
extends Exercise
## Asks for the signed distance of a point from a line, or for the gap of a ball, with fresh whole
## numbers.
##
## The line runs along a multiple of a Pythagorean triple, so that its length is whole and answers
## are short.

## What is asked for: the distance, the gap, or the first frame in which a ball overlaps.
enum Kind { DISTANCE, GAP, FRAME }

const _TRIPLES: Array[Vector2i] = [Vector2i(3, 4), Vector2i(4, 3), Vector2i(6, 8), Vector2i(8, 6)]

## The line from which the distance is asked for.
var line: LineSegment
## The ball; only its gap needs its radius.
var ball: Ball
## How far it moves in a frame, straight at the line; used by [constant Kind.FRAME].
var speed := 0.0

var _kind: Kind


## A question on [param its_line] and [param its_ball].
func _init(kind: Kind, its_line: LineSegment, its_ball: Ball, its_speed: float = 0.0) -> void:
	_kind = kind
	line = its_line
	ball = its_ball
	speed = its_speed
	match kind:
		Kind.DISTANCE:
			_ask_distance()
		Kind.GAP:
			_ask_gap()
		Kind.FRAME:
			_ask_frame()


## A question with numbers drawn from [param rng]; the ball's centre is never on the line. Two
## mistakes may have the same answer: [method Exercise.drawn] draws again.
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> LineDistanceExercise:
	var triple := _TRIPLES[rng.randi_range(0, _TRIPLES.size() - 1)]
	var along := Vec2.new(triple.x * _random_sign(rng), triple.y * _random_sign(rng))
	var from := Vec2.new(rng.randi_range(-5, 5), rng.randi_range(-5, 5))
	var asked := LineSegment.new(from, from.plus(along))
	if kind == Kind.FRAME:
		return _fresh_flight(asked, rng)
	var centre := from.plus(Vec2.new(rng.randi_range(-9, 9), rng.randi_range(-9, 9)))
	if along.cross(centre.minus(from)) == 0.0:
		centre.add(Vec2.new(1.0, 0.0))
	return new(kind, asked, Ball.new(centre, rng.randi_range(1, 4)))


# The centre is a few lengths of the line away, on its good side.
static func _fresh_flight(asked: LineSegment, rng: RandomNumberGenerator) -> LineDistanceExercise:
	var across := Vec2.new(-asked.along().y, asked.along().x)
	var centre := asked.start.plus(across.scaled(rng.randi_range(3, 6)))
	return new(Kind.FRAME, asked, Ball.new(centre, rng.randi_range(2, 5)), rng.randi_range(3, 9))


func solution() -> String:
	var distance := NumberText.short(LineDistance.signed_distance(ball.position, line))
	var radius := NumberText.short(ball.radius)
	var right := text_of(right_answer)
	match _kind:
		Kind.GAP:
			return "d · n̂ − r = %s − %s = %s" % [distance, radius, right]
		Kind.FRAME:
			var sentence := tr(
				"The gap is %s − %s px: with %s px a frame it is used up in frame %s."
			)
			return sentence % [distance, radius, NumberText.short(speed), right]
	var difference := _pair(LineDistance.difference(ball.position, line))
	return "d · n̂ = %s · %s = %s" % [difference, _pair(line.normal()), right]


## The line and the ball of the question, with p at the start of the line.
func board_state() -> Dictionary:
	return {
		"line": PackedFloat64Array([line.start.x, line.start.y, line.end.x, line.end.y]),
		"ball": PackedFloat64Array([ball.position.x, ball.position.y, ball.radius]),
		"from_share": 0.0,
	}


static func _random_sign(rng: RandomNumberGenerator) -> int:
	return 1 if rng.randi_range(0, 1) == 1 else -1


func _ask_distance() -> void:
	var sentence := tr("A line leads from %s to %s. What is the signed distance of c = %s from it?")
	prompt = sentence % [_pair(line.start), _pair(line.end), _pair(ball.position)]
	answer_titles = ["d · n̂ ="]
	_add_mistakes(LineDistance.signed_distance(ball.position, line), 0.0)


func _ask_frame() -> void:
	var sentence := tr(
		"A ball at c = %s with radius %s flies straight at a wall from %s to %s, %s px a frame. "
	)
	var numbers := [_pair(ball.position), NumberText.short(ball.radius)]
	numbers += [_pair(line.start), _pair(line.end), NumberText.short(speed)]
	prompt = sentence % numbers
	prompt += tr("It is at c in frame 0. In which frame does detection first see it overlap?")
	answer_titles = [tr("frame")]
	# A whole number: nothing is left of its rounding.
	var distance := roundf(LineDistance.signed_distance(ball.position, line))
	var gap := distance - ball.radius
	var last_free := floorf(gap / speed)
	right_answer = [last_free + 1.0]
	_add(last_free, tr("In that frame it does not overlap yet."))
	_add(gap / speed, tr("Detection looks in whole frames only: round up."))
	var of_centre := floorf(distance / speed) + 1.0
	if of_centre != right_answer[0]:
		_add(of_centre, tr("That is the frame of the centre: the radius is not subtracted."))


func _ask_gap() -> void:
	var sentence := tr(
		"A line leads from %s to %s. A ball at c = %s has radius %s. What is its gap?"
	)
	var radius := NumberText.short(ball.radius)
	prompt = sentence % [_pair(line.start), _pair(line.end), _pair(ball.position), radius]
	answer_titles = [tr("gap =")]
	_add_mistakes(LineDistance.gap(ball, line), ball.radius)
	var distance := LineDistance.signed_distance(ball.position, line)
	_add(distance, tr("The radius is not subtracted yet."))
	_add(
		distance + ball.radius,
		tr("The radius is subtracted, not added: the rim is nearer than the centre.")
	)
	if right_answer[0] < 0.0:
		_add(-right_answer[0], tr("A gap below 0 keeps its sign: the ball is too close or behind."))


func _add_mistakes(right: float, less: float) -> void:
	right_answer = [right]
	var distance := right + less
	var to_ball := LineDistance.difference(ball.position, line)
	var too_big := tr("The normal is not unit: that is %s times the distance.")
	var not_unit := _wrong(LineDistanceMistakes.NOT_UNIT)
	_add(-distance - less, tr("The sign is wrong: n̂ is (−y, x), not (y, −x)."))
	_add(not_unit - less, too_big % NumberText.short(line.length()))
	_add(-not_unit - less, tr("The normal is not unit, and the sign is wrong."))
	_add_with_both_signs(
		_wrong(LineDistanceMistakes.STRAIGHT_UP),
		less,
		tr("That is the vertical way, not the perpendicular.")
	)
	_add_with_both_signs(
		to_ball.scalar_projection(line.along()), less, tr("That is along the line, not along n̂.")
	)
	_add_with_both_signs(
		to_ball.length(), less, tr("That is |d|: the way to the start, not to the line.")
	)


func _wrong(mistake: int) -> float:
	return LineDistanceMistakes.distance(mistake, ball.position, line)


# A way that is not the perpendicular has no sign of its own: students give it either one.
func _add_with_both_signs(distance: float, less: float, sentence: String) -> void:
	_add(distance - less, sentence)
	_add(-distance - less, sentence)


func _add(answer: float, sentence: String) -> void:
	add_mistake([answer], sentence)


static func _pair(point: Vec2) -> String:
	return NumberText.pair(point.x, point.y)
