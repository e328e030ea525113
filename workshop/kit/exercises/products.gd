class_name WorkshopProducts
extends RefCounted
## Exercises 3 and 4: the dot product and both projections.


## Exercise 3.
static func dot_product() -> WorkshopExercise:
	var made := WorkshopExercise.new(3, LabText.translate("The dot product"), "dot_product")
	made.tasks = [_dot()]
	return made


## Exercise 4.
static func projections() -> WorkshopExercise:
	var made := WorkshopExercise.new(4, LabText.translate("Projections"), "dot_product")
	made.tasks = [_scalar(), _vector()]
	return made


static func _dot() -> WorkshopTask:
	var task := WorkshopTask.new("MyVec2", "dot", "vv", "f")
	task.by(Vec2, "dot")
	task.probe("(7, 1) · (8, -6)", [7.0, 1.0, 8.0, -6.0])
	task.probe("(3, 4) · (3, 4)", [3.0, 4.0, 3.0, 4.0])
	task.probe("(1, 2) · (-4, 1)", [1.0, 2.0, -4.0, 1.0])
	_add_normalized_dots(task)
	task.way(
		0,
		LabText.translate("The two products are subtracted: add them."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return [n[0] * n[2] - n[1] * n[3]]
	)
	task.way(
		0,
		LabText.translate("The components are crossed: multiply x with x, and y with y."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return [n[0] * n[3] + n[1] * n[2]]
	)
	task.way(
		0,
		LabText.translate("This is the determinant, x·other.y − y·other.x, not the dot product."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return [n[0] * n[3] - n[1] * n[2]]
	)
	task.way(
		0,
		LabText.translate("The lengths are multiplied: the angle has no part in that."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return [_first(n) * _second(n)]
	)
	task.add_spoiling_way()
	return task


static func _add_normalized_dots(task: WorkshopTask) -> void:
	var sentence := LabText.translate(
		"dot must not normalize: whoever needs a unit vector does that."
	)
	task.way(
		10,
		sentence,
		func(n: PackedFloat64Array) -> PackedFloat64Array: return [_product(n) / _second(n)]
	)
	task.way(
		10,
		sentence,
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return [_product(n) / (_first(n) * _second(n))]
	)
	(
		task
		. way(
			10,
			sentence,
			func(n: PackedFloat64Array) -> PackedFloat64Array: return [_product(n) / _first(n)]
		)
		. only_named()
	)


static func _scalar() -> WorkshopTask:
	var task := WorkshopTask.new("MyVec2", "scalar_projection", "vv", "f")
	task.by(Vec2, "scalar_projection")
	_add_probes(task)
	task.way(
		10,
		LabText.translate("b is not normalized: divide by the length of onto."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return [_product(n)]
	)
	task.way(
		10,
		LabText.translate("It is divided by the square of the length of onto: once is enough."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return [_ratio(_product(n), _second(n) ** 2)]
	)
	task.way(
		0,
		LabText.translate("a and b are swapped: divide by the length of onto, not by your own."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return [_ratio(_product(n), _first(n))]
	)
	task.way(
		0,
		LabText.translate("Beyond a right angle the scalar projection is negative: keep the sign."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return [absf(_ratio(_product(n), _second(n)))]
	)
	(
		task
		. way(
			6,
			LabText.translate("A zero onto gives NaN: the projection on it is 0."),
			func(n: PackedFloat64Array) -> PackedFloat64Array: return [_product(n) / _second(n)]
		)
		. about_special()
	)
	task.add_spoiling_way()
	return task


static func _vector() -> WorkshopTask:
	var task := WorkshopTask.new("MyVec2", "vector_projection", "vv", "v")
	task.by(Vec2, "vector_projection")
	_add_probes(task)
	task.way(
		10,
		LabText.translate("b is not normalized: it is the length of onto squared times too large."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _along(n, _product(n))
	)
	task.way(
		10,
		LabText.translate(
			"b is normalized once: the scalar projection times the UNIT vector of onto."
		),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _along(n, _ratio(_product(n), _second(n)))
	)
	_add_other_shadows(task)
	var no_number := LabText.translate("A zero onto gives NaN: the projection on it is (0, 0).")
	task.way(6, no_number, _undefined_shadow).about_special()
	task.add_spoiling_way()
	return task


static func _add_other_shadows(task: WorkshopTask) -> void:
	task.way(
		0,
		LabText.translate("a and b are swapped: this is the shadow of onto on your vector."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var share := _ratio(_product(n), _first(n) ** 2)
			return [n[0] * share, n[1] * share]
	)
	task.way(
		0,
		LabText.translate("This is what the shadow leaves over, perpendicular to onto."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var shadow := _along(n, _ratio(_product(n), _second(n) ** 2))
			return [n[0] - shadow[0], n[1] - shadow[1]]
	)
	task.way(
		0,
		LabText.translate("Beyond a right angle the shadow points against onto: keep the sign."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _along(n, absf(_ratio(_product(n), _second(n) ** 2)))
	)


static func _add_probes(task: WorkshopTask) -> void:
	task.probe(LabText.translate("(7, 1) on (8, -6)"), [7.0, 1.0, 8.0, -6.0])
	task.probe(LabText.translate("(-3, 1) on (2, 0)"), [-3.0, 1.0, 2.0, 0.0])
	task.probe(LabText.translate("(2, 5) on (0.6, 0.8)"), [2.0, 5.0, 0.6, 0.8])
	task.probe(LabText.translate("(3, 4) on (0, 0)"), [3.0, 4.0, 0.0, 0.0]).special()


static func _undefined_shadow(n: PackedFloat64Array) -> PackedFloat64Array:
	return _along(n, _product(n) / _second(n) ** 2)


static func _product(n: PackedFloat64Array) -> float:
	return n[0] * n[2] + n[1] * n[3]


static func _first(n: PackedFloat64Array) -> float:
	return sqrt(n[0] * n[0] + n[1] * n[1])


static func _second(n: PackedFloat64Array) -> float:
	return sqrt(n[2] * n[2] + n[3] * n[3])


static func _along(n: PackedFloat64Array, factor: float) -> PackedFloat64Array:
	return [n[2] * factor, n[3] * factor]


static func _ratio(part: float, whole: float) -> float:
	return part / whole if whole != 0.0 else 0.0
