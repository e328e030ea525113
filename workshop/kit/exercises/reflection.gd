class_name WorkshopReflection
extends RefCounted
## Exercise 9: the law of reflection, with bounciness.


## The exercise with its method.
static func exercise() -> WorkshopExercise:
	var made := WorkshopExercise.new(9, LabText.translate("Reflect"), "reflection")
	made.tasks = [_task()]
	return made


static func _task() -> WorkshopTask:
	var task := WorkshopTask.new("MyVec2", "reflect", "vvf", "s")
	task.by(WorkshopReferenceReflect as GDScript, "reflect")
	task.probe(LabText.translate("(3, 4), normal (0, 1), C = 1"), [3.0, 4.0, 0.0, 1.0, 1.0])
	task.probe(LabText.translate("(3, 4), normal (0, 1), C = 0.5"), [3.0, 4.0, 0.0, 1.0, 0.5])
	task.probe(LabText.translate("(3, 4), normal (0, 1), C = 0"), [3.0, 4.0, 0.0, 1.0, 0.0])
	task.probe(LabText.translate("(5, 2), normal (0.6, -0.8), C = 1"), [5.0, 2.0, 0.6, -0.8, 1.0])
	task.probe(LabText.translate("(5, 2), normal (0.6, 0.8), C = 0.5"), [5.0, 2.0, 0.6, 0.8, 0.5])
	(
		task
		. probe(
			LabText.translate("(5, 2), normal (0.6, 0.8), C left out"), [5.0, 2.0, 0.6, 0.8, 1.0]
		)
		. by_default()
	)
	(
		task
		. probe(
			LabText.translate("(3, 4), normal (0, 2), which is not unit"), [3.0, 4.0, 0.0, 2.0, 1.0]
		)
		. extra()
	)
	_add_named_ways(task)
	_add_other_ways(task)
	task.add_spoiling_way()
	return task


static func _add_named_ways(task: WorkshopTask) -> void:
	task.way(
		1,
		LabText.translate(
			"y is computed with the x that has changed already: take v · n once, first."
		),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var x := n[0] - (1.0 + n[4]) * _product(n) * n[2]
			var product := x * n[2] + n[1] * n[3]
			return [x, n[1] - (1.0 + n[4]) * product * n[3]]
	)
	task.way(
		12,
		LabText.translate("This takes the normal of the normal: it is handed over already."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _changed([n[0], n[1], -n[3], n[2], n[4]], 1.0 + n[4])
	)
	var on_tangent := LabText.translate("The bounciness belongs to the part along the normal only.")
	task.way(
		13,
		on_tangent,
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var slid := _changed(n, 1.0)
			return [slid[0] * n[4] - _product(n) * n[2], slid[1] * n[4] - _product(n) * n[3]]
	)
	task.way(
		13,
		LabText.translate(
			"The bounciness makes the whole vector shorter: only the part along n counts."
		),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var mirrored := _changed(n, 2.0)
			return [mirrored[0] * n[4], mirrored[1] * n[4]]
	)
	(
		task
		. way(
			11,
			LabText.translate(
				"For excellent: a normal that is not unit must be normalized, or refused."
			),
			func(n: PackedFloat64Array) -> PackedFloat64Array: return _changed(n, 1.0 + n[4])
		)
		. extra()
	)


static func _add_other_ways(task: WorkshopTask) -> void:
	task.way(
		0,
		LabText.translate("The bounciness is not used: it is (1 + C), not 2."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _changed(n, 2.0)
	)
	task.way(
		0,
		LabText.translate("It slides only: the part along the normal comes off (1 + C) times."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _changed(n, 1.0)
	)
	task.way(
		0,
		LabText.translate("The factor is 2C: it must be 1 + C."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _changed(n, 2.0 * n[4])
	)
	task.way(
		0,
		LabText.translate("The sign is wrong: the part along the normal must be subtracted."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _changed(n, -1.0 - n[4])
	)
	task.way(
		0,
		LabText.translate("It points exactly the other way: this is −(v − (1 + C)(v · n) n)."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var right := _changed(n, 1.0 + n[4])
			return [-right[0], -right[1]]
	)


# v - factor (v . n) n
static func _changed(n: PackedFloat64Array, factor: float) -> PackedFloat64Array:
	var change := factor * _product(n)
	return [n[0] - change * n[2], n[1] - change * n[3]]


static func _product(n: PackedFloat64Array) -> float:
	return n[0] * n[2] + n[1] * n[3]
