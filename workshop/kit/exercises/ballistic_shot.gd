class_name WorkshopBallisticShot
extends RefCounted
## Exercise 14: a shot under gravity, by the flat and by the high arc.

const _FLAT := -1.0
const _HIGH := 1.0


## The exercise with its methods.
static func exercise() -> WorkshopExercise:
	var made := WorkshopExercise.new(14, LabText.translate("Aiming under gravity"), "ballistic_aim")
	var flat := _task("flat_arc", _FLAT)
	flat.way(
		0,
		LabText.translate("This is the high arc: the flat one comes from the smaller time."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _unit(_aim(n, n[2], _HIGH))
	)
	var high := _task("high_arc", _HIGH)
	high.way(
		0,
		LabText.translate("This is the flat arc: the high one comes from the larger time."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _unit(_aim(n, n[2], _FLAT))
	)
	made.tasks = [flat, high]
	return made


static func _task(method: String, arc: float) -> WorkshopTask:
	var task := WorkshopTask.new("MyAim", method, "vff", "v")
	task.by(WorkshopReferenceAim, method)
	_add_probes(task)
	_add_ways_of_gravity(task, arc)
	_add_ways_of_directions(task, arc)
	task.add_spoiling_way()
	return task


static func _add_probes(task: WorkshopTask) -> void:
	task.probe(
		LabText.translate("target at (200, 0), gravity 300, speed 250"), [200.0, 0.0, 300.0, 250.0]
	)
	task.probe(
		LabText.translate("target above, at (150, -50), gravity 300, speed 250"),
		[150.0, -50.0, 300.0, 250.0]
	)
	task.probe(
		LabText.translate("target below on the left, at (-400, 300), gravity 300, speed 250"),
		[-400.0, 300.0, 300.0, 250.0]
	)
	task.probe(
		LabText.translate("target below, at (100, 200), gravity 300, speed 250"),
		[100.0, 200.0, 300.0, 250.0]
	)
	(
		task
		. probe(
			LabText.translate("target straight above, at (0, -100), gravity 300, speed 250"),
			[0.0, -100.0, 300.0, 250.0]
		)
		. special()
	)
	(
		task
		. probe(
			LabText.translate("out of reach: target at (200, 0), gravity 300, speed 240"),
			[200.0, 0.0, 300.0, 240.0]
		)
		. special()
	)


static func _add_ways_of_gravity(task: WorkshopTask, arc: float) -> void:
	task.way(
		0,
		LabText.translate("It aims below the target: gravity pulls along y, so aim higher."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _unit(_aim(n, -n[2], arc))
	)
	var half := LabText.translate("Gravity moves the bullet by g t² / 2: the half is missing.")
	task.way(
		0,
		half,
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _unit(_aim(n, 2.0 * n[2], arc))
	)
	var without_test := task.way(
		0,
		half,
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _nan_for_none(_unit(_aim(n, 2.0 * n[2], arc)))
	)
	without_test.only_named()
	task.way(
		0,
		LabText.translate("It aims straight at the target: on its way the bullet falls."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _unit([n[0], n[1]])
	)
	var untested := task.way(
		0,
		LabText.translate("Out of reach the root is not a number: test what is below it first."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _nan_for_none(_unit(_aim(n, n[2], arc)))
	)
	untested.about_special()


static func _add_ways_of_directions(task: WorkshopTask, arc: float) -> void:
	task.way(
		0,
		LabText.translate("The direction does not have length 1: normalize it."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _aim(n, n[2], arc)
	)
	task.way(
		0,
		LabText.translate("It always shoots to the right: a target on the left has x below 0."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var d := _unit(_aim(n, n[2], arc))
			var sign_of_x := -1.0 if n[0] < 0.0 else 1.0
			return [sign_of_x * d[0], sign_of_x * d[1]]
	)
	var above := task.way(
		0,
		LabText.translate("Straight above it divides by 0: x is 0 there."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _nan_where(n[0] == 0.0, _unit(_aim(n, n[2], arc)))
	)
	above.about_special()


# The way to the target less what gravity does until then: (0, 0) where it is out of reach.
static func _aim(n: PackedFloat64Array, gravity: float, arc: float) -> PackedFloat64Array:
	var b := n[3] * n[3] + gravity * n[1]
	var c := gravity * sqrt(n[0] * n[0] + n[1] * n[1])
	if b < absf(c):
		return [0.0, 0.0]
	var squared_time := 2.0 * (b + arc * sqrt(b * b - c * c)) / (gravity * gravity)
	return [n[0], n[1] - 0.5 * gravity * squared_time]


static func _unit(v: PackedFloat64Array) -> PackedFloat64Array:
	var length := sqrt(v[0] * v[0] + v[1] * v[1])
	if length == 0.0:
		return v
	return [v[0] / length, v[1] / length]


static func _nan_for_none(v: PackedFloat64Array) -> PackedFloat64Array:
	return _nan_where(v[0] == 0.0 and v[1] == 0.0, v)


static func _nan_where(is_wrong: bool, v: PackedFloat64Array) -> PackedFloat64Array:
	if is_wrong:
		return [NAN, NAN]
	return v
