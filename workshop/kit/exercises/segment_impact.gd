class_name WorkshopSegmentImpact
extends RefCounted
## Exercise 11: the impact with a line that has two sides and ends.


## The exercise with its method.
static func exercise() -> WorkshopExercise:
	var made := WorkshopExercise.new(11, LabText.translate("Line ends"), "line_ends")
	made.tasks = [_task()]
	return made


static func _task() -> WorkshopTask:
	var task := WorkshopTask.new("MyImpact", "segment_impact", "vvfvv", "f")
	task.by(WorkshopReferenceImpact, "segment_impact")
	_add_probes(task)
	_add_ways_of_caps(task)
	_add_ways_of_lines(task)
	task.add_spoiling_way()
	return task


# The line is from (0, 0) to (100, 0); its normal points down, to positive y.
static func _add_probes(task: WorkshopTask) -> void:
	_probe(task, LabText.translate("onto the line"), [50, 30, 10, -40, 10])
	_probe(task, LabText.translate("onto the line from its other side"), [50, -30, 10, 40, 10])
	_probe(task, LabText.translate("onto an end, head on"), [-8, 0, 10, 0, 3])
	_probe(task, LabText.translate("onto an end, at an angle"), [-20, 25, 15, -30, 10])
	_probe(task, LabText.translate("onto the other end, at an angle"), [120, 25, -15, -30, 10])
	_probe(task, LabText.translate("onto an end, in small numbers"), [-0.8, 0, 1, 0, 0.3])
	_probe(task, LabText.translate("beside the line"), [140, 30, 0, -40, 10])
	_probe(task, LabText.translate("past an end, which it nearly touches"), [-12, 30, 0, -60, 10])
	_probe(task, LabText.translate("behind the ball, which moves away"), [50, 30, 0, 40, 10])
	_probe(task, LabText.translate("away from an end"), [-20, 0, -30, 0, 10])
	_probe(
		task,
		LabText.translate("fast onto the line, and beyond its end then"),
		[60, 40, 100, -60, 10]
	)
	_probe(
		task,
		LabText.translate("fast past the end, and above the line then"),
		[-60, 12, 100, -40, 10]
	)
	_probe(task, LabText.translate("too far for this frame"), [50, 100, 0, -40, 10])


static func _probe(task: WorkshopTask, title: String, numbers: Array[float]) -> void:
	var line: Array[float] = [0.0, 0.0, 100.0, 0.0]
	task.probe(title, numbers + line)


static func _add_ways_of_caps(task: WorkshopTask) -> void:
	var squared := LabText.translate("The discriminant is squared: its square root belongs there.")
	task.way(18, squared, _way({"root": "squared"}))
	task.way(18, squared, _way({"root": "squared", "unlimited": true})).only_named()
	var negative := LabText.translate("A negative discriminant is a miss: test it before the root.")
	task.way(19, negative, _way({"root": "untested"}))
	task.way(19, negative, _way({"root": "absolute"})).only_named()
	task.way(
		20,
		LabText.translate("The time is found from the new position: begin at the old one."),
		_way({"from_new": true})
	)
	task.way(
		23,
		LabText.translate("The ends are missing: a ball can hit them, too."),
		_way({"caps": "none"})
	)
	(
		task
		. way(
			23, LabText.translate("Only one end counts: the line has two."), _way({"caps": "end"})
		)
		. only_named()
	)
	(
		task
		. way(
			23, LabText.translate("Only one end counts: the line has two."), _way({"caps": "start"})
		)
		. only_named()
	)


static func _add_ways_of_lines(task: WorkshopTask) -> void:
	task.way(
		22,
		LabText.translate(
			"Whether it is beside the line is tested at the new position, not at the impact."
		),
		_way({"test_at": 1.0})
	)
	(
		task
		. way(
			22,
			LabText.translate(
				"Whether it is beside the line is tested at the old position, not at the impact."
			),
			_way({"test_at": 0.0})
		)
		. only_named()
	)
	var infinite := LabText.translate(
		"The line is taken as infinite: it ends, and a ball can pass beside it."
	)
	task.way(23, infinite, _way({"infinite": true, "caps": "none"}))
	task.way(23, infinite, _way({"infinite": true})).only_named()
	task.way(
		23,
		LabText.translate("The line has one side only: turn the normal to where the ball is."),
		_way({"one_sided": true})
	)


# A way of its own: `changes` says in what it differs from the right one.
static func _way(changes: Dictionary) -> Callable:
	return func(n: PackedFloat64Array) -> PackedFloat64Array:
		var t := _time_of_line(n, changes)
		if is_inf(t):
			t = _time_of_caps(n, changes)
		return [t]


static func _time_of_line(n: PackedFloat64Array, changes: Dictionary) -> float:
	var along := Vec2.new(n[7] - n[5], n[8] - n[6])
	var normal := along.normal()
	var offset := Vec2.new(n[0] - n[5], n[1] - n[6])
	if offset.dot(normal) < 0.0 and not changes.has("one_sided"):
		normal = normal.negated()
	var motion := Vec2.new(n[2], n[3])
	var old := offset.dot(normal)
	var approach := -motion.dot(normal)
	if not approach > 0.0:
		return INF
	var begin := old + motion.dot(normal) if changes.has("from_new") else old
	var t := (begin - n[4]) / approach
	if t > 1.0 or (t < 0.0 and not changes.has("from_new")):
		return INF
	var at: float = changes.get("test_at", t)
	var share := offset.plus(motion.scaled(at)).dot(along) / along.length_squared()
	return t if changes.has("infinite") or (share >= 0.0 and share <= 1.0) else INF


static func _time_of_caps(n: PackedFloat64Array, changes: Dictionary) -> float:
	var kind: String = changes.get("caps", "both")
	if kind == "none":
		return INF
	var end := _time_of_cap(n, n[7], n[8], changes)
	if kind == "end":
		return end
	var start := _time_of_cap(n, n[5], n[6], changes)
	if kind == "start":
		return start
	return start if is_nan(start) or (not is_nan(end) and start < end) else end


static func _time_of_cap(n: PackedFloat64Array, x: float, y: float, changes: Dictionary) -> float:
	var motion := Vec2.new(n[2], n[3])
	var d := Vec2.new(n[0] - x, n[1] - y)
	if changes.has("from_new"):
		d.add(motion)
	var a := motion.dot(motion)
	var b := 2.0 * d.dot(motion)
	var c := d.dot(d) - n[4] * n[4]
	if b >= 0.0 and not changes.has("from_new"):
		return INF
	var t := (-b - _root(b * b - 4.0 * a * c, changes)) / (2.0 * a)
	if changes.has("unlimited") or changes.has("from_new") or is_nan(t):
		return INF if t == -INF else t
	return t if t >= 0.0 and t <= 1.0 else INF


static func _root(discriminant: float, changes: Dictionary) -> float:
	match changes.get("root", ""):
		"squared":
			return discriminant * discriminant
		"untested":
			return sqrt(discriminant)
		"absolute":
			return sqrt(absf(discriminant))
	return sqrt(discriminant) if discriminant >= 0.0 else INF
