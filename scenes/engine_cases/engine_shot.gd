class_name EngineShot
extends RefCounted
## A ball's flight by the engine's own CharacterBody2D, frame by frame: half of the frame's gravity,
## then move_and_collide, with the rest of the motion bounced and used, then the other half. So it
## flies on the exact parabola, and only its bounces can part it from our ball. All positions are
## kept, so that any frame can be asked for again.

# A frame of the course, in seconds.
const _FRAME := 1.0 / 60.0

var _space: EngineSpace
var _body := CharacterBody2D.new()
var _velocity: Vector2
var _gravity: Vector2
var _bounciness: float
var _places: Array[Vec2] = []


## The flight of [param ball] among the lines of [param surroundings], in a physics space of its own
## below [param host], which must be in the tree.
func _init(host: Node, ball: Ball, surroundings: Surroundings) -> void:
	_space = EngineSpace.new(host)
	_space.add_walls(surroundings.segments, true)
	_space.add_ball(_body, ball)
	_velocity = ball.velocity.to_vector2()
	_gravity = surroundings.gravity.to_vector2()
	_bounciness = surroundings.bounciness
	_places = [ball.position.copy()]


## The position of the body after this many frames, 0 or more. Between two frames it is
## interpolated.
func place_at(frames: float) -> Vec2:
	while _places.size() <= ceili(frames):
		_step()
	var before := floori(frames)
	return _places[before].lerped(_places[ceili(frames)], frames - before)


## Frees the body and its space; the flight cannot go on.
func finish() -> void:
	_space.free()


func _step() -> void:
	_velocity += _gravity * (_FRAME / 2.0)
	var collision := _body.move_and_collide(_velocity * _FRAME)
	var contacts := 0
	while collision and contacts < EngineSpace.MOST_CONTACTS:
		var normal := collision.get_normal()
		_velocity = _bounced(_velocity, normal)
		contacts += 1
		collision = _body.move_and_collide(_bounced(collision.get_remainder(), normal))
	_velocity += _gravity * (_FRAME / 2.0)
	_places.append(Vec2.from_vector2(_body.position))


# The engine has `bounce` for C = 1 and `slide` for C = 0. Other values of C are interpolated.
func _bounced(vector: Vector2, normal: Vector2) -> Vector2:
	return vector.slide(normal).lerp(vector.bounce(normal), _bounciness)
