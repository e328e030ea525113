class_name BallSpins
extends RefCounted
## How the balls of an [EventWorld] turn, and what friction does along what they touch: by the law
## of [Friction] at an impact, by the formulas of [Incline] on a line.
##
## A turn is known as a flight is: by when it began, with which angle and spin, and by a constant
## change of the spin. Without friction a turn goes on from flight to flight, and nothing is written
## here while balls bounce.

## How a ball moves along what supports it: free, as nothing does or there is no friction; it slips;
## it slips, and will stand still when that is over; it rolls, or lies without turning; it spins
## where two surfaces hold it.
enum Regime { FREE, SLIPS, STOPS, ROLLS, SPINS }

## A sum or difference of two speeds is 0 if it is a smaller share of them: rounding left it.
const ROUNDING := 1.0 / 2.0 ** 47

## Seconds from the beginning of each ball's flight until its slip is over; INF for never. Read it.
var slip_ends: PackedFloat64Array = []

## The lines on which balls slide and roll.
var slopes := Slopes.new()

# µ, 0 or more.
var _friction := 0.0
# The arrays of the world, which are never assigned anew.
var _radius: PackedFloat64Array
var _mass: PackedFloat64Array
var _velocity_x: PackedFloat64Array
var _velocity_y: PackedFloat64Array
var _pull_x: PackedFloat64Array
var _pull_y: PackedFloat64Array
var _flight_start: PackedFloat64Array
var _flight_start_low: PackedFloat64Array
# The present turn of each ball: when it began (seconds, as a sum of two numbers), with which angle
# (radians) and spin (rad/s), and how the spin changes (rad/s²).
var _start: PackedFloat64Array = []
var _start_low: PackedFloat64Array = []
var _angle: PackedFloat64Array = []
var _spin: PackedFloat64Array = []
var _turning: PackedFloat64Array = []
var _regime: PackedInt32Array = []


func _init(
	radius: PackedFloat64Array,
	mass: PackedFloat64Array,
	velocity_x: PackedFloat64Array,
	velocity_y: PackedFloat64Array,
	pull_x: PackedFloat64Array,
	pull_y: PackedFloat64Array,
	flight_start: PackedFloat64Array,
	flight_start_low: PackedFloat64Array
) -> void:
	_radius = radius
	_mass = mass
	_velocity_x = velocity_x
	_velocity_y = velocity_y
	_pull_x = pull_x
	_pull_y = pull_y
	_flight_start = flight_start
	_flight_start_low = flight_start_low


## Makes room for this many balls.
func resize(count: int) -> void:
	for numbers: Variant in arrays():
		if numbers is PackedFloat64Array:
			var floats: PackedFloat64Array = numbers
			floats.resize(count)
	_regime.resize(count)


## All arrays, for snapshots.
func arrays() -> Array:
	return [_start, _start_low, _angle, _spin, _turning, _regime, slip_ends]


## Takes this µ from now on, at this time of the world. No spin changes any more until a ball
## touches something again.
func set_friction(friction: float, time: float, time_low: float) -> void:
	_friction = friction
	for index in _spin.size():
		_begin(index, spin_at(index, time, time_low), 0.0, time, time_low)


## Radians per second at this time of the world.
func spin_at(index: int, time: float, time_low: float) -> float:
	return _spin[index] + _turning[index] * _seconds_until(index, time, time_low)


## By how much a ball has turned until this time of the world, in radians.
func angle_at(index: int, time: float, time_low: float) -> float:
	var seconds := _seconds_until(index, time, time_low)
	return _angle[index] + (_spin[index] + 0.5 * _turning[index] * seconds) * seconds


## How a ball moves along what supports it.
func regime(index: int) -> Regime:
	return _regime[index] as Regime


## A ball has this angle at the beginning of its present turn, in radians.
func face(index: int, angle: float) -> void:
	_angle[index] = angle


## Gives a ball this spin from the beginning of its flight; its angle stays.
func put(index: int, spin: float) -> void:
	_turn_on(index, spin, 0.0)
	_regime[index] = Regime.FREE
	slip_ends[index] = INF


## Nothing supports a ball from the beginning of its flight: its spin stays.
func fly(index: int) -> void:
	put(index, _spin_of_flight(index))


## A ball lies without turning.
func lie(index: int) -> void:
	put(index, 0.0)
	_regime[index] = Regime.ROLLS


## A ball loses half of its spin.
func halve(index: int) -> void:
	put(index, 0.5 * _spin_of_flight(index))


## THE LAW OF FRICTION for a line or cap that pushes a ball away, as in [FrictionBounce]. The unit
## normal points to the ball; [param push] is the impulse along it per mass, in px/s. A belt runs to
## the right of a normal that points up.
func rub(index: int, normal_x: float, normal_y: float, push: float, belt: float) -> void:
	var tangent_x := -normal_y
	var tangent_y := normal_x
	var spin := _spin_of_flight(index)
	var along := _velocity_x[index] * tangent_x + _velocity_y[index] * tangent_y
	var grip := Friction.impulse(along - _radius[index] * spin - belt, push, _friction)
	_velocity_x[index] += grip * tangent_x
	_velocity_y[index] += grip * tangent_y
	put(index, spin - grip / (Disc.INERTIA * _radius[index]))


## THE LAW OF FRICTION for two balls, as in [BallFrictionBounce]: the unit normal points to the
## first one, [param push] is by how much their speed along it changes, in px/s.
func rub_balls(one: int, other: int, normal_x: float, normal_y: float, push: float) -> void:
	var tangent_x := -normal_y
	var tangent_y := normal_x
	var along := (
		(_velocity_x[one] - _velocity_x[other]) * tangent_x
		+ (_velocity_y[one] - _velocity_y[other]) * tangent_y
	)
	var rolled := _radius[one] * _spin_of_flight(one) + _radius[other] * _spin_of_flight(other)
	var grip := Friction.impulse(along - rolled, push, _friction)
	var total := _mass[one] + _mass[other]
	_take(one, tangent_x, tangent_y, grip, _mass[other] / total)
	_take(other, -tangent_x, -tangent_y, grip, _mass[one] / total)


## How a ball goes on along the line of this surface from the beginning of its flight: the change of
## its spin, and its acceleration.
func go_along(index: int, surface: int) -> void:
	var line := slopes.at(surface)
	var speed := _velocity_x[index] * line.direction.x + _velocity_y[index] * line.direction.y
	speed -= line.belt
	var rolled := line.side * _radius[index] * _spin_of_flight(index)
	_go_on(index, line, 0.0 if _is_rounding(speed - rolled, speed, rolled) else speed - rolled)
	# On the level it comes to (2 speed + rolled) / 3.
	if line.pull == 0.0 and _is_rounding(2.0 * speed + rolled, speed, rolled):
		_regime[index] = Regime.STOPS if speed != 0.0 else Regime.ROLLS


## The same for a ball whose slip is over.
func go_on_without_slip(index: int, surface: int) -> void:
	if _regime[index] == Regime.STOPS:
		var belt := slopes.at(surface).belt
		_velocity_x[index] = belt * slopes.at(surface).direction.x
		_velocity_y[index] = belt * slopes.at(surface).direction.y
		put(index, 0.0)
	_go_on(index, slopes.at(surface), 0.0)


## A ball spins where two surfaces hold it that push with [param pressure] together, in px/s²: at
## both friction works against its spin.
func spin_in_place(index: int, pressure: float) -> void:
	var spin := _spin_of_flight(index)
	var turning := -signf(spin) * _friction * pressure / (Disc.INERTIA * _radius[index])
	_turn_on(index, spin, turning)
	_regime[index] = Regime.SPINS if turning != 0.0 else Regime.ROLLS
	slip_ends[index] = spin / -turning if turning != 0.0 else INF


## How friction may tilt the pushes of two surfaces on a ball that spins in its place: see
## [TwoSurfaces]. Where its edge is as slow as the root of [param slow], in (px/s)², it may be at
## rest as well.
func tilts(index: int, slow: float) -> PackedFloat64Array:
	var spin := _spin_of_flight(index)
	var tilt := _friction * signf(spin)
	if tilt == 0.0:
		return [0.0]
	var edge := _radius[index] * spin
	return [tilt, 0.0] if edge * edge <= slow else [tilt]


func _go_on(index: int, line: Incline, rubs: float) -> void:
	var phase := line.phase(_radius[index], rubs)
	_pull_x[index] = phase.acceleration * line.direction.x
	_pull_y[index] = phase.acceleration * line.direction.y
	_turn_on(index, _spin_of_flight(index), phase.turning)
	_regime[index] = Regime.ROLLS if phase.rolls else Regime.SLIPS
	slip_ends[index] = phase.lasts


# The impulse along the surface, per mass of both, by its share for this ball.
func _take(index: int, tangent_x: float, tangent_y: float, grip: float, share: float) -> void:
	_velocity_x[index] += grip * share * tangent_x
	_velocity_y[index] += grip * share * tangent_y
	put(index, _spin_of_flight(index) - grip * share / (Disc.INERTIA * _radius[index]))


# From the beginning of its flight on a ball turns so.
func _turn_on(index: int, spin: float, turning: float) -> void:
	_begin(index, spin, turning, _flight_start[index], _flight_start_low[index])


func _begin(index: int, spin: float, turning: float, time: float, time_low: float) -> void:
	_angle[index] = angle_at(index, time, time_low)
	_spin[index] = spin
	_turning[index] = turning
	_start[index] = time
	_start_low[index] = time_low


func _spin_of_flight(index: int) -> float:
	return spin_at(index, _flight_start[index], _flight_start_low[index])


func _seconds_until(index: int, time: float, time_low: float) -> float:
	return (time - _start[index]) + (time_low - _start_low[index])


static func _is_rounding(number: float, one: float, other: float) -> bool:
	return absf(number) <= ROUNDING * (absf(one) + absf(other))
