class_name BallRests
extends PartnerForecast
## When a ball comes to rest under gravity, and how it lies then.

## A ball whose bounces on a line would all be over within this time, in seconds, lies on it from
## the moment at which the last of them ends: 2 v / (g (1 - C)) after the bounce that it leaves with
## the normal speed v. That is the sum of all the bounces left, which are infinitely many.
const REST_TIME := 1e-9
## One that would be in the air for less than this time, in seconds, lies, too, whatever C is.
const REST_HOP := 1e-12
## A ball that cannot rise by more than this any more, in pixels, lies still where two lines hold
## it: there its bounces off both pile up, and no formula has their end.
const REST_HEIGHT := 1e-9
## How near the second one must be then, in pixels.
const REST_GAP := 1e-6
## Contacts whose normals differ by less than this, in radians, are one.
const LEAST_ANGLE := 1e-6

## Impacts so far, of balls with anything.
var impacts := 0
## Whether everything that happens is kept in [member events].
var keeps_events := false
## What has happened since [member keeps_events] was set, in order; may be cleared at any time.
var events: Array[WorldEvent] = []

var _bounciness := 1.0


func _rest_if_over(index: int, surface: int, speed: float, pressure: float) -> void:
	if _bounciness < 1.0 and _is_held_by_two(index):
		_lie_still(index, surface)
	elif pressure > 0.0:
		var least := maxf(REST_HOP, REST_TIME * (1.0 - _bounciness))
		if speed <= 0.5 * pressure * least:
			_rest(index, surface, speed, pressure)


# Whether a ball that can hardly rise touches something else, a line or a round end, so that both
# together hold it; the normal is that of the first one.
func _is_held_by_two(index: int) -> bool:
	var gravity := sqrt(_gravity_x * _gravity_x + _gravity_y * _gravity_y)
	if _squared_speed(index) > 2.0 * gravity * REST_HEIGHT:
		return false
	if _has_walls:
		for wall: int in [LEFT_WALL, RIGHT_WALL, TOP_WALL, BOTTOM_WALL]:
			if _holds_at(index, _nearest_on_wall(index, wall)):
				return true
	for place in _segments.places_near(_x[index], _y[index], _radius[index]):
		if _holds_at(index, _segments.nearest_point(place, _x[index], _y[index])):
			return true
	return false


# Whether the ball touches this point, and gravity lies between the normals of both contacts.
func _holds_at(index: int, point: Vec2) -> bool:
	var dx := _x[index] - point.x
	var dy := _y[index] - point.y
	var distance := sqrt(dx * dx + dy * dy)
	if distance > _radius[index] + REST_GAP or distance == 0.0:
		return false
	# Gravity, turned round, is one_share of the first normal and other_share of the other one.
	var area := _normal_x * dy - _normal_y * dx
	var one_share := (_gravity_y * dx - _gravity_x * dy) * area
	var other_share := (_normal_y * _gravity_x - _normal_x * _gravity_y) * area
	return absf(area) > LEAST_ANGLE * distance and one_share > 0.0 and other_share > 0.0


func _nearest_on_wall(index: int, wall: int) -> Vec2:
	match wall:
		LEFT_WALL:
			return Vec2.new(_left_x, _y[index])
		RIGHT_WALL:
			return Vec2.new(_right_x, _y[index])
		TOP_WALL:
			return Vec2.new(_x[index], _top_y)
	return Vec2.new(_x[index], _bottom_y)


# At rest for good, until something else touches it.
func _lie_still(index: int, surface: int) -> void:
	var event := _begin_event(index)
	_support[index] = surface
	_left_surface[index] = NOTHING
	_velocity_x[index] = 0.0
	_velocity_y[index] = 0.0
	_pull_x[index] = 0.0
	_pull_y[index] = 0.0
	_end_event(index, surface, event, WorldEvent.Kind.REST)


# All bounces left are summed up; then the ball lies or slides on the surface.
func _rest(index: int, surface: int, speed: float, pressure: float) -> void:
	var seconds := 0.0
	if _bounciness < 1.0:
		seconds = 2.0 * speed / (pressure * (1.0 - _bounciness))
	var event := _begin_event(index)
	_put_on(index, surface)
	_x[index] += (_velocity_x[index] + 0.5 * _pull_x[index] * seconds) * seconds
	_y[index] += (_velocity_y[index] + 0.5 * _pull_y[index] * seconds) * seconds
	_velocity_x[index] += _pull_x[index] * seconds
	_velocity_y[index] += _pull_y[index] * seconds
	_start[index] = time + seconds
	_start_low[index] = _time_low
	if event:
		event.time = time + seconds
	_end_event(index, surface, event, WorldEvent.Kind.REST)


# From now on the ball moves along the surface only; the normal must be known.
func _put_on(index: int, surface: int) -> void:
	var speed := _velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y
	var pressure := _gravity_x * _normal_x + _gravity_y * _normal_y
	_velocity_x[index] -= speed * _normal_x
	_velocity_y[index] -= speed * _normal_y
	_pull_x[index] = _gravity_x - pressure * _normal_x
	_pull_y[index] = _gravity_y - pressure * _normal_y
	_support[index] = surface
	_rolled_end[index] = Impact.Feature.LINE
	_left_surface[index] = NOTHING
	if surface >= 0:
		var distance := absf(_segments.signed_distance(surface, _x[index], _y[index]))
		_x[index] += (_radius[index] - distance) * _normal_x
		_y[index] += (_radius[index] - distance) * _normal_y
	elif surface == LEFT_WALL or surface == RIGHT_WALL:
		_x[index] = (_left_x if surface == LEFT_WALL else _right_x) + _radius[index] * _normal_x
	else:
		_y[index] = (_top_y if surface == TOP_WALL else _bottom_y) + _radius[index] * _normal_y


# On nothing, and pulled by gravity alone.
func _set_free(index: int) -> void:
	_support[index] = NOTHING
	_rolled_end[index] = Impact.Feature.LINE
	_left_surface[index] = NOTHING
	_pull_x[index] = _gravity_x
	_pull_y[index] = _gravity_y


func _is_weightless() -> bool:
	return _gravity_x == 0.0 and _gravity_y == 0.0


func _squared_speed(index: int) -> float:
	var x := _velocity_x[index]
	var y := _velocity_y[index]
	return x * x + y * y


func _begin_event(index: int) -> WorldEvent:
	if not keeps_events:
		return null
	var event := WorldEvent.new()
	event.time = time
	event.ball = index
	event.velocity_before = Vec2.new(_velocity_x[index], _velocity_y[index])
	events.append(event)
	return event


func _end_event(
	index: int, other: int, event: WorldEvent, kind: WorldEvent.Kind = WorldEvent.Kind.SEGMENT
) -> void:
	if not event:
		return
	event.kind = kind
	event.other = other
	if kind != WorldEvent.Kind.BALL and other < NOTHING:
		event.other = other - LEFT_WALL
		event.kind = WorldEvent.Kind.WALL if kind == WorldEvent.Kind.SEGMENT else kind
	event.normal = Vec2.new(_normal_x, _normal_y)
	event.point = Vec2.new(
		_x[index] - _radius[index] * _normal_x, _y[index] - _radius[index] * _normal_y
	)
	event.velocity_after = Vec2.new(_velocity_x[index], _velocity_y[index])
