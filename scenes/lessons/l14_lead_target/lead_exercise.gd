class_name LeadExercise
extends Exercise
## Asks when a bullet hits a moving target, or in which direction to aim, for a shooter that stands
## still or moves.
##
## The place of the hit lies along a Pythagorean triple and the time is a whole number, so that
## answers are short.

## What is asked for.
enum Kind { TIME, DIRECTION, MOVING_SHOOTER }

# Directions of length 5.
const _DIRECTIONS: Array[Vector2i] = [
	Vector2i(4, 3), Vector2i(3, 4), Vector2i(4, -3), Vector2i(3, -4), Vector2i(-4, 3)
]

## From the shooter to the target, in pixels.
var way: Vec2
## The target's velocity, in pixels per second.
var velocity: Vec2
## The shooter's own velocity.
var own: Vec2
## The speed of the bullet.
var speed: float

var _equation: LeadEquation


## A question with these numbers, for which the bullet hits.
func _init(kind: Kind, its_way: Vec2, its_velocity: Vec2, its_own: Vec2, its_speed: float) -> void:
	way = its_way
	velocity = its_velocity
	own = its_own
	speed = its_speed
	_equation = LeadEquation.new(way, velocity.minus(own), speed, 0.0)
	if kind == Kind.TIME:
		_ask_time()
	else:
		_ask_direction(kind)


## A question with numbers drawn from [param rng]; the bullet is faster than the target.
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> LeadExercise:
	var unit := _DIRECTIONS[rng.randi_range(0, _DIRECTIONS.size() - 1)]
	var time := rng.randi_range(1, 3)
	var fifth := rng.randi_range(2, 6) * 10.0
	var meeting := Vec2.new(unit.x * fifth * time, unit.y * fifth * time)
	var relative := Vec2.new(rng.randi_range(-6, 6) * 10.0, rng.randi_range(-6, 6) * 10.0)
	relative.limit_length(4.5 * fifth)
	relative.set_xy(roundf(relative.x / 5.0) * 5.0, roundf(relative.y / 5.0) * 5.0)
	var its_own := Vec2.new()
	if kind == Kind.MOVING_SHOOTER:
		its_own.set_xy(rng.randi_range(-5, 5) * 10.0, rng.randi_range(1, 5) * 10.0)
	var start := meeting.minus(relative.scaled(time))
	return new(kind, start, relative.plus(its_own), its_own, 5.0 * fifth)


## The question with the numbers of the lesson's start.
static func of_the_table(kind: Kind) -> LeadExercise:
	var its_own := Vec2.new(0.0, 90.0) if kind == Kind.MOVING_SHOOTER else Vec2.new()
	return new(kind, Vec2.new(240.0, 0.0), Vec2.new(0.0, 90.0), its_own, 150.0)


## Shooter and target, as far from the middle of the board as each other.
func board_state() -> Dictionary:
	return {
		"shooter": [-0.5 * way.x, -0.5 * way.y],
		"target": [0.5 * way.x, 0.5 * way.y],
		"velocity": [velocity.x, velocity.y],
		"own": [own.x, own.y],
		"speed": speed,
		"radius": 0.0,
	}


func solution() -> String:
	var time := _equation.times()[0]
	var hit := _equation.way_after(time)
	var numbers := [NumberText.short(time), _pair(hit), _pair(_equation.direction())]
	return "t = %s s,  P + V t = %s,  d = %s" % numbers


func _ask_time() -> void:
	prompt = _given() + " " + tr("After how many seconds does it hit?")
	answer_titles = ["t ="]
	right_answer = [_equation.times()[0]]
	var one_step := way.length() / speed
	add_mistake([one_step], tr("That is |P| / s: the time to where the target is now."))
	var other := _equation.other_root()
	add_mistake([other], tr("That is the root below 0: it lies in the past."))
	# It hits a target that moves with -V.
	add_mistake(
		[-other], tr("That would hit a target that moves the other way: mind the sign of V.")
	)
	var approach := speed + velocity.length()
	add_mistake(
		[way.length() / approach], tr("Speeds add up only where both fly straight at each other.")
	)
	add_mistake([speed * right_answer[0]], tr("That is the way s t: divide it by s."))


func _ask_direction(kind: Kind) -> void:
	prompt = _given()
	if kind == Kind.MOVING_SHOOTER:
		var moving := tr("The shooter moves with u = %s, and the bullet takes u along.")
		prompt += " " + moving % _pair(own)
	prompt += " " + tr("In which direction d, of length 1, do you aim?")
	answer_titles = ["dx =", "dy ="]
	var direction := _equation.direction()
	right_answer = [direction.x, direction.y]
	_add_directions()
	if kind == Kind.MOVING_SHOOTER:
		_add_own_mistakes(direction)


func _add_directions() -> void:
	var hit := _equation.way_after(_equation.times()[0])
	_add(hit, tr("That is P + V t: divide it by its length."))
	_add(way.normalized(), tr("That is where the target is now: by then it is gone."))
	for mistake: int in [LeadTargetMistakes.ONE_STEP, LeadTargetMistakes.BELOW_ZERO]:
		_add(LeadTargetMistakes.direction(mistake, _equation, own), _sentences()[mistake])


func _add_own_mistakes(direction: Vec2) -> void:
	for mistake: int in [LeadTargetMistakes.WITHOUT_OWN, LeadTargetMistakes.OWN_TWICE]:
		_add(LeadTargetMistakes.direction(mistake, _equation, own), _sentences()[mistake])
	var on_ground := own.plus(direction.scaled(speed))
	_add(on_ground.normalized(), tr("That is how it flies on the ground. Aim before u is added."))


func _sentences() -> Dictionary[int, String]:
	return {
		LeadTargetMistakes.ONE_STEP: tr("Its time |P| / s is that to where the target is now."),
		LeadTargetMistakes.BELOW_ZERO: tr("That takes the root below 0: it aims at the past."),
		LeadTargetMistakes.WITHOUT_OWN: tr("u is forgotten: V = v − u."),
		LeadTargetMistakes.OWN_TWICE: tr("u is subtracted twice: V = v − u."),
	}


func _add(direction: Vec2, sentence: String) -> void:
	if direction.length() > 0.0:
		add_mistake([direction.x, direction.y], sentence)


func _given() -> String:
	var sentence := tr(
		"The target is at P = %s from you and moves with v = %s. The bullet has s = %s."
	)
	return sentence % [_pair(way), _pair(velocity), NumberText.short(speed)]


static func _pair(vector: Vec2) -> String:
	return NumberText.pair(vector.x, vector.y)
