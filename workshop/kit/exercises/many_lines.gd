class_name WorkshopManyLines
extends RefCounted
## Exercise 10: a ball among many lines, assignment 4. Each line's normal points to the ball, so
## that a solution for lines with one side passes, and none ends near it.

const _FRAME := 1.0 / 60.0
const _MOST_BOUNCES := 20


## The exercise with its method.
static func exercise() -> WorkshopExercise:
	var made := WorkshopExercise.new(10, LabText.translate("A ball among lines"), "angled_lines")
	made.tasks = [_task()]
	return made


static func _task() -> WorkshopTask:
	var task := WorkshopTask.new("MyBounce", "step", "BLf", "B")
	task.by(WorkshopReferenceBounce, "step")
	_add_probes(task)
	_add_gravity_probes(task)
	_add_ways(task)
	_add_ways_of_gravity(task)
	task.add_spoiling_way()
	return task


static func _add_probes(task: WorkshopTask) -> void:
	var near: Array[float] = [50, -900, 50, 900]
	var far: Array[float] = [150, -900, 150, 900]
	var left: Array[float] = [-60, 900, -60, -900]
	var angled: Array[float] = [-400, 500, 500, -400]
	_probe(task, LabText.translate("a free flight"), [0, 0, 60, 90, 10, 0, 0], far, 0.1)
	_probe(task, LabText.translate("one wall"), [0, 0, 450, 120, 10, 0, 0], near, 0.1)
	_probe(task, LabText.translate("an angled line"), [10, 20, 500, 300, 10, 0, 0], angled, 0.2)
	_probe(
		task, LabText.translate("two walls in its way"), [0, 0, 3000, 0, 10, 0, 0], near + far, 0.1
	)
	_probe(
		task, LabText.translate("between two walls"), [0, 0, 3000, 0, 10, 0, 0], near + left, 0.1
	)
	_probe(
		task,
		LabText.translate("touching a wall, moving away"),
		[-51, 0, 60, 30, 10, 0, 0],
		left,
		0.1
	)


static func _add_gravity_probes(task: WorkshopTask) -> void:
	var ground: Array[float] = [900, 400, -900, 400]
	var falling := LabText.translate("falling onto a floor")
	_probe(task, falling, [0, 389, 40, 300, 10, 0, 600], ground, _FRAME).special().to_within(1e-3)
	var lasting := LabText.translate(
		"ten seconds of bouncing: its energy at the end, 1 at the start"
	)
	var bouncing := _probe(task, lasting, [0, 370, 0, 0, 10, 0, 1000], ground, _FRAME)
	bouncing.special().to_within(0.05).repeated(600)


static func _probe(
	task: WorkshopTask, title: String, ball: Array[float], lines: Array[float], seconds: float
) -> WorkshopProbe:
	var time: Array[float] = [seconds]
	return task.probe(title, ball + lines + time)


static func _add_ways(task: WorkshopTask) -> void:
	task.way(
		24,
		LabText.translate("The rest of the frame is lost after a bounce: fly on for what is left."),
		_way({"ends": true})
	)
	(
		task
		. way(
			24,
			LabText.translate(
				"Only one bounce is followed: what is left of the frame may hold another."
			),
			_way({"once": true})
		)
		. only_named()
	)
	task.way(
		21,
		LabText.translate("The last line that is hit counts: take the earliest hit."),
		_way({"last": true})
	)
	task.way(
		14,
		LabText.translate("It bounces while it moves away already: that makes it stick."),
		_way({"always": true})
	)
	task.way(
		0,
		LabText.translate(
			"It looks only where the ball is after the frame: a fast one gets through."
		),
		_way({"late": true})
	)
	task.way(
		0,
		LabText.translate("It flies through the lines: nothing bounces yet."),
		_way({"through": true})
	)


static func _add_ways_of_gravity(task: WorkshopTask) -> void:
	var sentence := (
		LabText
		. translate(
			"All of the frame's gravity is added at once: only its part up to the bounce counts before it."
		)
	)
	task.way(26, sentence, _way({"gravity": "first"})).about_special()
	task.way(26, sentence, _way({"gravity": "last"})).about_special().only_named()
	(
		task
		. way(
			0,
			LabText.translate("The acceleration is not used: gravity must change the velocity."),
			_way({"gravity": "none"})
		)
		. about_special()
	)


# A way of its own: `changes` says in what it differs from the right one.
static func _way(changes: Dictionary) -> Callable:
	return func(n: PackedFloat64Array) -> PackedFloat64Array:
		var position := Vec2.new(n[0], n[1])
		var velocity := Vec2.new(n[2], n[3])
		_move(position, velocity, n, changes)
		return [position.x, position.y, velocity.x, velocity.y]


static func _move(
	position: Vec2, velocity: Vec2, n: PackedFloat64Array, changes: Dictionary
) -> void:
	var lines := _lines(n)
	var left := n[-1]
	var kind: String = changes.get("gravity", "")
	var pull := Vec2.new(n[5], n[6])
	if kind == "first":
		velocity.add(pull.scaled(left))
	var acting := pull if kind == "" else Vec2.new()
	if changes.has("always") and _bounce_where_it_overlaps(position, velocity, n[4], lines):
		lines.clear()
	for bounce in _MOST_BOUNCES:
		var motion := FreeFlight.motion(velocity, acting, left)
		var impact := _impact(position, motion, n[4], lines, changes)
		if not impact.hit or (changes.has("once") and bounce > 0):
			position.add(motion)
			velocity.add(acting.scaled(left))
			break
		position.add(motion.scaled(impact.fraction))
		velocity.add(acting.scaled(left * impact.fraction))
		Bounce.apply(velocity, impact.normal)
		left *= 1.0 - impact.fraction
		if changes.has("ends"):
			break
	if kind == "last":
		velocity.add(pull.scaled(n[-1]))
	if changes.has("late"):
		_bounce_where_it_overlaps(position, velocity, n[4], lines, true)


static func _lines(n: PackedFloat64Array) -> Array[LineSegment]:
	var lines: Array[LineSegment] = []
	for at in range(7, n.size() - 1, 4):
		lines.append(LineSegment.new(Vec2.new(n[at], n[at + 1]), Vec2.new(n[at + 2], n[at + 3])))
	return lines


static func _impact(
	position: Vec2, motion: Vec2, radius: float, lines: Array[LineSegment], changes: Dictionary
) -> Impact:
	if changes.has("late") or changes.has("through"):
		return Impact.miss(Impact.Outcome.TOO_FAR)
	if not changes.has("last"):
		return SegmentImpact.with_segments(position, motion, radius, lines)
	var last := Impact.miss(Impact.Outcome.TOO_FAR)
	for line in lines:
		var impact := SegmentImpact.with_segment(position, motion, radius, line)
		if impact.hit:
			last = impact
	return last


static func _bounce_where_it_overlaps(
	position: Vec2,
	velocity: Vec2,
	radius: float,
	lines: Array[LineSegment],
	puts_back: bool = false
) -> bool:
	var overlapped := false
	for line in lines:
		var away := position.minus(line.closest_point(position))
		if away.length() < radius - 1e-9:
			overlapped = true
			var normal := away.normalized()
			if puts_back:
				position.add(normal.scaled(radius - away.length()))
			if not puts_back or Bounce.is_approaching(velocity, normal):
				velocity.reflect(normal)
	return overlapped
