class_name WorkshopTimeOfImpact
extends RefCounted
## Exercise 8: the fraction of the frame after which a ball touches an infinite line.


## The exercise with its method.
static func exercise() -> WorkshopExercise:
	var made := WorkshopExercise.new(8, LabText.translate("Point of impact"), "point_of_impact")
	made.tasks = [_task()]
	return made


static func _task() -> WorkshopTask:
	var task := WorkshopTask.new("MyImpact", "time_of_impact", "fff", "f")
	task.by(WorkshopReferenceImpact, "time_of_impact")
	task.probe(LabText.translate("from 50 to -30, radius 10"), [50.0, -30.0, 10.0])
	task.probe(LabText.translate("from 50 to 5, radius 10"), [50.0, 5.0, 10.0])
	task.probe(LabText.translate("from 12 to 8, radius 10"), [12.0, 8.0, 10.0])
	task.probe(LabText.translate("parallel, from 30 to 30, radius 10"), [30.0, 30.0, 10.0])
	task.probe(LabText.translate("moving away, from 20 to 50, radius 10"), [20.0, 50.0, 10.0])
	task.probe(LabText.translate("too far, from 100 to 50, radius 10"), [100.0, 50.0, 10.0])
	task.probe(
		LabText.translate("behind the line, from -50 to -30, radius 10"), [-50.0, -30.0, 10.0]
	)
	task.probe(LabText.translate("rolling, from 10 to 10, radius 10"), [10.0, 10.0, 10.0]).special()
	_add_ratios(task)
	_add_limits(task)
	return task


static func _add_ratios(task: WorkshopTask) -> void:
	_add_both(
		task,
		15,
		LabText.translate("The ratio is wrong: divide old − radius by old − new."),
		func(n: PackedFloat64Array) -> float: return (n[0] - n[2]) / n[1]
	)
	_add_both(
		task,
		15,
		LabText.translate("This is old / new: it is (old − radius) / (old − new)."),
		func(n: PackedFloat64Array) -> float: return n[0] / n[1]
	)
	_add_both(
		task,
		16,
		LabText.translate("The distances have lost their signs: behind the line, new is negative."),
		func(n: PackedFloat64Array) -> float: return (absf(n[0]) - n[2]) / (absf(n[0]) - absf(n[1]))
	)
	_add_both(
		task,
		20,
		LabText.translate("The way to the contact begins at the old distance, not at the new one."),
		func(n: PackedFloat64Array) -> float: return (n[1] - n[2]) / (n[0] - n[1])
	)
	_add_both(
		task,
		0,
		LabText.translate("The radius is missing: the edge touches, not the centre."),
		func(n: PackedFloat64Array) -> float: return n[0] / (n[0] - n[1])
	)


static func _add_limits(task: WorkshopTask) -> void:
	var unlimited := LabText.translate(
		"The fraction is not limited: outside 0 to 1 there is no impact."
	)
	var clamped := LabText.translate(
		"The fraction is moved into 0 to 1: outside there is no impact at all."
	)
	task.way(
		17, unlimited, func(n: PackedFloat64Array) -> PackedFloat64Array: return [_fraction(n)]
	)
	task.way(
		17,
		LabText.translate("Below 0 there is no impact either: the ball moves away."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return [INF if _fraction(n) > 1.0 else _fraction(n)]
	)
	task.way(
		17,
		LabText.translate("Above 1 there is no impact either: the frame ends before."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return [INF if _fraction(n) < 0.0 else _fraction(n)]
	)
	task.way(
		17,
		clamped,
		func(n: PackedFloat64Array) -> PackedFloat64Array: return [clampf(_fraction(n), 0.0, 1.0)]
	)
	task.way(17, clamped, _clamped_but_parallel).only_named()
	var rolling := LabText.translate(
		"0 / 0 gives NaN where the ball rolls along: test old − new for 0 first."
	)
	task.way(17, rolling, _undefined_where_it_rolls).about_special()


# The way with its fraction limited to 0 to 1, and as it is.
static func _add_both(
	task: WorkshopTask, number: int, sentence: String, fraction: Callable
) -> void:
	task.way(number, sentence, _limited.bind(fraction))
	task.way(number, sentence, _unlimited.bind(fraction)).only_named()


static func _limited(n: PackedFloat64Array, fraction: Callable) -> PackedFloat64Array:
	var t: float = fraction.call(n)
	return [t if t >= 0.0 and t <= 1.0 else INF]


static func _unlimited(n: PackedFloat64Array, fraction: Callable) -> PackedFloat64Array:
	var t: float = fraction.call(n)
	return [t]


static func _clamped_but_parallel(n: PackedFloat64Array) -> PackedFloat64Array:
	return [INF if n[0] == n[1] else clampf(_fraction(n), 0.0, 1.0)]


static func _undefined_where_it_rolls(n: PackedFloat64Array) -> PackedFloat64Array:
	var t := _fraction(n)
	return [INF if t < 0.0 or t > 1.0 else t]


static func _fraction(n: PackedFloat64Array) -> float:
	return (n[0] - n[2]) / (n[0] - n[1])
