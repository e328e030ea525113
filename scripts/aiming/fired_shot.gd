class_name FiredShot
extends RefCounted
## A shot as it flies, in the event world: where the bullet is at any time, and by how much it
## misses.

var _bullet: Ball
var _gravity: Vec2
var _walls: Array[LineSegment]
var _bounciness: float
var _world := EventWorld.new()


## A bullet from [param start], in pixels, with its whole [param velocity] in px/s, so with that of
## a moving shooter, too. [param gravity] is in px/s². It bounces off [param walls] with its
## [param radius] and [param bounciness]. What cannot be flown is an error, and the bullet rests.
func _init(
	start: Vec2,
	velocity: Vec2,
	gravity := Vec2.zero(),
	radius: float = 1.0,
	walls: Array[LineSegment] = [],
	bounciness: float = 1.0
) -> void:
	_bullet = Ball.new(start.copy(), radius, velocity.copy())
	_gravity = gravity.copy()
	_walls = walls
	_bounciness = bounciness
	_load()


## Where the bullet is so many [param seconds] after the shot, in pixels.
func place_after(seconds: float) -> Vec2:
	if seconds < _world.time:
		_load()
	_tell(_world.advance_to(seconds))
	return _world.position(0)


## Where the bullet is at the start, at each bounce until so many [param seconds] after the shot,
## and then. Without gravity it flies straight from one to the next.
func corners(seconds: float) -> Array[Vec2]:
	_load()
	_world.keeps_events = true
	var found: Array[Vec2] = [_bullet.position.copy()]
	var end := place_after(seconds)
	for event in _world.events:
		found.append(event.point.plus(event.normal.scaled(_bullet.radius)))
	found.append(end)
	return found


## How far the bullet's centre is from the target's so many [param seconds] after the shot, in
## pixels.
func distance_after(seconds: float, place: Callable) -> float:
	var there: Vec2 = place.call(seconds)
	return place_after(seconds).distance_to(there)


func _load() -> void:
	_world = EventWorld.new()
	_tell(_world.set_gravity(_gravity))
	_tell(_world.set_bounciness(_bounciness))
	_tell(_world.set_segments(_walls))
	var refusal := _world.set_balls([_bullet])
	if refusal:
		_tell(refusal)
		_tell(_world.set_balls([Ball.new(Vec2.zero(), 1.0)]))


static func _tell(refusal: String) -> void:
	if refusal:
		push_error(refusal)
