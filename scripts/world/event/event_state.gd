class_name EventState
extends RefCounted
## All that an [EventWorld] knows: its balls and their flights, what they fly among, what comes next
## for each of them, and what is kept between events. Every field of the world is declared here,
## with its unit and with the class that writes it.
##
## A ball in flight is known by where and when its flight began: place, velocity and a constant
## acceleration. Nothing is moved while time passes; where a ball is now is worked out when somebody
## asks. The numbers of the balls are in packed arrays, with the ball's place as the index, because
## the loops of the world are fast only so. They are fields of the world itself and not of an object
## beside it: a short method takes 136 ns with its own fields and 241 ns with another object's.
##
## A time is the sum of two doubles; the second one is smaller than the last place of the first.
## After 100 s and thousands of impacts a single double would be off by some 1e-12 s, which is
## 1e-8 px for a ball of 30 000 px/s. A field `..._low` holds the second one.

## The surfaces that are no segments, whose places are 0 or more; the one that a ball in a pile has.
enum {
	ON_BALLS = BallPiles.ON_BALLS,
	LEFT_WALL = Slopes.LEFT_WALL,
	RIGHT_WALL = Slopes.RIGHT_WALL,
	TOP_WALL = Slopes.TOP_WALL,
	BOTTOM_WALL = Slopes.BOTTOM_WALL
}

## What an event is: the ball touches a surface, it meets another ball, it has to look for a partner
## again, it slides to the end of the segment under it, a piece of its way over a cap is over, it
## has lain in a pile for a while, it does not slip any more on what supports it, what supports it
## begins to move otherwise, or it is crushed.
enum { TOUCH, MEET, LOOK_AGAIN, SLIDE_OFF, FOLLOW_CAP, TRY_AGAIN, END_SLIP, SUPPORT_TURNS, CRUSH }

## What is touched where nothing is touched: no surface, no ball.
const NOTHING := -1
## Stands for the surface of a ball that has been crushed.
const CRUSHED := ON_BALLS - 1

# === What a user of the world reads and sets. EventWorld writes it; BounceLaws counts impacts.

## Seconds since the start. Read it; [method EventWorld.advance] changes it.
var time := 0.0
## x and y of all balls' centres as of the [member EventWorld.moment] last set, in pixels, one after
## the other. It stays one array, however many balls come or go: a caller holds it once and reads it
## after each moment, without a call. Read it; what is written into it lasts until the next moment.
## A place without a ball holds where the ball was when it was removed.
var places: PackedFloat64Array:
	get:
		return _places
	set(_value):
		Refusal.push("The places of an EventWorld are read only; change_ball moves a ball.")
## Impacts so far, of balls with anything.
var impacts := 0
## More impacts than this within one second of the world are refused by [method EventWorld.advance]:
## between two walls that touch a ball on both sides they would never end. At least 1.
var most_impacts_per_second := 1_000_000
## Whether a flight is compared only with the segments near it (true), or with all; the answers are
## the same. To be set before the first segment.
var uses_grid := true:
	set = _set_uses_grid
## Whether everything that happens is kept in [member events].
var keeps_events := false
## What has happened since [member keeps_events] was set, in order; may be cleared at any time.
var events: Array[WorldEvent]:
	get:
		return _log.events
	set(value):
		_log.events = value

# The classes that extend this one use these fields.
@warning_ignore_start("unused_private_class_variable")

# === The time and the counts. EventWorld writes them.

# The second part of [member time].
var _time_low := 0.0
# Where the present second of the count of impacts began, and how many there were before.
var _count_from := 0.0
var _counted_impacts := 0
# No event is earlier than this, in seconds; -INF where that has to be looked up.
var _quiet_until := -INF
# Whether balls, segments, walls, gravity, bounciness or friction have been changed since time last
# passed.
var _has_changed := false
# The number of changes of segments, walls, gravity, bounciness and friction; a snapshot notes it.
var _contents := 0

# === What the balls fly among. EventWorld writes it.

var _segments: SegmentScan = SegmentGrid.new()
# The walls, in pixels; they mean nothing without [member _has_walls].
var _has_walls := false
var _left_x := 0.0
var _top_y := 0.0
var _right_x := 0.0
var _bottom_y := 0.0
# px/s².
var _gravity_x := 0.0
var _gravity_y := 0.0
# The coefficient of restitution C, 0..1.
var _bounciness := 1.0
# The coefficient of friction µ, 0 or more.
var _friction := 0.0
# Whether there is neither gravity nor friction nor a surface that moves, so that the laws that are
# written out hold.
var _takes_short_ways := true
# Whether hurried touches are counted: see BallPiles.WEDGE_TOUCHES.
var _counts_touches := false
# Whether a segment moves, or its surface does.
var _moves := false
# With this squared speed a ball rises by BallSupport.REST_HEIGHT, in (px/s)².
var _least_squared_speed := 0.0

# === The balls. EventWorld puts them in and takes them out.

# 1 where there is a ball: a removed one leaves its place empty.
var _is_there: PackedByteArray = []
# How many there are.
var _balls_there := 0
# Whether there is one, and no segment, gravity or friction: it can meet only walls, in straight
# flight, and keeps its spin.
var _is_alone := false
# Pixels.
var _radius: PackedFloat64Array = []
var _mass: PackedFloat64Array = []

# === The present flight of each ball. EventWorld, BallSupport and BounceLaws write it.

# When it began, in seconds. In the future only for a ball whose last, tiny bounces are being summed
# up: see BallSupport._rest.
var _start: PackedFloat64Array = []
var _start_low: PackedFloat64Array = []
# The centre at that time, in pixels, and the velocity, in px/s.
var _x: PackedFloat64Array = []
var _y: PackedFloat64Array = []
var _velocity_x: PackedFloat64Array = []
var _velocity_y: PackedFloat64Array = []
# The constant acceleration, in px/s²: gravity in free flight, its part along the surface for a ball
# that lies or slides, the mean one of a piece of the circle for a ball that goes over a cap.
var _pull_x: PackedFloat64Array = []
var _pull_y: PackedFloat64Array = []

# === What EventWorld.moment has found. EventWorld writes it.

# See [member places]. It is never assigned anew, because callers hold it.
var _places: PackedFloat64Array = []
# The flight of the only ball, which nothing pulls, noted in numbers of their own: reading these is
# faster than reading arrays. It is so until this time, in seconds; -INF where nothing is noted.
var _lone_until := -INF
var _lone_start := 0.0
var _lone_start_low := 0.0
var _lone_x := 0.0
var _lone_y := 0.0
var _lone_velocity_x := 0.0
var _lone_velocity_y := 0.0

# === What a ball lies on, and what it has just left. BallSupport and BounceLaws write it.

# The surface on which a ball lies or slides, or NOTHING.
var _support: PackedInt32Array = []
# The cap over which it slides: Impact.Feature.START or END; LINE where it slides on the line.
var _rolled_end: PackedInt32Array = []
# The seconds that the present piece of the way over the cap takes.
var _piece: PackedFloat64Array = []
# The surface that a ball has just left, or NOTHING: it is not searched again, as rounding might
# find it at once.
var _left_surface: PackedInt32Array = []
# What of a segment it has left: Impact.Feature.START or END where it has slid off that cap.
var _left_feature: PackedInt32Array = []
# Under gravity: the ball's speed along the normal as it left, in px/s, which tells when it comes
# back.
var _left_speed: PackedFloat64Array = []
# The squared speed that a ball without gravity keeps from one elastic bounce to the next, so that
# rounding does not add up, in (px/s)²; NAN where the speed has changed.
var _lasting_speed: PackedFloat64Array = []
# When each ball last met another one, in seconds; -INF for never.
var _last_meeting: PackedFloat64Array = []
# The frame of reference of the surface that a ball touches.
var _frame := SurfaceFrame.new(_velocity_x, _velocity_y, _lasting_speed)
# The ways of the balls over caps.
var _rolls := CapRolls.new()
# Which balls lie in piles.
var _piles := BallPiles.new(_is_there, _radius, _velocity_x, _velocity_y, _support)
# How the balls turn.
var _spins := BallSpins.new(
	_radius, _mass, _velocity_x, _velocity_y, _pull_x, _pull_y, _start, _start_low
)

# === What comes next for each ball. EventForecast writes it.

# The next touch of a surface, as if there were no other balls: when (seconds; INF for never), which
# kind of event, which surface, and what of a segment (Impact.Feature).
var _touch_time: PackedFloat64Array = []
var _touch_low: PackedFloat64Array = []
var _touch_kind: PackedInt32Array = []
var _touched: PackedInt32Array = []
var _touched_feature: PackedInt32Array = []
# The next event of all: when, which kind, and with which surface or ball.
var _event_time: PackedFloat64Array = []
var _event_low: PackedFloat64Array = []
var _event_kind: PackedInt32Array = []
var _event_with: PackedInt32Array = []
# When the ball comes into another cell, in seconds. Means nothing without [member _uses_cells].
var _cross_time: PackedFloat64Array = []
# For each ball the earlier one of its event and its crossing; the earliest of all comes first.
var _queue := EventQueue.new()
# Which balls are near a ball. EventWorld lays the cells out.
var _cells := (
	CrowdCells
	. new(_x, _y, _velocity_x, _velocity_y, _start, _start_low, _radius, _event_time, _cross_time)
	. with_pushes(_mass, _lasting_speed, _last_meeting, _left_surface)
)
# Whether there are enough balls for cells. EventWorld writes it.
var _uses_cells := false

# What has happened. EventWorld and BounceLaws write it through the log.
var _log := EventLog.new()

# === Notes of one calculation. They mean nothing when it is over.

# The unit normal of the surface that is looked at, towards the ball.
var _normal_x := 0.0
var _normal_y := 0.0
# How strongly two surfaces that hold a ball push it together, in px/s².
var _pressure := 0.0
# The search for a touch under a pull: the earliest one so far, in seconds of flight.
var _seconds := INF
var _surface := NOTHING
var _kind: int = TOUCH
var _pulled_meeting := PulledMeeting.new()
# The ball that looks for a partner, as it is now (pixels, seconds), and what it has found.
var _asker := 0
var _asker_x := 0.0
var _asker_y := 0.0
var _asker_velocity_x := 0.0
var _asker_velocity_y := 0.0
var _asker_pull_x := 0.0
var _asker_pull_y := 0.0
var _asker_radius := 0.0
var _partner := NOTHING
var _partner_seconds := INF

@warning_ignore_restore("unused_private_class_variable")


## How many places for balls there are, with those of removed ones.
func ball_count() -> int:
	return _x.size()


## Whether there is a ball at that place.
func has_ball(index: int) -> bool:
	return index >= 0 and index < _x.size() and _is_there[index] == 1


## x of a ball's centre now, in pixels, without making an object of it.
func position_x(index: int) -> float:
	var seconds := (time - _start[index]) + (_time_low - _start_low[index])
	return _x[index] + (_velocity_x[index] + 0.5 * _pull_x[index] * seconds) * seconds


## y of a ball's centre now, in pixels.
func position_y(index: int) -> float:
	var seconds := (time - _start[index]) + (_time_low - _start_low[index])
	return _y[index] + (_velocity_y[index] + 0.5 * _pull_y[index] * seconds) * seconds


## x and y of all balls' centres now, in pixels, one after the other in a new array: a picture of
## many balls needs no call for each. Places without a ball hold what was there last. See
## [member places] for what is asked each frame.
func positions() -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	found.resize(2 * _x.size())
	_write_places(found)
	return found


## A ball's centre now, in pixels.
func position(index: int) -> Vec2:
	return Vec2.new(position_x(index), position_y(index))


## A ball's velocity now, in pixels per second.
func velocity(index: int) -> Vec2:
	if _rolled_end[index] != Impact.Feature.LINE:
		_find_velocity_on_cap(index)
		return Vec2.new(_rolls.velocity_x, _rolls.velocity_y)
	var seconds := (time - _start[index]) + (_time_low - _start_low[index])
	return Vec2.new(
		_velocity_x[index] + _pull_x[index] * seconds, _velocity_y[index] + _pull_y[index] * seconds
	)


## How fast a ball turns now, in radians per second, clockwise on screen.
func spin(index: int) -> float:
	return _spins.spin_at(index, time, _time_low)


## By how much a ball has turned since it was put into the world, in radians, clockwise on screen.
func angle(index: int) -> float:
	return _spins.angle_at(index, time, _time_low)


## A copy of a ball as it is now.
func ball(index: int) -> Ball:
	return Ball.new(position(index), _radius[index], velocity(index), _mass[index], spin(index))


## When a ball's present flight began, in seconds.
func flight_start(index: int) -> float:
	return _start[index]


## The centre of a ball at [param seconds] since the start of the world, within its present flight;
## before and after it, the flight is continued.
func position_at(index: int, seconds: float) -> Vec2:
	var flown := (seconds - _start[index]) - _start_low[index]
	return Vec2.new(
		_x[index] + (_velocity_x[index] + 0.5 * _pull_x[index] * flown) * flown,
		_y[index] + (_velocity_y[index] + 0.5 * _pull_y[index] * flown) * flown
	)


## The energy of all balls, m (v² / 2 + r² spin² / 4 - g · x), in px²/s² times mass.
func energy() -> float:
	var sum := 0.0
	for index in ball_count():
		if _is_there[index] == 1:
			var turned := _radius[index] * spin(index)
			var squares := velocity(index).length_squared() + Disc.INERTIA * turned * turned
			var height := _gravity_x * position_x(index) + _gravity_y * position_y(index)
			sum += _mass[index] * (0.5 * squares - height)
	return sum


## Whether a ball lies or slides on a segment or a wall. After a change of the world this is false
## until time passes, be it 0 s.
func is_resting(index: int) -> bool:
	if _has_changed or _support[index] == CRUSHED:
		return false
	return _support[index] != NOTHING and time >= _start[index]


## Whether a ball has been crushed between two surfaces. It stays where this happened, and nothing
## touches it any more.
func is_crushed(index: int) -> bool:
	return _support[index] == CRUSHED and _is_there[index] == 0


## Whether a ball rolls on a segment or a wall, or lies without turning, because friction holds it:
## nothing slips. Without friction nothing rolls.
func is_rolling(index: int) -> bool:
	return is_resting(index) and _spins.regime(index) == BallSpins.Regime.ROLLS


# Writes x and y of all balls' centres now into this array.
func _write_places(into: PackedFloat64Array) -> void:
	if _is_weightless() and not _has_changed:
		_write_places_fast(into)
		return
	var place := 0
	for index in _x.size():
		var seconds := (time - _start[index]) + (_time_low - _start_low[index])
		into[place] = (_x[index] + (_velocity_x[index] + 0.5 * _pull_x[index] * seconds) * seconds)
		into[place + 1] = (
			_y[index] + (_velocity_y[index] + 0.5 * _pull_y[index] * seconds) * seconds
		)
		place += 2


# The same where nothing pulls: without it, 1.4 times as long for 1000 balls.
func _write_places_fast(into: PackedFloat64Array) -> void:
	var place := 0
	for index in _x.size():
		var seconds := (time - _start[index]) + (_time_low - _start_low[index])
		into[place] = _x[index] + _velocity_x[index] * seconds
		into[place + 1] = _y[index] + _velocity_y[index] * seconds
		place += 2


# A ball that is removed stays where it is now.
func _halt(index: int) -> void:
	_restart(index)
	_rolled_end[index] = Impact.Feature.LINE
	for motion: PackedFloat64Array in [_velocity_x, _velocity_y, _pull_x, _pull_y]:
		motion[index] = 0.0
	_spins.lie(index)
	_lone_until = -INF


# Begins a new flight of a ball where it is now.
func _restart(index: int) -> void:
	var seconds := (time - _start[index]) + (_time_low - _start_low[index])
	_x[index] += (_velocity_x[index] + 0.5 * _pull_x[index] * seconds) * seconds
	_y[index] += (_velocity_y[index] + 0.5 * _pull_y[index] * seconds) * seconds
	if _rolled_end[index] != Impact.Feature.LINE:
		_find_velocity_on_cap(index)
		_velocity_x[index] = _rolls.velocity_x - _frame.x
		_velocity_y[index] = _rolls.velocity_y - _frame.y
	else:
		_velocity_x[index] += _pull_x[index] * seconds
		_velocity_y[index] += _pull_y[index] * seconds
	_start[index] = time
	_start_low[index] = _time_low


# The flight for a piece of the way over a cap follows it closely in place, but not in speed.
func _find_velocity_on_cap(index: int) -> void:
	_rolls.move_to(index, _rolls.seconds_since(index, time, _time_low))


# The unit normal of a wall or of the line of a segment, on the side where the ball is.
func _find_normal(index: int, surface: int) -> void:
	_normal_x = 0.0
	_normal_y = 0.0
	match surface:
		LEFT_WALL:
			_normal_x = 1.0
		RIGHT_WALL:
			_normal_x = -1.0
		TOP_WALL:
			_normal_y = 1.0
		BOTTOM_WALL:
			_normal_y = -1.0
		_:
			_normal_x = _segments.normal_x(surface)
			_normal_y = _segments.normal_y(surface)
			var side := _segments.signed_distance(surface, _x[index], _y[index])
			if side == 0.0:
				# The centre is on the line itself: the side is the one that it comes from.
				side = -(_velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y)
			if side < 0.0:
				_normal_x = -_normal_x
				_normal_y = -_normal_y


# See EventWorld.moment.
func _note_lone_flight() -> void:
	_lone_until = _quiet_until
	_lone_start = _start[0]
	_lone_start_low = _start_low[0]
	_lone_x = _x[0]
	_lone_y = _y[0]
	_lone_velocity_x = _velocity_x[0]
	_lone_velocity_y = _velocity_y[0]
	var seconds := (time - _lone_start) + (_time_low - _lone_start_low)
	_places[0] = _lone_x + _lone_velocity_x * seconds
	_places[1] = _lone_y + _lone_velocity_y * seconds


# Whether a ball has met another one so recently that it loses no speed now: see BallPiles.PILE_UP.
func _is_pile_up(index: int) -> bool:
	return time - _last_meeting[index] < BallPiles.PILE_UP


func _squared_speed(index: int) -> float:
	var x := _velocity_x[index]
	var y := _velocity_y[index]
	return x * x + y * y


func _is_weightless() -> bool:
	return _gravity_x == 0.0 and _gravity_y == 0.0


func _set_uses_grid(value: bool) -> void:
	uses_grid = value
	_segments = SegmentGrid.new() if value else SegmentScan.new()


# All arrays that change while balls move, for snapshots.
func _all_arrays() -> Array:
	var arrays: Array = [_is_there, _queue.times, _queue.lows]
	arrays.append_array(_float_arrays())
	arrays.append_array(_int_arrays())
	arrays.append_array(_rolls.arrays())
	arrays.append_array(_piles.arrays())
	arrays.append_array(_spins.arrays())
	arrays.append_array(_cells.arrays())
	return arrays


# The arrays with a number for each ball, beside _is_there and without those of the collaborators.
func _float_arrays() -> Array[PackedFloat64Array]:
	var flights: Array[PackedFloat64Array] = [_start, _start_low, _x, _y, _velocity_x, _velocity_y]
	flights.append_array([_pull_x, _pull_y, _piece, _left_speed, _lasting_speed, _last_meeting])
	flights.append_array([_radius, _mass, _touch_time, _touch_low, _event_time, _event_low])
	flights.append(_cross_time)
	return flights


func _int_arrays() -> Array[PackedInt32Array]:
	var contacts: Array[PackedInt32Array] = [_support, _rolled_end, _left_surface, _left_feature]
	contacts.append_array([_touch_kind, _touched, _touched_feature, _event_kind, _event_with])
	return contacts
