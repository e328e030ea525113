class_name WorkshopDirections
extends RefCounted
## Exercises 1 and 2: unit vectors and normals.


## Exercise 1.
static func normalizing() -> WorkshopExercise:
	var made := WorkshopExercise.new(1, LabText.translate("Normalize"), "normals")
	made.tasks = [_normalized()]
	return made


## Exercise 2.
static func normals() -> WorkshopExercise:
	var made := WorkshopExercise.new(2, LabText.translate("The normal"), "normals")
	made.tasks = [_normal()]
	return made


static func _normalized() -> WorkshopTask:
	var task := WorkshopTask.new("MyVec2", "normalized", "v", "v")
	task.by(Vec2, "normalized")
	task.probe("(3, 4)", [3.0, 4.0])
	task.probe("(0.3, 0.4)", [0.3, 0.4])
	task.probe("(2, 1)", [2.0, 1.0])
	task.probe("(-5, 12)", [-5.0, 12.0])
	task.probe("(0, 0)", [0.0, 0.0]).special()
	_add_ways_about_length(task, func(x: float, y: float) -> PackedFloat64Array: return [x, y])
	task.way(
		0,
		LabText.translate("It divides by the square of the length: take the root."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _over(n, [n[0], n[1]], 2.0)
	)
	task.add_spoiling_way()
	return task


static func _normal() -> WorkshopTask:
	var task := WorkshopTask.new("MyVec2", "normal", "v", "v")
	task.by(Vec2, "normal")
	task.probe("(3, 1)", [3.0, 1.0])
	task.probe("(3, -2)", [3.0, -2.0])
	task.probe("(3, -4)", [3.0, -4.0])
	task.probe("(0.3, 0.4)", [0.3, 0.4])
	task.probe("(0, 0)", [0.0, 0.0]).special()
	_add_ways_about_length(task, func(x: float, y: float) -> PackedFloat64Array: return [-y, x])
	_add_ways_about_turning(task)
	task.add_spoiling_way()
	return task


static func _add_ways_about_turning(task: WorkshopTask) -> void:
	var wrong_side := LabText.translate("It is the opposite normal: (x, y) turns into (-y, x).")
	var no_sign := LabText.translate("It is (y, x), a mirror image: the normal is (-y, x).")
	var not_unit := LabText.translate("Its length is not 1: divide by the length.")
	task.way(
		9,
		wrong_side,
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _over(n, [n[1], -n[0]], 1.0)
	)
	task.way(
		9,
		no_sign,
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _over(n, [n[1], n[0]], 1.0)
	)
	task.way(0, not_unit, func(n: PackedFloat64Array) -> PackedFloat64Array: return [-n[1], n[0]])
	(
		task
		. way(
			9, wrong_side, func(n: PackedFloat64Array) -> PackedFloat64Array: return [n[1], -n[0]]
		)
		. only_named()
	)
	(
		task
		. way(9, no_sign, func(n: PackedFloat64Array) -> PackedFloat64Array: return [n[1], n[0]])
		. only_named()
	)
	task.way(
		0,
		LabText.translate("It points along the vector: it is not perpendicular to it."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _over(n, [n[0], n[1]], 1.0)
	)


# The ways that are the same for the unit vector and for the normal: `part` is what is divided.
static func _add_ways_about_length(task: WorkshopTask, part: Callable) -> void:
	var cut := LabText.translate("The length is cut to a whole number: keep it a float.")
	var no_number := LabText.translate("(0, 0) gives NaN: a zero vector must stay (0, 0).")
	task.way(6, no_number, _undefined_at_zero.bind(part)).about_special()
	task.way(
		7,
		cut,
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var is_zero := int(_length(n)) == 0
			return _zero() if is_zero else _divided(_part(part, n), _length(n))
	)
	task.way(7, cut, _by_whole_length.bind(part)).only_named()


static func _undefined_at_zero(n: PackedFloat64Array, part: Callable) -> PackedFloat64Array:
	return _divided(_part(part, n), _length(n))


static func _by_whole_length(n: PackedFloat64Array, part: Callable) -> PackedFloat64Array:
	var whole := int(_length(n))
	return _zero() if whole == 0 else _divided(_part(part, n), whole)


static func _part(part: Callable, n: PackedFloat64Array) -> PackedFloat64Array:
	return part.call(n[0], n[1])


static func _length(n: PackedFloat64Array) -> float:
	return sqrt(n[0] * n[0] + n[1] * n[1])


# A pair divided by a power of the length of the vector; a zero vector stays zero.
static func _over(
	n: PackedFloat64Array, pair: PackedFloat64Array, power: float
) -> PackedFloat64Array:
	var size := _length(n)
	return _zero() if size == 0.0 else _divided(pair, size ** power)


static func _zero() -> PackedFloat64Array:
	return [0.0, 0.0]


static func _divided(pair: PackedFloat64Array, divisor: float) -> PackedFloat64Array:
	return [pair[0] / divisor, pair[1] / divisor]
