class_name NewtonBallsPresets
extends RefCounted
## The presets of the lesson on balls that meet.

# The seed of the velocities of 50 balls: always the same.
const _SEED := 50
const _COLUMNS := 10
const _ROWS := 5


## What each preset changes in the model's state, by its title (source text).
static func all() -> Dictionary[String, Dictionary]:
	var one_to_two: Array[PackedFloat64Array] = [[-6, -2, 6, 0, 1], [2, -2, 0, 0, 2]]
	return {
		"1:2": _preset(one_to_two, 1.0),
		"C = 0.5": _preset(one_to_two, 0.5),
		"C = 0": _preset(one_to_two, 0.0),
		"Equal masses": _preset([[-6, -2, 5, 0, 1], [3, -2, -1, 0, 1]], 1.0),
		"Heavy on light": _preset([[-6, -3, 3, 0, 9], [2, -3, 0, 0, 1]], 1.0),
		"Oblique": _preset([[-5.6, -3.2, 5, 0, 1], [2, -2, 0, 0, 1]], 1.0),
		"Cradle": _preset(_cradle(), 1.0),
		"Rack": _preset(_rack(), 1.0, true),
		"50 balls": _preset(_crowd(), 1.0, true),
	}


static func _preset(
	balls: Array[PackedFloat64Array], bounciness: float, has_box := false
) -> Dictionary:
	return {
		balls = balls,
		bounciness = bounciness,
		has_box = has_box,
		has_newton = true,
	}


# Four that touch, and a fifth that comes.
static func _cradle() -> Array[PackedFloat64Array]:
	var balls: Array[PackedFloat64Array] = [[-8, -2, 5, 0, 1]]
	for place: int in 4:
		balls.append([2 * place - 1, -2, 0, 0, 1])
	return balls


# Fifteen balls with a hair between them: three that touch at once have no order.
static func _rack() -> Array[PackedFloat64Array]:
	var balls: Array[PackedFloat64Array] = [[-8, 0.1, 9, 0, 0.25]]
	for row: int in 5:
		for place: int in row + 1:
			balls.append([(20 + 9 * row) / 10.0, (104 * place - 52 * row) / 100.0, 0, 0, 0.25])
	return balls


static func _crowd() -> Array[PackedFloat64Array]:
	var rng := RandomNumberGenerator.new()
	rng.seed = _SEED
	var balls: Array[PackedFloat64Array] = []
	for number: int in _COLUMNS * _ROWS:
		var column := number % _COLUMNS
		var row := floori(float(number) / _COLUMNS)
		var x := (22 * column - 99) / 10.0
		var y := (24 * row - 48) / 10.0
		var mass := 0.25 if (row + column) % 2 == 0 else 0.09
		balls.append([x, y, rng.randi_range(-30, 30) / 10.0, rng.randi_range(-30, 30) / 10.0, mass])
	return balls
