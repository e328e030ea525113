class_name WorkshopLeadShot
extends RefCounted
## Exercise 13: a shot ahead of a moving target.


## The exercise with its methods.
static func exercise() -> WorkshopExercise:
	var made := WorkshopExercise.new(13, LabText.translate("Aiming ahead"), "lead_target")
	made.tasks = [_time(), _direction()]
	return made


static func _time() -> WorkshopTask:
	var task := WorkshopTask.new("MyAim", "lead_time", "vvf", "f")
	task.by(WorkshopReferenceAim, "lead_time")
	_add_probes(task)
	task.way(
		0,
		LabText.translate("This is the time to where the target is now: meanwhile it moves on."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return [_length(n[0], n[1]) / n[4]]
	)
	_add_roots(task, _only_time)
	task.way(
		0,
		LabText.translate("b is twice the dot product of place and velocity: the 2 is missing."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return [_first(_roots(n, 0.5, 1.0))]
	)
	task.way(
		0,
		LabText.translate("a has the wrong sign: it is velocity · velocity − speed²."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return [_first(_roots(n, 1.0, -1.0))]
	)
	task.add_spoiling_way()
	return task


static func _direction() -> WorkshopTask:
	var task := WorkshopTask.new("MyAim", "lead", "vvf", "v")
	task.by(WorkshopReferenceAim, "lead")
	_add_probes(task)
	task.way(
		0,
		LabText.translate("It aims at where the target is now: aim at where it will be."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _toward(n, 0.0)
	)
	task.way(
		0,
		LabText.translate("The time is that to where the target is now: the way changes with it."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _toward(n, _length(n[0], n[1]) / n[4])
	)
	_add_roots(task, _toward)
	task.way(
		0,
		LabText.translate("The direction does not have length 1: normalize it."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var t := _first(_roots(n, 1.0, 1.0))
			return [n[0] + n[2] * t, n[1] + n[3] * t]
	)
	task.add_spoiling_way()
	return task


static func _add_probes(task: WorkshopTask) -> void:
	task.probe(
		LabText.translate("target at (240, 0), moving with (0, 90), speed 150"),
		[240.0, 0.0, 0.0, 90.0, 150.0]
	)
	task.probe(
		LabText.translate("target at (20, 90), moving with (30, 30), speed 130"),
		[20.0, 90.0, 30.0, 30.0, 130.0]
	)
	task.probe(
		LabText.translate("fast target at (260, 80), coming with (-200, 0), speed 100"),
		[260.0, 80.0, -200.0, 0.0, 100.0]
	)
	task.probe(
		LabText.translate("target at (30, 40), at rest, speed 25"), [30.0, 40.0, 0.0, 0.0, 25.0]
	)
	(
		task
		. probe(
			LabText.translate("equal speeds, target at (100, 0), moving with (-30, 40), speed 50"),
			[100.0, 0.0, -30.0, 40.0, 50.0]
		)
		. special()
	)
	(
		task
		. probe(
			LabText.translate("target at (100, 0) that flees with (200, 0), speed 150"),
			[100.0, 0.0, 200.0, 0.0, 150.0]
		)
		. special()
	)
	(
		task
		. probe(
			LabText.translate("target at (100, 0) that passes with (0, 300), speed 100"),
			[100.0, 0.0, 0.0, 300.0, 100.0]
		)
		. special()
	)


# What both methods get wrong where they solve the equation; [param answer] makes an answer of the
# numbers and a time.
static func _add_roots(task: WorkshopTask, answer: Callable) -> void:
	task.way(
		0,
		LabText.translate("A time below 0 is in the past: take the smallest one that is not."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var roots := _roots(n, 1.0, 1.0)
			return answer.call(n, roots[0] if roots else INF)
	)
	task.way(
		0,
		LabText.translate("Two shots hit, and this is the later one: take the smaller time."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var roots := _roots(n, 1.0, 1.0)
			return answer.call(n, roots[-1] if roots and roots[-1] >= 0.0 else INF)
	)
	_add_where(
		task,
		LabText.translate("A negative discriminant is a miss: test it before the root."),
		answer,
		func(n: PackedFloat64Array) -> float: return NAN if n[3] == 300.0 else 0.0
	)
	var equal := LabText.translate("Equal speeds make a = 0, and a division by 0: then t = −c / b.")
	for wrong: float in [NAN, INF]:
		var way := _add_where(
			task,
			equal,
			answer,
			func(n: PackedFloat64Array) -> float: return wrong if n[4] == 50.0 else 0.0
		)
		if wrong == INF:
			way.only_named()


# A way that is right but where [param wrong] gives another time than 0.
static func _add_where(
	task: WorkshopTask, sentence: String, answer: Callable, wrong: Callable
) -> WorkshopWay:
	var way := task.way(
		0,
		sentence,
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var time: float = wrong.call(n)
			return answer.call(n, time if time != 0.0 else _first(_roots(n, 1.0, 1.0)))
	)
	return way.about_special()


static func _only_time(_n: PackedFloat64Array, time: float) -> PackedFloat64Array:
	return [time]


# The direction to where the target is after that time; (0, 0) for none.
static func _toward(n: PackedFloat64Array, time: float) -> PackedFloat64Array:
	if time == INF:
		return [0.0, 0.0]
	var x := n[0] + n[2] * time
	var y := n[1] + n[3] * time
	return [x / _length(x, y), y / _length(x, y)]


# The roots in order, with b and a multiplied by these factors; none where there is none.
static func _roots(
	n: PackedFloat64Array, factor_of_b: float, factor_of_a: float
) -> PackedFloat64Array:
	var a := (n[2] * n[2] + n[3] * n[3] - n[4] * n[4]) * factor_of_a
	var b := 2.0 * (n[0] * n[2] + n[1] * n[3]) * factor_of_b
	var c := n[0] * n[0] + n[1] * n[1]
	if a == 0.0:
		return [-c / b]
	var discriminant := b * b - 4.0 * a * c
	if discriminant < 0.0:
		return []
	var root := sqrt(discriminant)
	var found: PackedFloat64Array = [(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)]
	found.sort()
	return found


# The first one from 0 on; INF for none.
static func _first(roots: PackedFloat64Array) -> float:
	for root in roots:
		if root >= 0.0:
			return root
	return INF


static func _length(x: float, y: float) -> float:
	return sqrt(x * x + y * y)
