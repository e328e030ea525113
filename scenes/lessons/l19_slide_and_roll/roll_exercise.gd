class_name RollExercise
extends Exercise
## Asks when a ball rolls down a slope, how fast it gets, and what becomes of one that is pushed
## along a level line.

## What is asked for.
enum Kind { MARK, ACCELERATION, TIME, LEVEL_SPEED, LEVEL_TIME }

# w, h and length of slopes whose numbers are short.
const _SLOPES: Array[Vector3i] = [
	Vector3i(4, 3, 5),
	Vector3i(3, 4, 5),
	Vector3i(12, 5, 13),
	Vector3i(15, 8, 17),
	Vector3i(24, 7, 25)
]
const _FRICTIONS: PackedFloat64Array = [0.1, 0.2, 0.25, 0.4, 0.5]

## From the start of the line to its end, in pixels.
var along: Vec2
## Gravity, in px/s².
var gravity: float
## The friction µ.
var friction: float
## The speed at the start, in px/s.
var speed: float

var _incline: Incline


## A question with these numbers.
func _init(
	kind: Kind, its_along: Vec2, its_gravity: float, its_friction: float, its_speed: float
) -> void:
	along = its_along
	gravity = its_gravity
	friction = its_friction
	speed = its_speed
	var line := LineSegment.new(Vec2.zero(), along)
	_incline = Incline.new(line, Vec2.new(0.0, gravity), friction)
	match kind:
		Kind.MARK:
			_ask_mark()
		Kind.ACCELERATION:
			_ask_acceleration()
		Kind.TIME:
			_ask_time()
		Kind.LEVEL_SPEED:
			_ask_level_speed()
		Kind.LEVEL_TIME:
			_ask_level_time()


## A question with numbers drawn from [param rng].
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> RollExercise:
	if kind >= Kind.LEVEL_SPEED:
		var its_speed := 60.0 * rng.randi_range(2, 7)
		var its_friction: float = _FRICTIONS[rng.randi_range(0, 3)]
		return new(kind, Vec2.new(960.0, 0.0), 600.0, its_friction, its_speed)
	var slope := _SLOPES[rng.randi_range(0, _SLOPES.size() - 1)]
	# Steep enough slopes slip, the others roll.
	var its_along := Vec2.new(slope.x, slope.y).scaled(120.0 / slope.z)
	var its_gravity := 10.0 * slope.z * rng.randi_range(6, 12)
	var drawn_friction: float = _FRICTIONS[rng.randi_range(0, _FRICTIONS.size() - 1)]
	return new(kind, its_along, its_gravity, drawn_friction, 0.0)


## The question with the numbers of the lesson's start.
static func of_the_lecture(kind: Kind) -> RollExercise:
	if kind >= Kind.LEVEL_SPEED:
		return new(kind, Vec2.new(375.0, 0.0), 600.0, 0.2, 300.0)
	return new(kind, Vec2.new(96.0, 72.0), 600.0, 0.4, 0.0)


## The line, as far to both sides of the middle of the board.
func board_state() -> Dictionary:
	return {
		"start": [-0.5 * along.x, -0.5 * along.y],
		"end": [0.5 * along.x, 0.5 * along.y],
		"friction": friction,
		"speed": speed,
		"gravity": gravity,
	}


func _ask_mark() -> void:
	var sentence := tr("A slope falls by h = %s on w = %s. From which µ on can a disc roll on it?")
	prompt = sentence % [NumberText.short(along.y), NumberText.short(along.x)]
	answer_titles = ["µ ="]
	var slope := along.y / along.x
	right_answer = [slope / 3.0]
	add_mistake(
		[slope], tr("That is tan: a block begins to slide there. A disc needs a third of it.")
	)
	add_mistake([slope / 2.0], tr("That is the mark of a ring. A disc has tan / 3."))
	add_mistake([slope / 3.5], tr("That is the mark of a solid sphere. A disc has tan / 3."))
	add_mistake([1.0 / slope / 3.0], tr("Upside down: tan is h / w."))
	add_mistake([along.y / along.length() / 3.0], tr("That is a third of the sine: take h / w."))


func _ask_acceleration() -> void:
	prompt = _given() + " " + tr("It starts from rest. What is its acceleration, in px/s²?")
	answer_titles = ["a ="]
	right_answer = [_acceleration()]
	_add_accelerations(func(acceleration: float) -> float: return acceleration)


func _ask_time() -> void:
	var sentence := tr("It starts from rest. After how many seconds has it come %s px far?")
	prompt = _given() + " " + sentence % NumberText.short(along.length())
	answer_titles = ["t ="]
	right_answer = [_time_with(_acceleration())]
	_add_accelerations(_time_with)
	add_mistake([sqrt(along.length() / _acceleration())], tr("The 2 is missing: t = √(2 L / a)."))
	add_mistake([2.0 * along.length() / _acceleration()], tr("That is t²: take the root."))


func _add_accelerations(answer: Callable) -> void:
	var pull := _incline.pull
	var grip := friction * _incline.pressure
	var wrong: Dictionary[String, float] = {
		tr("That is without friction: nothing would turn the ball."): pull,
	}
	if _incline.can_hold():
		wrong[tr("5/7 is for a solid sphere. A disc has 2/3.")] = pull * 5.0 / 7.0
		if pull > grip:
			wrong[tr("It does not slip: from tan / 3 on friction is G / 3, not µ N.")] = pull - grip
		wrong[tr("That is the third that turns the ball. Two thirds move it.")] = pull / 3.0
	else:
		wrong[tr("It does not roll: µ is below tan / 3, so it slips.")] = pull * 2.0 / 3.0
		wrong[tr("Friction is µ N, and N is g w / L, not g.")] = pull - friction * gravity
	for sentence in wrong:
		if wrong[sentence] > 0.0:
			add_mistake([answer.call(wrong[sentence])], sentence)


func _ask_level_speed() -> void:
	prompt = _given_level() + " " + tr("At which speed does it roll in the end, in px/s?")
	answer_titles = ["v ="]
	right_answer = [speed * 2.0 / 3.0]
	add_mistake([0.0], tr("It does not stop: when nothing slips, there is no friction any more."))
	add_mistake([speed / 3.0], tr("A third of v₀ is what it loses."))
	add_mistake([speed / 2.0], tr("That is what a ring keeps. A disc keeps 2/3 of v₀."))
	add_mistake([speed * 5.0 / 7.0], tr("5/7 is for a solid sphere. A disc keeps 2/3 of v₀."))
	add_mistake([speed], tr("Friction slows the ball until it rolls."))


func _ask_level_time() -> void:
	prompt = _given_level() + " " + tr("After how many seconds does it begin to roll?")
	answer_titles = ["t₁ ="]
	var grip := friction * gravity
	right_answer = [speed / (3.0 * grip)]
	add_mistake([speed / grip], tr("Then a block would stop. The ball rolls long before."))
	add_mistake([speed / (2.0 * grip)], tr("Friction turns the ball and slows it, too: 3 µ N."))
	add_mistake([speed / (3.5 * grip)], tr("3.5 is for a solid sphere. A disc has 3."))
	add_mistake([speed / (3.0 * gravity)], tr("µ is missing: friction is µ N."))


func _acceleration() -> float:
	if _incline.can_hold():
		return _incline.pull * 2.0 / 3.0
	return _incline.pull - friction * _incline.pressure


func _time_with(acceleration: float) -> float:
	return sqrt(2.0 * along.length() / acceleration)


func _given() -> String:
	var sentence := tr("A disc on a slope with h = %s, w = %s, with g = %s and µ = %s.")
	return sentence % [along.y, along.x, gravity, friction].map(NumberText.short)


func _given_level() -> String:
	var sentence := tr(
		"A disc that does not turn is pushed along the level with v₀ = %s; g = %s, µ = %s."
	)
	return sentence % [speed, gravity, friction].map(NumberText.short)
