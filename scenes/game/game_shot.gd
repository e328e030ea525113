class_name GameShot
extends RefCounted
## A bullet on its way: it flies in the event world, and when it hits is computed as it is fired.

# A bullet is gone after so many seconds, or so far outside of the field, in pixels.
const _LONGEST := 5.0
const _OUTSIDE := 60.0
# So near counts as touching, in pixels.
const _NEARLY := 1e-6
# It is looked at in steps of so many seconds at most: a bounce may bring it near again.
const _LONGEST_STEP := 0.025
# The nearest of so many moments is looked for, then of so many around that one, and so on.
const _LOOKS := 12
const _ROUNDS := 3
# So many places of its way are drawn a second.
const _PLACES := 40.0

## When it was fired, in seconds since the level began.
var fired_at := 0.0
## Seconds from then until it hits; INF for a miss.
var hit_after := INF
## Seconds from then until it is gone.
var gone_after := _LONGEST
## Of a miss the smallest distance of the centres, in pixels.
var nearest := INF
## Where the target was then.
var passed: Vec2

var _flight: FiredShot
var _way: Array[Vec2] = []
# Without gravity it flies straight from bounce to bounce.
var _is_straight := false


## A bullet fired in [param direction] at [param now].
func _init(level: GameLevel, direction: Vec2, now: float) -> void:
	fired_at = now
	_is_straight = level.gravity.length() == 0.0
	_flight = fired(level, direction)
	_follow(level)


## How a bullet flies from the gun of [param level] in [param direction].
static func fired(level: GameLevel, direction: Vec2) -> FiredShot:
	var velocity := direction.scaled(GameLevel.SPEED)
	return FiredShot.new(level.gun, velocity, level.gravity, GameLevel.BULLET, level.walls)


## Where it is so many [param seconds] after it was fired, in pixels.
func place_after(seconds: float) -> Vec2:
	return _flight.place_after(seconds)


## Whether it has hit, or is gone, at this [param time] of the level.
func is_over(time: float) -> bool:
	return time - fired_at >= minf(hit_after, gone_after)


## The places through which it has flown in the first [param seconds], to be drawn. Asked for later
## and later moments, it looks only at what is new.
func way_until(seconds: float) -> Array[Vec2]:
	if _is_straight:
		return _flight.corners(seconds)
	while _way.size() / _PLACES <= seconds:
		_way.append(place_after(_way.size() / _PLACES))
	var found := _way.duplicate()
	found.append(place_after(seconds))
	return found


## The places through which a bullet in [param direction] goes in the first [param seconds], to be
## drawn.
static func way_of(level: GameLevel, direction: Vec2, seconds: float) -> Array[Vec2]:
	var flight := fired(level, direction)
	if level.gravity.length() == 0.0:
		return flight.corners(seconds)
	var found: Array[Vec2] = []
	for place in ceili(seconds * _PLACES):
		found.append(flight.place_after(place / _PLACES))
	found.append(flight.place_after(seconds))
	return found


# From moment to moment, each so near to the one before that bullet and target cannot have met in
# between: the fastest of both would need longer for what is between them.
func _follow(level: GameLevel) -> void:
	var fall := level.gravity.length() * _LONGEST
	var fastest := GameLevel.SPEED + fall + absf(level.target.speed)
	var moments: PackedFloat64Array = []
	var gaps: PackedFloat64Array = []
	var time := 0.0
	while time < _LONGEST:
		moments.append(time)
		gaps.append(_distance_after(time, level.target) - GameLevel.reach())
		if gaps[-1] < _NEARLY:
			hit_after = time
			return
		if _is_outside(place_after(time), level.gravity.length() > 0.0):
			break
		time += clampf(gaps[-1] / fastest, _NEARLY, _LONGEST_STEP)
	gone_after = moments[-1]
	for i in moments.size():
		var before := maxi(i - 1, 0)
		var behind := mini(i + 1, moments.size() - 1)
		if gaps[i] <= gaps[before] and gaps[i] <= gaps[behind]:
			_find_nearest(level.target, moments[before], moments[behind])


# Between two moments; forward in time in each round, because for the way back a bullet is flown
# anew.
func _find_nearest(target: GameTarget, from: float, to: float) -> void:
	var best := from
	for each in _ROUNDS:
		var step := (to - from) / _LOOKS
		var least := INF
		for look in _LOOKS + 1:
			var apart := _distance_after(from + step * look, target)
			if apart < least:
				least = apart
				best = from + step * look
		if least < nearest:
			nearest = least
			passed = target.place_at(fired_at + best)
		from = maxf(best - step, from)
		to = minf(best + step, to)


# From centre to centre.
func _distance_after(seconds: float, target: GameTarget) -> float:
	return place_after(seconds).distance_to(target.place_at(fired_at + seconds))


# One that flies high comes down again where it falls.
static func _is_outside(place: Vec2, falls: bool) -> bool:
	var width := GameLevel.FIELD_SIZE[0]
	var height := GameLevel.FIELD_SIZE[1]
	var is_beside := place.x < -_OUTSIDE or place.x > width + _OUTSIDE
	return is_beside or place.y > height + _OUTSIDE or place.y < -_OUTSIDE and not falls
