class_name BallisticAimExercise
extends Exercise
## Asks for an aim under gravity, a time of flight, or the least speed, with fresh numbers.
##
## Shots are made first, along a Pythagorean triple, and the target lies where they come to: so all
## answers are short.

## What is asked for: the direction to a target at rest, the time of a flight back to the level, the
## least speed, or the direction to a target that falls.
enum Kind { AIM, TIME, LEAST, FALLING }

## Directions of shots, of length 5: the second component points up.
const _DIRECTIONS: Array[Vector2i] = [Vector2i(4, -3), Vector2i(3, -4)]
const _SPEEDS: Array[int] = [100, 150, 200, 250, 300]
const _GRAVITIES: Array[int] = [100, 200, 300, 400]
const _TIMES: Array[float] = [0.5, 1.0, 2.0]
## Targets at a distance of 100, each with values of gravity whose least speed is whole.
const _LEAST: Dictionary[Vector2i, Array] = {
	Vector2i(80, -60): [40, 90, 250, 360],
	Vector2i(60, -80): [80, 180, 320],
	Vector2i(80, 60): [90, 250, 360],
	Vector2i(60, 80): [80, 180, 320],
}
const _FALLING: Array[Vector2i] = [
	Vector2i(40, -30), Vector2i(120, -90), Vector2i(30, -40), Vector2i(90, -120)
]
const _FALLING_SPEED := 250.0

## The target, seen from the shooter.
var target: Vec2
## The bullet's speed in px/s, and gravity in px/s².
var speed: float
var gravity: float

var _kind: Kind
# Of the shot that hits: its direction, its time, and whether it is the high arc.
var _direction: Vec2
var _time: float
var _is_high := false


## A question on a shot in [param direction], of length 1, that flies [param seconds].
static func of_shot(
	kind: Kind, direction: Vec2, with_speed: float, with_gravity: float, seconds: float
) -> BallisticAimExercise:
	var exercise: BallisticAimExercise = new()
	exercise._kind = kind
	exercise.speed = with_speed
	exercise.gravity = with_gravity
	exercise._direction = direction
	exercise._time = seconds
	var fall := Vec2.new(0.0, 0.5 * with_gravity * seconds * seconds)
	exercise.target = direction.scaled(with_speed * seconds).plus(fall)
	# The times of both arcs multiply to 2 |P| / g.
	exercise._is_high = seconds * seconds > 2.0 * exercise.target.length() / with_gravity
	if kind == Kind.AIM:
		exercise._ask_aim()
	else:
		exercise._ask_time()
	return exercise


## A question on the least speed to a target, or on one that falls.
static func of_target(
	kind: Kind, at: Vec2, with_speed: float, with_gravity: float
) -> BallisticAimExercise:
	var exercise: BallisticAimExercise = new()
	exercise._kind = kind
	exercise.target = at
	exercise.speed = with_speed
	exercise.gravity = with_gravity
	if kind == Kind.LEAST:
		exercise._ask_least()
	else:
		exercise._ask_falling()
	return exercise


## A question with numbers drawn from [param rng].
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> BallisticAimExercise:
	var triple := _DIRECTIONS[rng.randi_range(0, _DIRECTIONS.size() - 1)]
	var direction := Vec2.new(triple.x / 5.0, triple.y / 5.0)
	var with_speed: float = _SPEEDS[rng.randi_range(0, _SPEEDS.size() - 1)]
	var with_gravity: float = _GRAVITIES[rng.randi_range(0, _GRAVITIES.size() - 1)]
	match kind:
		Kind.AIM:
			var seconds := _TIMES[rng.randi_range(0, _TIMES.size() - 1)]
			return of_shot(kind, direction, with_speed, with_gravity, seconds)
		Kind.TIME:
			var seconds := -2.0 * with_speed * direction.y / with_gravity
			return of_shot(kind, direction, with_speed, with_gravity, seconds)
		Kind.LEAST:
			var place: Vector2i = _LEAST.keys()[rng.randi_range(0, _LEAST.size() - 1)]
			var pulls: Array = _LEAST[place]
			with_gravity = pulls[rng.randi_range(0, pulls.size() - 1)]
			return of_target(kind, Vec2.new(place.x, place.y), with_speed, with_gravity)
	var falling := _FALLING[rng.randi_range(0, _FALLING.size() - 1)]
	return of_target(kind, Vec2.new(falling.x, falling.y), _FALLING_SPEED, with_gravity)


func solution() -> String:
	match _kind:
		Kind.AIM:
			return (
				"t = %s, d = (P − (0, g t² / 2)) / (s t) = %s"
				% [NumberText.short(_time), text_of(right_answer)]
			)
		Kind.TIME:
			return "t = −2 s d.y / g = %s" % text_of(right_answer)
		Kind.LEAST:
			return "s₀ = √(g (|P| − P.y)) = %s" % text_of(right_answer)
	return "d = P / |P| = %s" % text_of(right_answer)


## The shot of the question.
func board_state() -> Dictionary:
	var is_least := _kind == Kind.LEAST
	return {
		"target": PackedFloat64Array([target.x, target.y]),
		"speed": right_answer[0] if is_least else speed,
		"gravity": gravity,
		"moves": false,
		"falls": _kind == Kind.FALLING,
		"arc": 1 if _is_high else 0,
	}


func _ask_aim() -> void:
	var question := tr("P = %s, s = %s, g = %s. Which direction d hits on the flat arc?")
	if _is_high:
		question = tr("P = %s, s = %s, g = %s. Which direction d hits on the high arc?")
	prompt = question % [_text(target), NumberText.short(speed), NumberText.short(gravity)]
	answer_titles = ["x =", "y ="]
	right_answer = [_direction.x, _direction.y]
	var place := 1 if _is_high else 0
	var pull := Vec2.new(0.0, gravity)
	_add_aims(pull, 1 - place, tr("That is the other arc. It hits, too, but at another time."))
	_add_aims(
		pull.negated(),
		place,
		tr("The fall was added to P. Take it away: y points down, so aim up.")
	)
	_add_aims(pull.scaled(2.0), place, tr("The fall is g t² / 2: one half was forgotten."))
	_add(
		target.normalized(), tr("Aimed straight at it: gravity pulls the bullet below the target.")
	)


func _ask_time() -> void:
	var question := tr(
		"A bullet leaves with s = %s in the direction d = %s, g = %s. When is it back on the level?"
	)
	prompt = question % [NumberText.short(speed), _text(_direction), NumberText.short(gravity)]
	answer_titles = ["t ="]
	right_answer = [_time]
	add_mistake(
		[BallisticAimMistakes.halved_time(_time)],
		tr("Then it is at the top. With g t² in place of g t² / 2 the time comes out so, too.")
	)
	add_mistake(
		[2.0 * speed / gravity], tr("Only the part of the speed that points up counts: s d.y.")
	)
	add_mistake([2.0 * speed * absf(_direction.x) / gravity], tr("That is d.x. Up is d.y."))


func _ask_least() -> void:
	var question := tr("P = %s, g = %s. Which speed s₀ reaches P at least?")
	prompt = question % [_text(target), NumberText.short(gravity)]
	answer_titles = ["s₀ ="]
	var length := target.length()
	var square := gravity * (length - target.y)
	right_answer = [sqrt(square)]
	add_mistake([square], tr("That is s₀²: the root is missing."))
	add_mistake(
		[sqrt(gravity * (length + target.y))],
		tr("y points down: a target above has a y below 0, and needs more.")
	)
	add_mistake([sqrt(gravity * length)], tr("That is for a target on the level: P.y is missing."))
	add_mistake([sqrt(length - target.y)], tr("g is missing."))
	if target.y < 0.0:
		add_mistake(
			[sqrt(-2.0 * gravity * target.y)],
			tr("That speed gets as high as the target, but straight up.")
		)


func _ask_falling() -> void:
	var question := tr(
		"P = %s, s = %s, g = %s. The target starts to fall when you fire. Which direction d hits?"
	)
	prompt = question % [_text(target), NumberText.short(speed), NumberText.short(gravity)]
	answer_titles = ["x =", "y ="]
	var towards := target.normalized()
	right_answer = [towards.x, towards.y]
	var too_high := tr("That hits a target that rests. This one falls as the bullet does.")
	var pull := Vec2.new(0.0, gravity)
	for place: int in 2:
		_add_aims(pull, place, too_high)
	_add(Vec2.new(towards.x, -towards.y), tr("y points down: up is below 0."))


# The aim in this place that hits a target at rest, where there is one.
func _add_aims(pull: Vec2, place: int, sentence: String) -> void:
	var aims := BallisticAim.at_fixed(Vec2.zero(), target, pull, speed)
	if place < aims.size():
		_add(aims[place].direction, sentence)


func _add(answer: Vec2, sentence: String) -> void:
	add_mistake([answer.x, answer.y], sentence)


static func _text(vector: Vec2) -> String:
	return NumberText.pair(vector.x, vector.y)
