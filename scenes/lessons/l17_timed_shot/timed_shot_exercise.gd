class_name TimedShotExercise
extends Exercise
## Asks when to fire, or how long the firing window is, with fresh numbers.

## What is asked for: the moment at a target on a line or on a circle, or half of the window.
enum Kind { LINE, CIRCLE, WINDOW }

const _FLIGHTS: Array[float] = [0.5, 1.0, 1.5, 2.0]
const _SPEEDS: Array[int] = [100, 200, 300]
const _TARGET_SPEEDS: Array[int] = [50, 100, 150]
# When the target is in front of the barrel, in seconds.
const _IN_FRONT: Array[float] = [2.5, 3.0, 4.0]
const _TURNS: Array[int] = [30, 45, 60, 90]
const _TURNED: Array[int] = [180, 270, 360]
# Speeds of bullet and target across each other, as the legs of a right triangle.
const _LEGS: Array[Vector2i] = [
	Vector2i(200, 150), Vector2i(150, 200), Vector2i(400, 300), Vector2i(300, 400)
]
const _RADII: Array[int] = [6, 12, 24]
# The muzzle of every question.
const _MUZZLE_Y := 100.0

## The state of the board that shows the question; empty for one on a circle.
var board: Dictionary = {}

var _solution: String


## A target that is in front of the barrel after [param in_front] seconds; the bullet needs
## [param flight] seconds to its way.
static func on_line(
	flight: float, in_front: float, speed: float, target_speed: float
) -> TimedShotExercise:
	var exercise: TimedShotExercise = new()
	var target := Vec2.new(-target_speed * in_front, _MUZZLE_Y - speed * flight)
	exercise._set_board(speed, target, target_speed, 10.0)
	exercise._ask_line(target, flight, in_front, speed, target_speed)
	return exercise


## A target on a circle that turns [param turn] degrees a second and has [param turned] degrees to
## go to X; the bullet needs [param flight] seconds to X.
static func on_circle(flight: float, turned: float, turn: float) -> TimedShotExercise:
	var exercise: TimedShotExercise = new()
	exercise._ask_circle(flight, turned, turn)
	return exercise


## A bullet and a target with these speeds, straight across each other, and these radii together.
static func of_window(speed: float, target_speed: float, radius: float) -> TimedShotExercise:
	var exercise: TimedShotExercise = new()
	var target := Vec2.new(-3.0 * target_speed, _MUZZLE_Y - speed)
	exercise._set_board(speed, target, target_speed, radius)
	exercise._ask_window(speed, target_speed, radius)
	return exercise


## A question with numbers drawn from [param rng].
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> TimedShotExercise:
	var flight := _FLIGHTS[rng.randi_range(0, _FLIGHTS.size() - 1)]
	match kind:
		Kind.LINE:
			var in_front := _IN_FRONT[rng.randi_range(0, _IN_FRONT.size() - 1)]
			var speed := _SPEEDS[rng.randi_range(0, _SPEEDS.size() - 1)]
			var target_speed := _TARGET_SPEEDS[rng.randi_range(0, _TARGET_SPEEDS.size() - 1)]
			return on_line(flight, in_front, speed, target_speed)
		Kind.CIRCLE:
			var turn := _TURNS[rng.randi_range(0, _TURNS.size() - 1)]
			var turned := _TURNED[rng.randi_range(0, _TURNED.size() - 1)]
			return on_circle(flight, turned, turn)
	var legs := _LEGS[rng.randi_range(0, _LEGS.size() - 1)]
	return of_window(legs.x, legs.y, _RADII[rng.randi_range(0, _RADII.size() - 1)])


func solution() -> String:
	return "%s = %s" % [_solution, text_of(right_answer)]


func board_state() -> Dictionary:
	return board


func _set_board(speed: float, target: Vec2, target_speed: float, radius: float) -> void:
	board = {
		"kind": int(TimedShotModel.Kind.LINE),
		"muzzle": PackedFloat64Array([0.0, _MUZZLE_Y]),
		"bullet": PackedFloat64Array([0.0, -speed]),
		"target": PackedFloat64Array([target.x, target.y]),
		"velocity": PackedFloat64Array([target_speed, 0.0]),
		"radius": radius,
	}


func _ask_line(
	target: Vec2, flight: float, in_front: float, speed: float, target_speed: float
) -> void:
	var question := tr("The barrel at %s shoots up, s = %s. The target starts at %s, V = %s.")
	prompt = (
		question
		% [
			NumberText.pair(0.0, _MUZZLE_Y),
			NumberText.short(speed),
			NumberText.pair(target.x, target.y),
			NumberText.pair(target_speed, 0.0)
		]
	)
	prompt += " " + tr("When do you fire?")
	answer_titles = ["t ="]
	right_answer = [in_front - flight]
	_solution = "%s − %s" % [NumberText.short(in_front), NumberText.short(flight)]
	_add_moments(flight, in_front)


func _ask_circle(flight: float, turned: float, turn: float) -> void:
	var question := tr(
		"The target turns %s° a second and has %s° to go to X. The bullet needs %s s to X."
	)
	prompt = (
		question % [NumberText.short(turn), NumberText.short(turned), NumberText.short(flight)]
	)
	prompt += " " + tr("When do you fire?")
	answer_titles = ["t ="]
	var in_front := turned / turn
	right_answer = [in_front - flight]
	_solution = (
		"%s° / %s° − %s"
		% [NumberText.short(turned), NumberText.short(turn), NumberText.short(flight)]
	)
	_add_moments(flight, in_front)


func _add_moments(flight: float, in_front: float) -> void:
	add_mistake([in_front], tr("Then the target is in X, and the bullet only starts."))
	add_mistake([in_front + flight], tr("The flight was added. Take it away: fire earlier."))
	add_mistake([flight], tr("That is only how long the bullet flies."))


func _ask_window(speed: float, target_speed: float, radius: float) -> void:
	var question := tr("Straight across each other: |W| = %s, |V| = %s, R = %s.")
	prompt = (
		question
		% [NumberText.short(speed), NumberText.short(target_speed), NumberText.short(radius)]
	)
	prompt += " " + tr("A shot hits within ± how many seconds?")
	answer_titles = ["±"]
	var closing := sqrt(speed * speed + target_speed * target_speed)
	var half := radius * closing / (speed * target_speed)
	right_answer = [half]
	_solution = "R |W − V| / (|W| |V|)"
	add_mistake(
		[radius / target_speed],
		tr("That is R / |V|: the bullet moves, too, and passes beside the target for longer.")
	)
	add_mistake([radius / speed], tr("That is R / |W|: the target does not rest."))
	add_mistake([2.0 * half], tr("That is the whole window. Half of it is before, half after."))
	add_mistake([radius / closing], tr("Here |W − V| is on the wrong side of the fraction."))
