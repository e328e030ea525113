class_name ExactApproach
extends RefCounted
## How near a bullet comes to the centre of its target, to about 100 bits: the miss of a shot.
##
## Seen from the target, the bullet is at p + v t + a t²/2. The target may also move on a circle;
## then p, v and a are seen from the centre of the circle.

# So many moments are looked at before the nearest one is improved.
const _MOMENTS := 256
# Steps of Newton's method; each doubles the number of right digits.
const _STEPS := 12
# A smaller step, as a share of the time, changes no digit of the distance.
const _NO_STEP := 1e-24
# A smaller distance, as a share of that at the start, is none: 106 bits hold no more.
const _NO_DISTANCE := 1e-28

var _place: ExactVector
var _velocity: ExactVector
var _acceleration: Vec2
var _radius := 0.0
var _phase := DoubleDouble.from_float(0.0)
var _turn := 0.0


## A bullet with this place, in pixels, and velocity, in px/s, as seen from the target at the time
## 0, and with this acceleration, in px/s².
func _init(place: ExactVector, velocity: ExactVector, acceleration := Vec2.zero()) -> void:
	_place = place
	_velocity = velocity
	_acceleration = acceleration


## Lets the target move on a circle with this [param radius], in pixels: at the time 0 it is at the
## angle [param phase], in radians, and turns by [param turn] radians a second, clockwise on screen.
func set_circle(radius: float, phase: DoubleDouble, turn: float) -> void:
	_radius = radius
	_phase = phase
	_turn = turn


## The least distance of the centres from the time 0 to [param longest] seconds, in pixels. The time
## [param guess] is looked at, too: where the nearest moment should be.
func least_distance(longest: float, guess: float) -> float:
	var least := INF
	for start: float in [guess, _nearest_moment(longest)]:
		var time := _improved(DoubleDouble.from_float(start))
		if not (time.high >= 0.0 and time.high <= longest):
			time = DoubleDouble.from_float(clampf(time.high, 0.0, longest))
		var there := _place_at(time)
		least = minf(least, there.dot(there).square_root().to_float())
	var at_start := _place.to_vec2().length() + _radius
	return least if least > _NO_DISTANCE * at_start else 0.0


func _nearest_moment(longest: float) -> float:
	var best := 0.0
	var least := INF
	var place := _place.to_vec2()
	var velocity := _velocity.to_vec2()
	for moment in _MOMENTS + 1:
		var time := longest * moment / _MOMENTS
		var there := place.plus(velocity.scaled(time))
		there.add(_acceleration.scaled(0.5 * time * time))
		there.subtract(Vec2.unit_radians(_phase.high + _turn * time).scaled(_radius))
		if there.length_squared() < least:
			least = there.length_squared()
			best = time
	return best


# Where the distance no longer changes: r · v = 0. Its slope there is v² + r · a.
func _improved(time: DoubleDouble) -> DoubleDouble:
	for step in _STEPS:
		var there := _place_at(time)
		var velocity := _velocity_at(time)
		var pull := there.to_vec2().dot(_acceleration_at(time))
		var slope := velocity.to_vec2().length_squared() + pull
		if not slope > 0.0:
			break
		var change := there.dot(velocity).divided(DoubleDouble.from_float(slope))
		time = time.minus(change)
		if absf(change.high) <= _NO_STEP * absf(time.high):
			break
	return time


func _place_at(time: DoubleDouble) -> ExactVector:
	var half := DoubleDouble.from_float(0.5).times(time).times(time)
	var fallen := ExactVector.from_vec2(_acceleration).scaled(half)
	var there := _place.plus(_velocity.scaled(time)).plus(fallen)
	return there.minus(_out(time).scaled(DoubleDouble.from_float(_radius))) if _turn else there


func _velocity_at(time: DoubleDouble) -> ExactVector:
	var now := _velocity.plus(ExactVector.from_vec2(_acceleration).scaled(time))
	var speed := DoubleDouble.product_of(_radius, _turn)
	return now.minus(_out(time).turned().scaled(speed)) if _turn else now


func _acceleration_at(time: DoubleDouble) -> Vec2:
	var out := Vec2.unit_radians(_phase.high + _turn * time.high)
	return _acceleration.plus(out.scaled(_radius * _turn * _turn))


# The direction from the centre of the circle to the target.
func _out(time: DoubleDouble) -> ExactVector:
	return ExactAngle.unit(_phase.plus(time.times(DoubleDouble.from_float(_turn))))
