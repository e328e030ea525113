class_name CrowdCells
extends BallCells
## The cells of an [EventWorld], which know the flights of its balls: among balls that nothing pulls
## they search for the one that a ball meets first. Every way to look for a partner in a crowd comes
## through this one search, and a world of many balls spends most of its time in it.
##
## It reads and writes the arrays of the world itself. These stay the same arrays, because the world
## never assigns one of them anew: it only resizes and fills them.

const _NO_SURFACE := -1

## What [method search] has found: the ball that is met first, or -1 where there is none.
var partner := -1
## Seconds until then; means something only with a [member partner].
var seconds := INF

# See the fields of EventState with the same names.
var _x: PackedFloat64Array
var _y: PackedFloat64Array
var _velocity_x: PackedFloat64Array
var _velocity_y: PackedFloat64Array
var _start: PackedFloat64Array
var _start_low: PackedFloat64Array
var _radius: PackedFloat64Array
var _event_time: PackedFloat64Array
var _cross_time: PackedFloat64Array
var _mass: PackedFloat64Array
var _lasting_speed: PackedFloat64Array
var _last_meeting: PackedFloat64Array
var _left_surface: PackedInt32Array


## Cells that share these arrays with a world, each with a number for each ball: place, velocity and
## beginning of its flight, its radius, its next event, and when it comes into another cell.
func _init(
	x: PackedFloat64Array,
	y: PackedFloat64Array,
	velocity_x: PackedFloat64Array,
	velocity_y: PackedFloat64Array,
	start: PackedFloat64Array,
	start_low: PackedFloat64Array,
	radius: PackedFloat64Array,
	event_time: PackedFloat64Array,
	cross_time: PackedFloat64Array
) -> void:
	_x = x
	_y = y
	_velocity_x = velocity_x
	_velocity_y = velocity_y
	_start = start
	_start_low = start_low
	_radius = radius
	_event_time = event_time
	_cross_time = cross_time


## The same cells, which share these arrays, too: what [method push_apart] needs.
func with_pushes(
	mass: PackedFloat64Array,
	lasting_speed: PackedFloat64Array,
	last_meeting: PackedFloat64Array,
	left_surface: PackedInt32Array
) -> CrowdCells:
	_mass = mass
	_lasting_speed = lasting_speed
	_last_meeting = last_meeting
	_left_surface = left_surface
	return self


## Lays the cells out for the balls of the world, which are at these [param places], x and y one
## after the other, where [param is_there] is 1.
func put_all(places: PackedFloat64Array, is_there: PackedByteArray) -> void:
	# Removed balls count for nothing: the world is as one without them.
	lay_out(BallCells.size_for(places, _radius, is_there), is_there.count(1))
	make_room(is_there.size())
	for ball in is_there.size():
		if is_there[ball] == 1:
			put(ball, _x[ball], _y[ball])


## Two balls meet at the time [param time] + [param low]: BounceLaws._collide_by_laws for C = 1,
## without gravity, friction and events, written out. Their flights begin anew.
func push_apart(one: int, other: int, time: float, low: float) -> void:
	var flown := (time - _start[one]) + (low - _start_low[one])
	var one_velocity_x := _velocity_x[one]
	var one_velocity_y := _velocity_y[one]
	var one_x := _x[one] + one_velocity_x * flown
	var one_y := _y[one] + one_velocity_y * flown
	flown = (time - _start[other]) + (low - _start_low[other])
	var other_velocity_x := _velocity_x[other]
	var other_velocity_y := _velocity_y[other]
	var other_x := _x[other] + other_velocity_x * flown
	var other_y := _y[other] + other_velocity_y * flown
	var dx := one_x - other_x
	var dy := one_y - other_y
	var distance := sqrt(dx * dx + dy * dy)
	var normal_x := dx / distance if distance > 0.0 else 0.0
	var normal_y := dy / distance if distance > 0.0 else 0.0
	var approach := (
		(other_velocity_x - one_velocity_x) * normal_x
		+ (other_velocity_y - one_velocity_y) * normal_y
	)
	if approach > 0.0:
		var share := (approach + approach) / (_mass[one] + _mass[other])
		one_velocity_x += share * _mass[other] * normal_x
		one_velocity_y += share * _mass[other] * normal_y
		other_velocity_x -= share * _mass[one] * normal_x
		other_velocity_y -= share * _mass[one] * normal_y
		_lasting_speed[one] = NAN
		_lasting_speed[other] = NAN
	_last_meeting[one] = time
	_last_meeting[other] = time
	_left_surface[one] = _NO_SURFACE
	_left_surface[other] = _NO_SURFACE
	_x[one] = one_x
	_y[one] = one_y
	_velocity_x[one] = one_velocity_x
	_velocity_y[one] = one_velocity_y
	_start[one] = time
	_start_low[one] = low
	_x[other] = other_x
	_y[other] = other_y
	_velocity_x[other] = other_velocity_x
	_velocity_y[other] = other_velocity_y
	_start[other] = time
	_start_low[other] = low


## Searches for the ball that [param asker] meets first of all in these places of
## [member neighbors] around it, at the time [param time] + [param low], within so many seconds and
## before the other's next event. The formula is that of StraightImpactFinder. Of a new flight it
## also notes when and over which border the asker leaves its cell, as [method time_to_leave] does.
func search(
	asker: int, time: float, low: float, within: float, places: PackedInt32Array, is_new: bool
) -> void:
	var flown := (time - _start[asker]) + (low - _start_low[asker])
	var asker_velocity_x := _velocity_x[asker]
	var asker_velocity_y := _velocity_y[asker]
	var x := _x[asker] + asker_velocity_x * flown
	var y := _y[asker] + asker_velocity_y * flown
	if is_new:
		var column := INF
		var row := INF
		if asker_velocity_x > 0.0:
			column = ((_column[asker] + 1) * size - x) / asker_velocity_x
		elif asker_velocity_x < 0.0:
			column = (_column[asker] * size - x) / asker_velocity_x
		if asker_velocity_y > 0.0:
			row = ((_row[asker] + 1) * size - y) / asker_velocity_y
		elif asker_velocity_y < 0.0:
			row = (_row[asker] * size - y) / asker_velocity_y
		if column <= row or (column <= 0.0 and row <= 0.0):
			border[asker] = 1 if asker_velocity_x > 0.0 else -1
		else:
			border[asker] = 2 if asker_velocity_y > 0.0 else -2
			column = row
		_cross_time[asker] = time + maxf(column, 0.0)
	var asker_radius := _radius[asker]
	var around := 9 * cell[asker]
	var found := -1
	for place in places:
		var other := first[neighbors[around + place]]
		while other >= 0:
			flown = (time - _start[other]) + (low - _start_low[other])
			var velocity_x := _velocity_x[other]
			var velocity_y := _velocity_y[other]
			var dx := x - _x[other] - velocity_x * flown
			var dy := y - _y[other] - velocity_y * flown
			velocity_x = asker_velocity_x - velocity_x
			velocity_y = asker_velocity_y - velocity_y
			var approach := dx * velocity_x + dy * velocity_y
			if approach < 0.0:
				var reach := asker_radius + _radius[other]
				var excess := dx * dx + dy * dy - reach * reach
				if excess <= -2.0 * approach * within:
					var offset := dx * velocity_y - dy * velocity_x
					var speed_squared := velocity_x * velocity_x + velocity_y * velocity_y
					var discriminant := reach * reach * speed_squared - offset * offset
					if excess <= 0.0:
						if within > 0.0 and time < _event_time[other]:
							within = 0.0
							found = other
					elif discriminant > 0.0:
						var until := excess / (sqrt(discriminant) - approach)
						if until < within and time + until < _event_time[other]:
							within = until
							found = other
			other = next[other]
	partner = found
	seconds = within
