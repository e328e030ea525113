class_name BallPiles
extends RefCounted
## Which balls of a world lie in a pile, and what is known of those that are about to.
##
## THE RULE, where there is gravity and C is below 1. A ball is slow where it has no more than the
## speed that gravity gives within [constant LEAST_HOP]. It is held where two things that it
## touches, or one right below it, can carry it, or where it has been slow for [constant
## CREEP_TIME]. Balls that touch, all of them held and slow for [constant STILL_TIME], lie still
## together from an impact on in which gravity presses two of them on each other. What lies takes
## a slow push without moving; a faster one sets all free that lie there and touch each other. A
## ball with more than [constant CROWD] impacts within a hop is squeezed: at each further one, if
## it has touched what is supported within a hop, it loses half of its speed, and once it is slow
## it lies still for [constant WHILE], or, where it is not held, for [constant SHORT_WHILE], and
## then tries again.

## A ball loses no speed in an impact if it has met another ball within this time before, in
## seconds. Otherwise impacts among three balls that lose speed, or two and a wall, could follow
## each other without end (the TC model of Luding and McNamara, How to Handle the Inelastic
## Collapse, 1998).
const PILE_UP := 1e-6
## A ball that is driven into a wedge meets its two sides ever sooner. After this many touches, each
## within [constant PILE_UP] after one of another surface, it loses no more speed, and comes out.
const WEDGE_TOUCHES := 100
## The bounces of a ball on another one end in hops of this time, in seconds, in which no more speed
## is lost, until both lie. At 500 px/s² such a hop is 0.006 px high.
const LEAST_HOP := 1e-2
## Where nothing presses a ball on what it bounces off, it leaves with at least this share of its
## speed along the normal: then rounding cannot let it meet the same thing again at once.
const LEAST_SHARE := 1.0 / 2.0 ** 50
## Balls that have been slow for this time, in seconds, lie still. What slides with more than a
## fifth of the strength of gravity is faster after that.
const STILL_TIME := 0.05
## Balls that have been slow for this time, in seconds, count as held: squeezed balls can balance on
## each other for long. What slides with a fiftieth of gravity is faster after that.
const CREEP_TIME := 0.5
## A ball with more impacts than this within [constant LEAST_HOP] is squeezed. A higher number costs
## more impacts.
const CROWD := 20
## A squeezed ball that is held lies for this time, in seconds, before it tries again.
const WHILE := 0.05
## A squeezed ball that is not held lies for this time, in seconds: so it goes on to roll or slide.
const SHORT_WHILE := 0.5 * LEAST_HOP

## Stands for the surface that a ball in a pile lies on, whatever else holds it.
const ON_BALLS := -6

const _NO_SURFACE := -1
# Normals that differ by less, in radians, count as one.
const _LEAST_ANGLE := 1e-6

## What counts as slow: up to this speed, in px/s; 0 where nothing comes to lie in piles.
var slow_speed := 0.0
## For how long the ball of the last [method is_hurried] has flown since it touched the same
## surface, in seconds; INF where it has touched something else.
var since_last_touch := INF

# C, 0..1.
var _bounciness := 1.0
# The arrays of the world, which are never assigned anew.
var _is_there: PackedByteArray
var _radius: PackedFloat64Array
var _velocity_x: PackedFloat64Array
var _velocity_y: PackedFloat64Array
var _support: PackedInt32Array
# Since when each ball has been slow, in seconds.
var _slow_since: PackedFloat64Array = []
# When the present count of impacts began, in seconds, and the impacts since then.
var _crowd_from: PackedFloat64Array = []
var _crowd: PackedInt32Array = []
# When the ball, or one that it met, last touched what is supported, in seconds.
var _grounded_at: PackedFloat64Array = []
# The surface that a ball touched last, and how many touches of other surfaces than the one before
# have followed each other within PILE_UP.
var _last_touched: PackedInt32Array = []
var _hurried: PackedInt32Array = []
# Whether the two balls that met last overlap by more than the height of a hop.
var _are_overlapping := false
# Until when a ball lies, in seconds; INF where only a push ends it.
var _lies_until: PackedFloat64Array = []


func _init(
	is_there: PackedByteArray,
	radius: PackedFloat64Array,
	velocity_x: PackedFloat64Array,
	velocity_y: PackedFloat64Array,
	support: PackedInt32Array
) -> void:
	_is_there = is_there
	_radius = radius
	_velocity_x = velocity_x
	_velocity_y = velocity_y
	_support = support


## Takes this gravity, in px/s², and this C, 0..1.
func set_up(gravity_x: float, gravity_y: float, bounciness: float) -> void:
	slow_speed = 0.0
	_are_overlapping = false
	_bounciness = bounciness
	if bounciness < 1.0:
		slow_speed = LEAST_HOP * sqrt(gravity_x * gravity_x + gravity_y * gravity_y)


## Makes room for this many balls.
func resize(count: int) -> void:
	for numbers: PackedFloat64Array in [_slow_since, _crowd_from, _lies_until, _grounded_at]:
		numbers.resize(count)
	for numbers: PackedInt32Array in [_crowd, _last_touched, _hurried]:
		numbers.resize(count)


## All arrays, for snapshots.
func arrays() -> Array:
	return [_slow_since, _crowd_from, _crowd, _lies_until, _grounded_at, _last_touched, _hurried]


## A ball begins at [param time], in seconds, as if nothing had been before.
func forget(index: int, time: float) -> void:
	_slow_since[index] = time
	_crowd[index] = 0
	_hurried[index] = 0
	_last_touched[index] = _NO_SURFACE
	_grounded_at[index] = -INF


## A ball meets another one at [param time].
func count_meeting(index: int, time: float) -> void:
	if time - _crowd_from[index] > LEAST_HOP or _crowd[index] == 0:
		_crowd_from[index] = time
		_crowd[index] = 0
	_crowd[index] += 1


## Notes that a ball touches a surface after this time of flight, in seconds; says whether that is
## one of too many hurried touches: see [constant WEDGE_TOUCHES].
func is_hurried(index: int, surface: int, seconds: float) -> bool:
	var hurries := false
	since_last_touch = seconds if surface == _last_touched[index] else INF
	if seconds >= PILE_UP:
		_hurried[index] = 0
	elif surface != _last_touched[index]:
		_hurried[index] += 1
		hurries = _hurried[index] > WEDGE_TOUCHES
	_last_touched[index] = surface
	return hurries


## Whether the last touch of a ball was one of too many hurried ones.
func is_hurried_now(index: int) -> bool:
	return _hurried[index] > WEDGE_TOUCHES


## Two balls meet at [param time], with their centres this far apart, in pixels; gravity may press
## them on each other.
func note_meeting(one: int, other: int, distance: float, is_pressed: bool, time: float) -> void:
	_are_overlapping = distance < _radius[one] + _radius[other] - touch_gap()
	for index: int in [one, other]:
		if not lies(index):
			count_meeting(index, time)
	var grounded := time if is_pressed else maxf(_grounded_at[one], _grounded_at[other])
	_grounded_at[one] = grounded
	_grounded_at[other] = grounded


## A ball touches a surface. That counts only if it has met another ball just before: a ball for
## itself is never squeezed.
func count_touch(index: int, time: float) -> void:
	_grounded_at[index] = time
	if _crowd[index] > 0:
		count_meeting(index, time)
		if _crowd[index] == 1:
			_crowd[index] = 0


## The speed with which the two balls that met last part, if a pull presses them together, in px/s:
## not so slow that the hop is shorter than [constant LEAST_HOP], but no faster than the approach,
## unless there was almost none: then [param part] of it, 0..1, so that a heavy ball gets no more
## energy from a light one that lies than if both hopped. Balls that overlap get nothing then: they
## would meet again at the top of each hop, and climb out of each other.
func hop_speed(speed: float, approach: float, pressure: float, part: float = 1.0) -> float:
	var least := 0.5 * pressure * LEAST_HOP
	if speed >= least:
		return speed
	if approach > 1e-3 * least or _are_overlapping:
		return minf(approach, least)
	return least * part


## Whether a ball lies and takes the push of another one without moving; the unit normal points to
## the other one.
func takes_push(lying: int, other: int, normal_x: float, normal_y: float) -> bool:
	if not lies(lying):
		return false
	return -(_velocity_x[other] * normal_x + _velocity_y[other] * normal_y) <= slow_speed


## Lets a ball bounce off one that lies and takes its push. Gravity presses it there with
## [param pressure], in px/s²; for [param part] see [method hop_speed]. Gives the push of the one
## that lies, in px/s.
func hop_off(index: int, normal_x: float, normal_y: float, pressure: float, part: float) -> float:
	var x := _velocity_x[index]
	var y := _velocity_y[index]
	var approach := maxf(-(x * normal_x + y * normal_y), 0.0)
	var speed := hop_speed(_bounciness * approach, approach, pressure, part)
	speed = maxf(speed, LEAST_SHARE * sqrt(x * x + y * y))
	x += (approach + speed) * normal_x
	y += (approach + speed) * normal_y
	# What is too slow for its square to be held would approach for ever by rounding.
	var is_moving := x * x + y * y > 0.0
	_velocity_x[index] = x if is_moving else 0.0
	_velocity_y[index] = y if is_moving else 0.0
	return approach + speed


## Whether too many impacts have followed each other.
func is_squeezed(index: int, time: float) -> bool:
	return _crowd[index] > CROWD and time - _grounded_at[index] <= LEAST_HOP


## Notes how fast a ball is at [param time], where a flight of it begins; says whether it is slow.
func note_speed(index: int, time: float) -> bool:
	var x := _velocity_x[index]
	var y := _velocity_y[index]
	if x * x + y * y > slow_speed * slow_speed:
		_slow_since[index] = time
		return false
	return true


## Whether a ball lies in a pile, for a while or until a push.
func lies(index: int) -> bool:
	return _support[index] == ON_BALLS


## From now on a ball lies until this time, in seconds; INF until a push. After that its impacts
## are counted anew.
func lie_until(index: int, time: float) -> void:
	_lies_until[index] = time
	_crowd[index] = 0


## Until when a ball lies, in seconds, if no push comes.
func end_of_lying(index: int) -> float:
	return _lies_until[index]


## How near balls are that touch, in pixels: within the height of a hop.
func touch_gap() -> float:
	return 0.5 * slow_speed * LEAST_HOP


## All balls that lie and touch this one, or touch one that does; [param index] itself is the first.
## [param places] holds x and y of all balls now, in pixels.
func lying_with(index: int, places: PackedFloat64Array) -> PackedInt32Array:
	var found: PackedInt32Array = [index]
	var place := 0
	while place < found.size():
		for other in _radius.size():
			if _is_there[other] == 0 or not lies(other) or found.has(other):
				continue
			if _are_touching(found[place], other, places):
				found.append(other)
		place += 1
	return found


## The balls that could come to lie still with this one at [param time]: all that touch it and are
## not asleep, or touch one of these. Empty where not all of them have been slow for long enough.
func still_with(index: int, time: float, places: PackedFloat64Array) -> PackedInt32Array:
	var found: PackedInt32Array = [index]
	var place := 0
	while place < found.size():
		var one := found[place]
		place += 1
		if not has_been_slow(one, time):
			return []
		for other in _radius.size():
			if _is_there[other] == 0 or is_asleep(other) or found.has(other):
				continue
			if _are_touching(one, other, places):
				found.append(other)
	return found


## Whether two things that a ball touches, or one right below it, could hold it: their normals
## enclose the direction against gravity, which is given in px/s². [param points] are the nearest
## ones of what else is around. Whether the forces of all balls are in balance is not asked.
func is_held(index: int, places: PackedFloat64Array, points: Array[Vec2], gravity: Vec2) -> bool:
	var centre := Vec2.new(places[2 * index], places[2 * index + 1])
	var up := gravity.scaled(-1.0 / gravity.length())
	# The least tilt of a normal to the left and to the right of the direction against gravity.
	var to_left := INF
	var to_right := INF
	for normal in _normals_at(index, centre, places, points):
		var across := up.cross(normal)
		if absf(across) <= _LEAST_ANGLE and up.dot(normal) > 0.0:
			return true
		var angle := atan2(absf(across), up.dot(normal))
		if across > 0.0:
			to_left = minf(to_left, angle)
		else:
			to_right = minf(to_right, angle)
	return to_left + to_right < PI - _LEAST_ANGLE


# The unit normals, towards the ball, of all that it touches.
func _normals_at(
	index: int, centre: Vec2, places: PackedFloat64Array, points: Array[Vec2]
) -> Array[Vec2]:
	var normals: Array[Vec2] = []
	for point in points:
		var away := centre.minus(point)
		if away.length() <= _radius[index] + touch_gap() and away.length() > 0.0:
			normals.append(away.normalized())
	for other in _radius.size():
		var is_other := _is_there[other] == 1 and other != index
		if is_other and _are_touching(index, other, places):
			var away := centre.minus(Vec2.new(places[2 * other], places[2 * other + 1]))
			normals.append(away.normalized())
	return normals


## Whether the flights of a ball have begun slowly for [param seconds] until [param time].
func has_been_slow(index: int, time: float, seconds: float = STILL_TIME) -> bool:
	return time - _slow_since[index] >= seconds


## Whether a ball lies until a push.
func is_asleep(index: int) -> bool:
	return lies(index) and _lies_until[index] == INF


func _are_touching(one: int, other: int, places: PackedFloat64Array) -> bool:
	var reach := _radius[one] + _radius[other] + touch_gap()
	var dx := places[2 * one] - places[2 * other]
	var dy := places[2 * one + 1] - places[2 * other + 1]
	return dx * dx + dy * dy <= reach * reach
