class_name MovingPlatformsExercise
extends Exercise
## Asks how fast a ball leaves a wall or paddle that moves, how fast a disc on a belt rolls, and
## what becomes of a ball in a press.

## What is asked for.
enum Kind { WALL, SOFT, BELT, PADDLE, PRESS, WAY, CRUSHED }

const _SPEEDS: PackedFloat64Array = [100.0, 150.0, 200.0, 250.0, 300.0, 400.0]
const _WALL_SPEEDS: PackedFloat64Array = [-50.0, 50.0, 100.0, 150.0, 200.0]
const _SOFT: PackedFloat64Array = [0.25, 0.5, 0.75]
const _BELTS: PackedFloat64Array = [90.0, 120.0, 150.0, 180.0, 240.0]
const _ON_BELT: PackedFloat64Array = [0.0, 30.0, 60.0, -60.0]
const _TURNS: PackedFloat64Array = [1.0, 2.0, 3.0, 4.0]
const _ARMS: PackedFloat64Array = [50.0, 60.0, 80.0, 100.0]
const _BEYOND: PackedFloat64Array = [20.0, 50.0]
const _WAYS: PackedFloat64Array = [100.0, 200.0, 240.0, 300.0]
# The paddle of a question turns by so much before it is upright and hits, in radians.
const _TURNED := 1.2
const _PIVOT_Y := 100.0

## The state of the board that shows the question.
var board: Dictionary = {}

var _solution := ""


## A ball with [param velocity] meets a wall with [param wall_velocity], both along the normal.
static func of_wall(
	velocity: float, wall_velocity: float, bounciness: float
) -> MovingPlatformsExercise:
	var exercise: MovingPlatformsExercise = new()
	exercise._ask_wall(velocity, wall_velocity, bounciness)
	return exercise


## A disc that does not turn comes with [param speed] onto a belt with [param belt_speed].
static func of_belt(speed: float, belt_speed: float) -> MovingPlatformsExercise:
	var exercise: MovingPlatformsExercise = new()
	exercise._ask_belt(speed, belt_speed)
	return exercise


## A paddle of length [param length] hits a ball, which comes with [param speed], at [param arm] px
## from its pivot.
static func of_paddle(
	speed: float, turn: float, arm: float, length: float
) -> MovingPlatformsExercise:
	var exercise: MovingPlatformsExercise = new()
	exercise._ask_paddle(speed, turn, arm, length)
	return exercise


## A ball in a press, about its bounce number [param bounce] off the wall that moves.
static func of_press(
	kind: Kind, way: float, speed: float, wall_speed: float, bounce: float
) -> MovingPlatformsExercise:
	var exercise: MovingPlatformsExercise = new()
	exercise._ask_press(kind, way, speed, wall_speed, bounce)
	return exercise


## A question with numbers drawn from [param rng].
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> MovingPlatformsExercise:
	var speed := _any(_SPEEDS, rng)
	match kind:
		Kind.WALL:
			return of_wall(-speed, _any(_WALL_SPEEDS, rng), 1.0)
		Kind.SOFT:
			return of_wall(-speed, _any(_WALL_SPEEDS, rng), _any(_SOFT, rng))
		Kind.BELT:
			return of_belt(_any(_ON_BELT, rng), _any(_BELTS, rng))
		Kind.PADDLE:
			var arm := _any(_ARMS, rng)
			return of_paddle(speed, _any(_TURNS, rng), arm, arm + _any(_BEYOND, rng))
	var wall_speed := 0.25 * speed * rng.randi_range(1, 3)
	return of_press(kind, _any(_WAYS, rng), speed, wall_speed, rng.randi_range(2, 5))


## The question with the numbers of the lesson.
static func of_the_lecture(kind: Kind) -> MovingPlatformsExercise:
	match kind:
		Kind.WALL:
			return of_wall(-200.0, 100.0, 1.0)
		Kind.SOFT:
			return of_wall(-200.0, 100.0, 0.5)
		Kind.BELT:
			return of_belt(0.0, 90.0)
		Kind.PADDLE:
			return of_paddle(200.0, 2.0, 100.0, 150.0)
	return of_press(kind, 200.0, 300.0, 100.0, 3.0)


func solution() -> String:
	return "%s = %s" % [_solution, text_of(right_answer)]


func board_state() -> Dictionary:
	return board


static func _any(numbers: PackedFloat64Array, rng: RandomNumberGenerator) -> float:
	return numbers[rng.randi_range(0, numbers.size() - 1)]


func _ask_wall(velocity: float, wall_velocity: float, bounciness: float) -> void:
	board = {
		"kind": int(MovingSurface.Kind.WALL),
		"ball": [200.0, 0.0],
		"velocity": [velocity, 0.0],
		"surface": [-120.0, -120.0, -120.0, 120.0],
		"surface_velocity": [wall_velocity, 0.0],
		"bounciness": bounciness,
	}
	var question := tr("Along the normal: the ball has v = %s, the wall w = %s, C = %s.")
	prompt = question % [velocity, wall_velocity, bounciness].map(NumberText.short)
	prompt += " " + tr("What is v′?")
	answer_titles = ["v′ ="]
	var seen := velocity - wall_velocity
	right_answer = [wall_velocity - bounciness * seen]
	_solution = (
		"−%s · (%s − %s) + %s"
		% [bounciness, velocity, wall_velocity, wall_velocity].map(NumberText.factor)
	)
	add_mistake(
		[-bounciness * velocity], tr("The wall's own velocity is ignored: subtract it first.")
	)
	add_mistake(
		[wall_velocity - bounciness * velocity],
		tr("w is added once, but never subtracted: first U = v − w.")
	)
	add_mistake([wall_velocity + bounciness * seen], tr("U′ points away: turn U round."))
	if bounciness < 1.0:
		add_mistake(
			[2.0 * wall_velocity - bounciness * velocity],
			tr("2 w is for C = 1: in general it is (1 + C) w.")
		)
		add_mistake([-bounciness * seen], tr("That is U′, seen from the wall: add w again."))


func _ask_belt(speed: float, belt_speed: float) -> void:
	board = {
		"kind": int(MovingSurface.Kind.BELT),
		"ball": [-120.0, 20.0],
		"surface": [-200.0, 40.0, 200.0, 40.0],
		"speed": speed,
		"surface_speed": belt_speed,
		"friction": 0.5,
	}
	var question := tr("A disc that does not turn comes with v = %s onto a level belt with s = %s.")
	prompt = question % [speed, belt_speed].map(NumberText.short)
	prompt += " " + tr("How fast does it roll in the end?")
	answer_titles = ["v′ ="]
	var slip := speed - belt_speed
	right_answer = [speed - slip / 3.0]
	_solution = "v − (v − s) / 3"
	add_mistake([belt_speed], tr("That is the belt's speed. It rolls before it is so fast."))
	add_mistake(
		[speed - 2.0 * slip / 3.0], tr("Two thirds go into the spin, a third into the flight.")
	)
	add_mistake([speed - slip / 2.0], tr("That is half of the slip: right for a ring."))
	add_mistake([speed - slip / 3.5], tr("That is for a solid sphere. A disc takes a third."))
	add_mistake([speed + slip / 3.0], tr("Friction works against the slip: mind the sign."))


func _ask_paddle(speed: float, turn: float, arm: float, length: float) -> void:
	var time := _TURNED / turn
	var tip := Vec2.unit_radians(-0.5 * PI - _TURNED).scaled(length)
	board = {
		"kind": int(MovingSurface.Kind.PADDLE),
		"ball": [MovingSurface.RADIUS + speed * time, _PIVOT_Y - arm],
		"velocity": [-speed, 0.0],
		"surface": [0.0, _PIVOT_Y, tip.x, _PIVOT_Y + tip.y],
		"turning": turn,
		"bounciness": 1.0,
	}
	var question := tr(
		"A paddle of %s px turns by %s radians a second. %s px from its pivot it meets a ball head-on."
	)
	prompt = question % [length, turn, arm].map(NumberText.short)
	prompt += " " + tr("The ball comes with %s px/s, C = 1. How fast does it leave?")
	prompt = prompt % NumberText.short(speed)
	answer_titles = ["v′ ="]
	right_answer = [speed + 2.0 * turn * arm]
	_solution = "v + 2 ω r"
	add_mistake([speed], tr("The paddle is taken to rest: its point moves with ω r."))
	add_mistake([speed + turn * arm], tr("ω r is added once: it counts before and after."))
	add_mistake([speed + 2.0 * turn * length], tr("That is the speed of the tip: r is the arm."))
	add_mistake([speed + 2.0 * turn], tr("ω alone is no speed: multiply it by the arm."))


func _ask_press(kind: Kind, way: float, speed: float, wall_speed: float, bounce: float) -> void:
	board = {
		"kind": int(MovingSurface.Kind.PRESS),
		"way": way,
		"speed": speed,
		"surface_speed": wall_speed,
	}
	var question := tr("A press: h₀ = %s, the ball starts with u₀ = %s, the wall with V = %s.")
	prompt = question % [way, speed, wall_speed].map(NumberText.short) + " "
	match kind:
		Kind.PRESS:
			_ask_press_speed(speed, wall_speed, bounce)
		Kind.WAY:
			_ask_press_way(way, speed, wall_speed, bounce)
		_:
			_ask_crush(way, speed, wall_speed)


func _ask_press_speed(speed: float, wall_speed: float, bounce: float) -> void:
	var question := tr("How fast is the ball after %s bounces off the wall that moves?")
	prompt += question % NumberText.short(bounce)
	answer_titles = ["u ="]
	right_answer = [Press.speed_after(bounce, speed, wall_speed)]
	_solution = "u₀ + 2·%s V" % NumberText.short(bounce)
	add_mistake([speed + bounce * wall_speed], tr("Each bounce adds 2 V: V before, V after."))
	add_mistake([speed], tr("A wall that comes makes the ball faster, by 2 V."))
	add_mistake([speed + 2.0 * wall_speed], tr("That is after one bounce."))


func _ask_press_way(way: float, speed: float, wall_speed: float, bounce: float) -> void:
	var question := tr("How much way is left at bounce number %s off the wall that moves?")
	prompt += question % NumberText.short(bounce)
	answer_titles = ["h ="]
	var then := Press.speed_after(bounce, speed, wall_speed)
	right_answer = [Press.way_after(bounce, way, speed, wall_speed)]
	_solution = "h₀ (u₀ − V) / (u − V)"
	add_mistake([way * speed / then], tr("Not h u stays the same, but h (u − V)."))
	add_mistake(
		[way * (speed + wall_speed) / (then + wall_speed)],
		tr("The ball flies away from the wall: it gains u − V on it.")
	)
	add_mistake([way - bounce * wall_speed], tr("The bounces do not come once a second."))


func _ask_crush(way: float, speed: float, wall_speed: float) -> void:
	prompt += tr("After how many seconds is the ball crushed?")
	answer_titles = ["T ="]
	right_answer = [way / wall_speed]
	_solution = "h₀ / V"
	add_mistake([way / speed], tr("That is when the ball is at the other wall."))
	add_mistake([way / (speed + wall_speed)], tr("The other wall rests: V alone closes the press."))
	add_mistake([way / (speed - wall_speed)], tr("The ball's speed does not matter here."))
