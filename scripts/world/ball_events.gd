class_name BallEvents
extends PartnerForecast
## What an event does to the balls it happens to: bounces, collisions, coming to rest, sliding off.

## A ball whose bounces on a line would all be over within this time, in seconds, lies on it from
## the moment at which the last of them ends: 2 v / (g (1 - C)) after the bounce that it leaves with
## the normal speed v. That is the sum of all the bounces left, which are infinitely many.
const REST_TIME := 1e-9
## Where nothing presses a ball on a line it leaves with at least this share of its speed along the
## normal, so that no rounding lets it meet the same line once more.
const LEAST_SHARE := 1.0 / 2.0 ** 50
## A ball that slides off the end of a segment goes on on another one if that is as near as this, in
## pixels, and as level, in radians.
const SEAM := 1e-9

## Impacts so far, of balls with anything.
var impacts := 0
## Whether everything that happens is kept in [member events].
var keeps_events := false
## What has happened since [member keeps_events] was set, in order; may be cleared at any time.
var events: Array[WorldEvent] = []

var _bounciness := 1.0
var _gravity_x := 0.0
var _gravity_y := 0.0


func _happen(index: int) -> void:
	var kind := _event_kind[index]
	if kind == TOUCH:
		_bounce(index)
		_forecast(index)
	elif kind == MEET:
		_collide(index, _event_with[index])
	elif kind == CROSS:
		_cells.cross(index)
		_forecast_crossing(index)
		_forecast_event(index)
	elif kind == LOOK_AGAIN:
		_forecast_event(index)
	elif kind == SLIDE_OFF:
		_slide_off(index)
		_forecast(index)


# A ball touches a wall or a segment.
func _bounce(index: int) -> void:
	impacts += 1
	_restart(index)
	var surface := _touched[index]
	var is_falling := _gravity_x != 0.0 or _gravity_y != 0.0
	if surface < NOTHING and not is_falling and not keeps_events:
		_bounce_off_wall(index, surface)
		return
	var event := _begin_event(index)
	_find_contact(index, surface)
	var approach := -(_velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y)
	if surface == _left_surface[index] and _is_line(index, surface):
		# It comes back as fast as it left: no digit is lost from bounce to bounce.
		approach = _left_speed[index]
	_leave(index, surface, maxf(approach, 0.0), event)


# The short way for the commonest case: a ball in straight flight, and a wall.
func _bounce_off_wall(index: int, wall: int) -> void:
	if wall == LEFT_WALL:
		_x[index] = _left_x + _radius[index]
		_velocity_x[index] *= -_bounciness
	elif wall == RIGHT_WALL:
		_x[index] = _right_x - _radius[index]
		_velocity_x[index] *= -_bounciness
	elif wall == TOP_WALL:
		_y[index] = _top_y + _radius[index]
		_velocity_y[index] *= -_bounciness
	else:
		_y[index] = _bottom_y - _radius[index]
		_velocity_y[index] *= -_bounciness


# Whether a ball that touches this surface touches a straight line, and not a round end.
func _is_line(index: int, surface: int) -> bool:
	return surface < NOTHING or _touched_feature[index] == Impact.Feature.LINE


# The unit normal of what a ball touches, towards the ball.
func _find_contact(index: int, surface: int) -> void:
	if _is_line(index, surface):
		_find_normal(index, surface)
		return
	var feature := _touched_feature[index] as Impact.Feature
	var dx := _x[index] - _segments.end_x(surface, feature)
	var dy := _y[index] - _segments.end_y(surface, feature)
	var distance := sqrt(dx * dx + dy * dy)
	_normal_x = dx / distance if distance > 0.0 else 0.0
	_normal_y = dy / distance if distance > 0.0 else 0.0


# The law of reflection, v + (1 + C) |v.n| n, for a ball that approaches with |v.n|; and whether it
# comes to rest on the surface.
func _leave(index: int, surface: int, approach: float, event: WorldEvent) -> void:
	var speed_squared := _squared_speed(index)
	var speed := _bounciness * approach
	_velocity_x[index] += (approach + speed) * _normal_x
	_velocity_y[index] += (approach + speed) * _normal_y
	if _bounciness == 1.0 and surface >= 0:
		_keep_speed(index, speed_squared)
	_support[index] = NOTHING
	_left_surface[index] = NOTHING
	_pull_x[index] = _gravity_x
	_pull_y[index] = _gravity_y
	var pressure := -(_gravity_x * _normal_x + _gravity_y * _normal_y)
	if pressure > 0.0:
		if _is_line(index, surface):
			_left_surface[index] = surface
			_left_speed[index] = speed
	else:
		_lift(index, speed, speed_squared)
	_end_event(index, surface, event)
	if pressure > 0.0 and speed <= 0.5 * REST_TIME * pressure * (1.0 - _bounciness):
		if _is_line(index, surface):
			_rest(index, surface, speed, pressure)


# A unit normal is rounded, always to the same side for the same line: scaled back to its length
# before the bounce, the velocity does not grow or shrink over a million bounces.
func _keep_speed(index: int, speed_squared: float) -> void:
	var now := _squared_speed(index)
	if now > 0.0:
		var factor := 1.0 + 0.5 * (speed_squared - now) / now
		_velocity_x[index] *= factor
		_velocity_y[index] *= factor


func _squared_speed(index: int) -> float:
	var x := _velocity_x[index]
	var y := _velocity_y[index]
	return x * x + y * y


# Where nothing presses the ball on the surface.
func _lift(index: int, speed: float, speed_squared: float) -> void:
	var missing := LEAST_SHARE * sqrt(speed_squared) - speed
	if missing > 0.0:
		_velocity_x[index] += missing * _normal_x
		_velocity_y[index] += missing * _normal_y


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
	_left_surface[index] = NOTHING
	if surface >= 0:
		var distance := absf(_segments.signed_distance(surface, _x[index], _y[index]))
		_x[index] += (_radius[index] - distance) * _normal_x
		_y[index] += (_radius[index] - distance) * _normal_y
	elif surface == LEFT_WALL or surface == RIGHT_WALL:
		_x[index] = (_left_x if surface == LEFT_WALL else _right_x) + _radius[index] * _normal_x
	else:
		_y[index] = (_top_y if surface == TOP_WALL else _bottom_y) + _radius[index] * _normal_y


# The segment ends under a sliding ball: another one goes on there, or the ball leaves.
func _slide_off(index: int) -> void:
	_restart(index)
	var old := _support[index]
	var event := _begin_event(index)
	_find_normal(index, old)
	_support[index] = NOTHING
	_pull_x[index] = _gravity_x
	_pull_y[index] = _gravity_y
	for place in _segments.places_near(_x[index], _y[index], _radius[index]):
		if place != old and _goes_on(index, place):
			_put_on(index, place)
			return
	_end_event(index, old, event, WorldEvent.Kind.LEAVE)


# Whether the ball touches this segment, too, and moves along it, pressed on it.
func _goes_on(index: int, place: int) -> bool:
	var distance := absf(_segments.signed_distance(place, _x[index], _y[index]))
	if absf(distance - _radius[index]) > SEAM:
		return false
	var slack := SEAM / _segments.length(place)
	var velocity_x := _velocity_x[index]
	var velocity_y := _velocity_y[index]
	# It must lie ahead: the ball comes from one of its ends.
	var ahead := SEAM * signf(velocity_x * velocity_x + velocity_y * velocity_y)
	var share := _segments.share_of(
		place, _x[index] + ahead * velocity_x, _y[index] + ahead * velocity_y
	)
	if share < -slack or share > 1.0 + slack:
		return false
	_find_normal(index, place)
	if _gravity_x * _normal_x + _gravity_y * _normal_y >= 0.0:
		return false
	var across := velocity_x * _normal_x + velocity_y * _normal_y
	return absf(across) <= SEAM * sqrt(_squared_speed(index))


# Two balls meet.
func _collide(one: int, other: int) -> void:
	impacts += 1
	_restart(one)
	_restart(other)
	var dx := _x[one] - _x[other]
	var dy := _y[one] - _y[other]
	var distance := sqrt(dx * dx + dy * dy)
	_normal_x = dx / distance if distance > 0.0 else 0.0
	_normal_y = dy / distance if distance > 0.0 else 0.0
	var event := _begin_event(one)
	var event_of_other := _begin_event(other)
	_exchange(one, other)
	_end_event(one, other, event, WorldEvent.Kind.BALL)
	_normal_x = -_normal_x
	_normal_y = -_normal_y
	_end_event(other, one, event_of_other, WorldEvent.Kind.BALL)
	_forget_surface(one)
	_forget_surface(other)
	_forecast(one)
	_forecast(other)


# Newton's laws along the normal, as in BallBounce.
func _exchange(one: int, other: int) -> void:
	var approach := (
		(_velocity_x[one] - _velocity_x[other]) * _normal_x
		+ (_velocity_y[one] - _velocity_y[other]) * _normal_y
	)
	if not approach < 0.0:
		return
	var share := -(1.0 + _bounciness) * approach / (_mass[one] + _mass[other])
	_velocity_x[one] += share * _mass[other] * _normal_x
	_velocity_y[one] += share * _mass[other] * _normal_y
	_velocity_x[other] -= share * _mass[one] * _normal_x
	_velocity_y[other] -= share * _mass[one] * _normal_y


# After a push: a ball that lay on something may be lifted off it or driven into it.
func _forget_surface(index: int) -> void:
	_left_surface[index] = NOTHING
	var surface := _support[index]
	if surface == NOTHING:
		return
	_find_normal(index, surface)
	var speed := _velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y
	if speed == 0.0:
		return
	_support[index] = NOTHING
	_pull_x[index] = _gravity_x
	_pull_y[index] = _gravity_y
	if speed > 0.0:
		_left_surface[index] = surface
		_left_speed[index] = speed
		return
	impacts += 1
	_touched_feature[index] = Impact.Feature.LINE
	_leave(index, surface, -speed, _begin_event(index))


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
