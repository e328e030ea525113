class_name WorkshopRotation
extends RefCounted
## Exercise 0: rotating a vector, and around a point.


## The exercise with its methods.
static func exercise() -> WorkshopExercise:
	var made := WorkshopExercise.new(0, LabText.translate("Rotate"), "")
	made.tasks = [_rotate(), _rotate_around()]
	return made


static func _rotate() -> WorkshopTask:
	var task := WorkshopTask.new("MyVec2", "rotate", "vf", "s")
	task.by(Vec2, "rotate_radians")
	task.probe(LabText.translate("(2, 5) by 90°"), [2.0, 5.0, PI / 2.0])
	task.probe(LabText.translate("(3, -1) by 30°"), [3.0, -1.0, PI / 6.0])
	task.probe(LabText.translate("(-4, 2) by -120°"), [-4.0, 2.0, -TAU / 3.0])
	task.way(
		1,
		LabText.translate(
			"y is computed with the x that has changed already: keep the old x first."
		),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _turned_late(n[0], n[1], n[2])
	)
	task.way(
		4,
		LabText.translate("The angle is in radians already: it must not be taken for degrees."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _turned(n[0], n[1], deg_to_rad(n[2]))
	)
	task.way(
		4,
		LabText.translate(
			"The angle is in radians, and cos and sin want radians: do not convert it."
		),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _turned(n[0], n[1], rad_to_deg(n[2]))
	)
	task.way(
		0,
		LabText.translate("It turns the other way round: look at the signs of the two sines."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _turned(n[0], n[1], -n[2])
	)
	return task


static func _rotate_around() -> WorkshopTask:
	var task := WorkshopTask.new("MyVec2", "rotate_around", "vvf", "s")
	task.by(Vec2, "rotate_around_radians")
	task.probe(LabText.translate("(2, 5) about (2, 1) by 90°"), [2.0, 5.0, 2.0, 1.0, PI / 2.0])
	task.probe(LabText.translate("(3, -1) about (-1, 2) by 30°"), [3.0, -1.0, -1.0, 2.0, PI / 6.0])
	task.probe(
		LabText.translate("(1, 1) about (4, -2) by -120°"), [1.0, 1.0, 4.0, -2.0, -TAU / 3.0]
	)
	_add_ways_around(task)
	task.add_spoiling_way()
	return task


static func _add_ways_around(task: WorkshopTask) -> void:
	task.way(
		2,
		LabText.translate(
			"It rotates first and subtracts the point then: subtract the point first."
		),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _moved(_turned(n[0], n[1], n[4]), -n[2], -n[3])
	)
	task.way(
		3,
		LabText.translate("It is not moved back: add the point after the rotation."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _turned(n[0] - n[2], n[1] - n[3], n[4])
	)
	task.way(
		3,
		LabText.translate(
			"The signs are flipped: subtract the point first, and add it at the end."
		),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _moved(_turned(n[0] + n[2], n[1] + n[3], n[4]), -n[2], -n[3])
	)
	task.way(
		1,
		LabText.translate(
			"y is computed with the x that has changed already: keep the old x first."
		),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _moved(_turned_late(n[0] - n[2], n[1] - n[3], n[4]), n[2], n[3])
	)
	task.way(
		4,
		LabText.translate("The angle is in radians already: it must not be taken for degrees."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _moved(_turned(n[0] - n[2], n[1] - n[3], deg_to_rad(n[4])), n[2], n[3])
	)
	task.way(
		0,
		LabText.translate("It turns about (0, 0): the point is not used."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _turned(n[0], n[1], n[4])
	)


static func _turned(x: float, y: float, angle: float) -> PackedFloat64Array:
	return [x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle)]


static func _turned_late(x: float, y: float, angle: float) -> PackedFloat64Array:
	var changed := x * cos(angle) - y * sin(angle)
	return [changed, changed * sin(angle) + y * cos(angle)]


static func _moved(pair: PackedFloat64Array, x: float, y: float) -> PackedFloat64Array:
	return [pair[0] + x, pair[1] + y]
