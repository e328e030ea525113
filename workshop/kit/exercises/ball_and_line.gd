class_name WorkshopBallAndLine
extends RefCounted
## Exercises 5 to 7: a ball and an infinite line.


## Exercise 5.
static func distance() -> WorkshopExercise:
	var made := WorkshopExercise.new(5, LabText.translate("Distance to a line"), "line_distance")
	made.tasks = [_distance()]
	return made


## Exercise 6.
static func touching() -> WorkshopExercise:
	var made := WorkshopExercise.new(6, LabText.translate("Does it touch?"), "line_distance")
	made.tasks = [_touching()]
	return made


## Exercise 7.
static func reset() -> WorkshopExercise:
	var made := WorkshopExercise.new(7, LabText.translate("Position reset"), "point_of_impact")
	made.tasks = [_reset()]
	return made


static func _distance() -> WorkshopTask:
	var task := WorkshopTask.new("MyLine", "distance_to_line", "vvv", "f")
	task.by(WorkshopReferenceLine, "distance_to_line")
	var front := LabText.translate("(2, 6) from the line (0, 0) to (4, 3)")
	task.probe(front, [2.0, 6.0, 0.0, 0.0, 4.0, 3.0])
	var other_start := LabText.translate("(2, 6) from the same line, (-4, -3) to (8, 6)")
	task.probe(other_start, [2.0, 6.0, -4.0, -3.0, 8.0, 6.0])
	var behind := LabText.translate("(5, -1) from the line (0, 0) to (4, 3)")
	task.probe(behind, [5.0, -1.0, 0.0, 0.0, 4.0, 3.0])
	task.probe(
		LabText.translate("(1, 2) from the line (3, 1) to (3, 9)"), [1.0, 2.0, 3.0, 1.0, 3.0, 9.0]
	)
	_add_ways_of_distance(task)
	task.add_spoiling_way()
	return task


static func _add_ways_of_distance(task: WorkshopTask) -> void:
	task.way(
		9,
		LabText.translate(
			"The sign is wrong: the normal of the line from start to end is (-y, x)."
		),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return [-_signed(n)]
	)
	task.way(
		9,
		LabText.translate("The normal is (y, x), a mirror image: it is (-y, x)."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var d := _difference(n)
			return [(d[0] * _ey(n) + d[1] * _ex(n)) / _size(n)]
	)
	task.way(
		10,
		LabText.translate("The normal is not normalized: it must have length 1."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return [_signed(n) * _size(n)]
	)
	task.way(
		16,
		LabText.translate("The distance has no sign: it must tell on which side the point is."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return [absf(_signed(n))]
	)
	task.way(
		0,
		LabText.translate("This is how far it is along the line: project on the normal instead."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var d := _difference(n)
			return [(d[0] * _ex(n) + d[1] * _ey(n)) / _size(n)]
	)
	task.way(
		0,
		LabText.translate(
			"This is the distance from the start: only its part along the normal counts."
		),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var d := _difference(n)
			return [sqrt(d[0] * d[0] + d[1] * d[1])]
	)
	task.way(
		0,
		LabText.translate("The point itself is projected: subtract the start of the line first."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return [(n[1] * _ex(n) - n[0] * _ey(n)) / _size(n)]
	)


static func _touching() -> WorkshopTask:
	var task := WorkshopTask.new("MyLine", "is_touching", "ff", "b")
	task.by(WorkshopReferenceLine, "is_touching")
	task.probe(LabText.translate("distance 5, radius 10"), [5.0, 10.0])
	task.probe(LabText.translate("distance 12, radius 10"), [12.0, 10.0])
	task.probe(LabText.translate("distance 30, radius 10"), [30.0, 10.0])
	task.probe(LabText.translate("distance -5, radius 10"), [-5.0, 10.0])
	task.probe(LabText.translate("distance -50, radius 10"), [-50.0, 10.0])
	task.way(
		16,
		LabText.translate(
			"The distance is taken without its sign: behind the line the ball touches, too."
		),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _truth(absf(n[0]) < n[1])
	)
	task.way(
		0,
		LabText.translate("It is the other way round: closer than the radius is touching."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _truth(n[0] > n[1])
	)
	task.way(
		0,
		LabText.translate("The radius is not used: the edge touches before the centre is there."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _truth(n[0] < 0.0)
	)
	task.way(
		0,
		LabText.translate("It compares with twice the radius: from the centre it is one radius."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _truth(n[0] < 2.0 * n[1])
	)
	return task


static func _reset() -> WorkshopTask:
	var task := WorkshopTask.new("MyLine", "position_reset", "vvff", "v")
	task.by(WorkshopReferenceLine, "position_reset")
	task.spoiling_number = 32
	task.spoiling_sentence = LabText.translate(
		"position itself is changed: give back a new vector, or the old place is lost."
	)
	var angled := LabText.translate("(20, 30), normal (-0.6, 0.8), distance 3, radius 10")
	task.probe(angled, [20.0, 30.0, -0.6, 0.8, 3.0, 10.0])
	var behind := LabText.translate("(5, 8), normal (0.8, -0.6), distance -4, radius 10")
	task.probe(behind, [5.0, 8.0, 0.8, -0.6, -4.0, 10.0])
	task.probe(
		LabText.translate("(7, 2), normal (0, -1), distance 1, radius 5"),
		[7.0, 2.0, 0.0, -1.0, 1.0, 5.0]
	)
	_add_ways_of_reset(task)
	task.add_spoiling_way()
	return task


static func _add_ways_of_reset(task: WorkshopTask) -> void:
	task.way(
		-2,
		LabText.translate("It is moved up only: an angled line needs the way along its normal."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return [n[0], n[1] - (n[5] - n[4])]
	)
	task.way(
		0,
		LabText.translate("It is moved against the normal: turn the sign round."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _pushed(n, n[4] - n[5])
	)
	task.way(
		0,
		LabText.translate("The radius is not used: the centre lands on the line."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _pushed(n, -n[4])
	)
	task.way(
		0,
		LabText.translate("It is moved by the whole radius: only radius − distance is missing."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _pushed(n, n[5])
	)
	task.way(
		16,
		LabText.translate("The distance is taken without its sign: from behind the way is longer."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _pushed(n, n[5] - absf(n[4]))
	)


static func _pushed(n: PackedFloat64Array, way: float) -> PackedFloat64Array:
	return [n[0] + n[2] * way, n[1] + n[3] * way]


static func _truth(holds: bool) -> PackedFloat64Array:
	return [1.0 if holds else 0.0]


static func _ex(n: PackedFloat64Array) -> float:
	return n[4] - n[2]


static func _ey(n: PackedFloat64Array) -> float:
	return n[5] - n[3]


static func _size(n: PackedFloat64Array) -> float:
	return sqrt(_ex(n) * _ex(n) + _ey(n) * _ey(n))


static func _difference(n: PackedFloat64Array) -> PackedFloat64Array:
	return [n[0] - n[2], n[1] - n[3]]


static func _signed(n: PackedFloat64Array) -> float:
	var d := _difference(n)
	return (d[1] * _ex(n) - d[0] * _ey(n)) / _size(n)
