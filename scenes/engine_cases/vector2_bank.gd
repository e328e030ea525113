class_name Vector2Bank
extends RefCounted
## Where to aim over walls, as users of Godot write it with Vector2, whose components have 32 bits.

## What is asked, in the lab's vectors.
var asked: BankQuestion

var _start: Vector2
var _target: Vector2
var _points: PackedVector2Array = []
var _normals: PackedVector2Array = []


func _init(question: BankQuestion) -> void:
	asked = question
	_start = question.start.to_vector2()
	_target = question.target.to_vector2()
	for wall in question.walls:
		var point := wall.start.to_vector2()
		var normal := point.direction_to(wall.end.to_vector2()).orthogonal()
		_points.append(point)
		_normals.append(normal * signf(normal.dot(_start - point)))


## At the nearest mirror image of the target.
func by_mirror_image() -> Vector2:
	return _start.direction_to(_nearest_image(_target, asked.bounces, -1))


## By how much a direction misses, in pixels.
func miss(direction: Vector2) -> float:
	return asked.miss(Vec2.from_vector2(direction))


func _nearest_image(of: Vector2, bounces: int, last: int) -> Vector2:
	if bounces == 0:
		return of
	var nearest := Vector2.INF
	for wall in _points.size():
		if wall != last:
			var height := _normals[wall].dot(of - _points[wall]) - asked.radius
			var image := of - _normals[wall] * (1.0 + 1.0 / asked.bounciness) * height
			var found := _nearest_image(image, bounces - 1, wall)
			if _start.distance_squared_to(found) < _start.distance_squared_to(nearest):
				nearest = found
	return nearest
