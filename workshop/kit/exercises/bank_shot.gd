class_name WorkshopBankShot
extends RefCounted
## Exercise 15: a shot over one line, and over two.

# Where the lines begin among the numbers of a probe.
const _LINE := 6
const _FIRST := 5
const _SECOND := 9
# Both ends of lines over which a ball bounces twice.
const _FLOOR: Array[float] = [-400.0, 300.0, 400.0, 300.0]
const _SLANTED: Array[float] = [400.0, 300.0, 200.0, -300.0]
const _STEEP: Array[float] = [-400.0, 300.0, -250.0, -300.0]


## The exercise with its methods.
static func exercise() -> WorkshopExercise:
	var made := WorkshopExercise.new(15, LabText.translate("Aiming over lines"), "bank_shot")
	made.tasks = [_once(), _twice()]
	return made


static func _once() -> WorkshopTask:
	var task := WorkshopTask.new("MyAim", "bank", "vvffvv", "v")
	task.by(WorkshopReferenceAim, "bank")
	task.probe(
		LabText.translate("from (100, 100) to (300, 160) over a floor, radius 20"),
		[100.0, 100.0, 300.0, 160.0, 20.0, 1.0, 0.0, 300.0, 500.0, 300.0]
	)
	task.probe(
		LabText.translate("the same with bounciness 0.5, the floor the other way round"),
		[100.0, 100.0, 300.0, 160.0, 20.0, 0.5, 500.0, 300.0, 0.0, 300.0]
	)
	task.probe(
		LabText.translate("from (100, 400) to (300, 500) over a slanted line, radius 10"),
		[100.0, 400.0, 300.0, 500.0, 10.0, 1.0, 0.0, 0.0, 400.0, 300.0]
	)
	task.probe(
		LabText.translate("from (300, 0) to (200, -150) over it, radius 10, bounciness 0.8"),
		[300.0, 0.0, 200.0, -150.0, 10.0, 0.8, 0.0, 0.0, 400.0, 300.0]
	)
	_add_ways_of_radius(task)
	_add_ways_of_mirror(task)
	_add_ways_of_direction(task)
	task.add_spoiling_way()
	return task


static func _add_ways_of_radius(task: WorkshopTask) -> void:
	task.way(
		0,
		LabText.translate("The radius is missing: the centre turns round before the line."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _toward(n, _image(n, _target(n), _LINE, 0.0, 1.0 + 1.0 / n[5]))
	)
	task.way(
		0,
		LabText.translate("The radius has the wrong sign: the mirror is on the ball's side."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _toward(n, _image(n, _target(n), _LINE, -n[4], 1.0 + 1.0 / n[5]))
	)
	task.way(
		0,
		LabText.translate("The normal must point to where the ball is: turn it round if not."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var radius := n[4] if _normal(n, _LINE).dot(_from_line(n, _LINE)) > 0.0 else -n[4]
			return _toward(n, _image(n, _target(n), _LINE, radius, 1.0 + 1.0 / n[5]))
	)


static func _add_ways_of_mirror(task: WorkshopTask) -> void:
	task.way(
		0,
		LabText.translate("With C below 1 the image is 1 / C times as far behind the line."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _toward(n, _image(n, _target(n), _LINE, n[4], 2.0))
	)
	task.way(
		0,
		LabText.translate("The factor is 1 + C: it is 1 + 1 / C."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _toward(n, _image(n, _target(n), _LINE, n[4], 1.0 + n[5]))
	)
	task.way(
		0,
		LabText.translate("The middle is right only where both are equally far from the line."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var foot := _image(n, _target(n), _LINE, n[4], 1.0)
			return _toward(n, foot.lerped(_image(n, _start(n), _LINE, n[4], 1.0), 0.5))
	)
	task.way(
		0,
		LabText.translate("The normal is not normalized: it must have length 1."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var normal := _facing(n, _LINE)
			normal.scale(Vec2.new(n[8] - n[6], n[9] - n[7]).length())
			var height := normal.dot(_target(n).minus(Vec2.new(n[6], n[7]))) - n[4]
			return _toward(n, _target(n).minus(normal.scaled((1.0 + 1.0 / n[5]) * height)))
	)


static func _add_ways_of_direction(task: WorkshopTask) -> void:
	task.way(
		0,
		LabText.translate("It aims straight at the target: aim at its mirror image."),
		func(n: PackedFloat64Array) -> PackedFloat64Array: return _toward(n, _target(n))
	)
	task.way(
		0,
		LabText.translate(
			"The start is not subtracted: the direction is that from start to image."
		),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _numbers(_image(n, _target(n), _LINE, n[4], 1.0 + 1.0 / n[5]).normalized())
	)
	task.way(
		0,
		LabText.translate("The direction does not have length 1: normalize it."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			var image := _image(n, _target(n), _LINE, n[4], 1.0 + 1.0 / n[5])
			return _numbers(image.minus(_start(n)))
	)


# Slanted pairs: at a right angle both orders give the same image.
static func _twice() -> WorkshopTask:
	var task := WorkshopTask.new("MyAim", "bank_twice", "vvfvvvv", "v")
	task.by(WorkshopReferenceAim, "bank_twice")
	_add_pair(
		task,
		LabText.translate("over a floor and a slanted line, radius 10"),
		[100.0, 200.0, 150.0, -50.0, 10.0],
		_FLOOR,
		_SLANTED
	)
	_add_pair(
		task,
		LabText.translate("over the slanted line and the floor, radius 10"),
		[150.0, -50.0, 100.0, 200.0, 10.0],
		_SLANTED,
		_FLOOR
	)
	_add_pair(
		task,
		LabText.translate("over a floor and a steep line on the left, radius 5"),
		[0.0, 200.0, -80.0, -100.0, 5.0],
		_FLOOR,
		_STEEP
	)
	task.way(
		0,
		LabText.translate("The order is wrong: mirror in the last line first, then go back."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _over(n, PackedInt32Array([_FIRST, _SECOND]), n[4])
	)
	task.way(
		0,
		LabText.translate("It is mirrored in the first line only: the ball bounces off both."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _over(n, PackedInt32Array([_FIRST]), n[4])
	)
	task.way(
		0,
		LabText.translate("It is mirrored in the second line only: the ball bounces off both."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _over(n, PackedInt32Array([_SECOND]), n[4])
	)
	task.way(
		0,
		LabText.translate("The radius is missing: the centre turns round before the line."),
		func(n: PackedFloat64Array) -> PackedFloat64Array:
			return _over(n, PackedInt32Array([_SECOND, _FIRST]), 0.0)
	)
	task.add_spoiling_way()
	return task


static func _add_pair(
	task: WorkshopTask,
	title: String,
	numbers: Array[float],
	first: Array[float],
	second: Array[float]
) -> void:
	task.probe(title, numbers + first + second)


# The direction to the target, mirrored in these lines one after the other.
static func _over(
	n: PackedFloat64Array, lines: PackedInt32Array, radius: float
) -> PackedFloat64Array:
	var image := _target(n)
	for line in lines:
		image = _image(n, image, line, radius, 2.0)
	return _toward(n, image)


# A point, moved by so many times its height along the normal on the side of the start.
static func _image(
	n: PackedFloat64Array, point: Vec2, line: int, radius: float, factor: float
) -> Vec2:
	var normal := _facing(n, line)
	var height := normal.dot(point.minus(Vec2.new(n[line], n[line + 1]))) - radius
	return point.minus(normal.scaled(factor * height))


static func _facing(n: PackedFloat64Array, line: int) -> Vec2:
	var normal := _normal(n, line)
	return normal if normal.dot(_from_line(n, line)) > 0.0 else normal.negated()


static func _normal(n: PackedFloat64Array, line: int) -> Vec2:
	return Vec2.new(n[line + 2] - n[line], n[line + 3] - n[line + 1]).normal()


static func _from_line(n: PackedFloat64Array, line: int) -> Vec2:
	return _start(n).minus(Vec2.new(n[line], n[line + 1]))


static func _start(n: PackedFloat64Array) -> Vec2:
	return Vec2.new(n[0], n[1])


static func _target(n: PackedFloat64Array) -> Vec2:
	return Vec2.new(n[2], n[3])


static func _toward(n: PackedFloat64Array, place: Vec2) -> PackedFloat64Array:
	return _numbers(place.minus(_start(n)).normalized())


static func _numbers(vector: Vec2) -> PackedFloat64Array:
	return [vector.x, vector.y]
