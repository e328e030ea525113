class_name PassedTarget
extends RefCounted
## How a ball that is shot at some angle passes its target after so many bounces: off which walls,
## and on which side.

## In radians.
var angle := 0.0
## The walls off which it bounced, in order; a bounce off an end is none.
var walls: PackedInt32Array = []
## How far the target is to the side of its last way, in pixels; NAN where the ball does not come so
## far.
var beside := NAN
## How far it has flown when the target is beside it, in pixels at the speed of the start.
var distance := INF

var _finder := StraightImpactFinder.new()
var _flown := 0.0
var _seconds := INF
var _wall := -1
var _is_end := false
var _normal: Vec2


## The ball 0 of this world, shot at [param at_angle], and its ball 1 as the target.
static func of(world: FuzzWorld, at_angle: float, bounces: int) -> PassedTarget:
	var passed := PassedTarget.new()
	passed.angle = at_angle
	passed._fly(world, bounces)
	return passed


## Whether both bounced off the same walls and then passed on different sides.
func passes_otherwise(other: PassedTarget) -> bool:
	return walls == other.walls and beside * other.beside <= 0.0


func _fly(world: FuzzWorld, bounces: int) -> void:
	var at := world.balls[0].position.copy()
	var velocity := Vec2.unit_radians(angle)
	var target := world.balls[1].position
	for bounce: int in bounces + 1:
		_find_next(world, at, velocity)
		if bounce == bounces:
			var until := target.minus(at).dot(velocity) / velocity.length_squared()
			if until > 0.0 and until <= _seconds:
				beside = velocity.normalized().cross(target.minus(at))
				distance = _flown + until
			return
		if _seconds == INF or _is_end:
			return
		walls.append(_wall)
		_flown += _seconds
		at.add(velocity.scaled(_seconds))
		velocity.reflect(_normal, world.bounciness)


# The next impact: when, with which wall, and whether with an end of it.
func _find_next(world: FuzzWorld, at: Vec2, velocity: Vec2) -> void:
	var radius := world.balls[0].radius
	_seconds = INF
	for index: int in world.lines.size():
		var a := world.lines[index].start
		var b := world.lines[index].end
		var is_hit := _finder.with_segment(
			at.x, at.y, velocity.x, velocity.y, radius, a.x, a.y, b.x, b.y
		)
		if is_hit and _finder.time < _seconds:
			_seconds = _finder.time
			_wall = index
			_is_end = _finder.feature != Impact.Feature.LINE
			_normal = Vec2.new(_finder.normal_x, _finder.normal_y)
