class_name BallFlights
extends RefCounted
## Balls in free flight, each known by where and when its flight began: place, velocity and a
## constant acceleration. Nothing is moved while time passes; where a ball is, is worked out when
## somebody asks.
##
## Plain numbers in packed arrays, because the loops of [EventWorld] go over them; people read
## [method position] and [method velocity]. A time is the sum of two numbers, the second one smaller
## than the last place of the first: after 100 s and thousands of impacts the plain sum alone would
## be some 1e-12 s off, which is 1e-8 px for a ball of 30 000 px/s.

## What is not supported by anything.
const NOTHING := -1

## Seconds since the start. Read it; [method EventWorld.advance] moves it.
var time := 0.0

var _time_low := 0.0
var _x: PackedFloat64Array = []
var _y: PackedFloat64Array = []
var _velocity_x: PackedFloat64Array = []
var _velocity_y: PackedFloat64Array = []
var _pull_x: PackedFloat64Array = []
var _pull_y: PackedFloat64Array = []
var _start: PackedFloat64Array = []
var _start_low: PackedFloat64Array = []
var _radius: PackedFloat64Array = []
var _mass: PackedFloat64Array = []
# 1 where there is a ball: a removed one leaves its place empty.
var _is_there: PackedByteArray = []


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


## y of a ball's centre now.
func position_y(index: int) -> float:
	var seconds := (time - _start[index]) + (_time_low - _start_low[index])
	return _y[index] + (_velocity_y[index] + 0.5 * _pull_y[index] * seconds) * seconds


## x and y of all balls' centres now, in pixels, one behind the other in a new array: a picture of
## many balls needs no call for each. Places without a ball hold what was there last.
func positions() -> PackedFloat64Array:
	var places: PackedFloat64Array = []
	places.resize(2 * _x.size())
	for index in _x.size():
		var seconds := (time - _start[index]) + (_time_low - _start_low[index])
		places[2 * index] = (
			_x[index] + (_velocity_x[index] + 0.5 * _pull_x[index] * seconds) * seconds
		)
		places[2 * index + 1] = (
			_y[index] + (_velocity_y[index] + 0.5 * _pull_y[index] * seconds) * seconds
		)
	return places


## A ball's centre now, in pixels.
func position(index: int) -> Vec2:
	return Vec2.new(position_x(index), position_y(index))


## A ball's velocity now, in pixels per second.
func velocity(index: int) -> Vec2:
	var seconds := (time - _start[index]) + (_time_low - _start_low[index])
	return Vec2.new(
		_velocity_x[index] + _pull_x[index] * seconds, _velocity_y[index] + _pull_y[index] * seconds
	)


## A copy of a ball as it is now.
func ball(index: int) -> Ball:
	return Ball.new(position(index), _radius[index], velocity(index), _mass[index])


## When a ball's present flight began, in seconds.
func flight_start(index: int) -> float:
	return _start[index]


## The centre of a ball at [param seconds] since the start of the world, within its present flight;
## before and after it the flight is thought to go on.
func position_at(index: int, seconds: float) -> Vec2:
	var flown := (seconds - _start[index]) - _start_low[index]
	return Vec2.new(
		_x[index] + (_velocity_x[index] + 0.5 * _pull_x[index] * flown) * flown,
		_y[index] + (_velocity_y[index] + 0.5 * _pull_y[index] * flown) * flown
	)


# Begins a ball's flight anew where it is now.
func _restart(index: int) -> void:
	var seconds := (time - _start[index]) + (_time_low - _start_low[index])
	_x[index] += (_velocity_x[index] + 0.5 * _pull_x[index] * seconds) * seconds
	_y[index] += (_velocity_y[index] + 0.5 * _pull_y[index] * seconds) * seconds
	_velocity_x[index] += _pull_x[index] * seconds
	_velocity_y[index] += _pull_y[index] * seconds
	_start[index] = time
	_start_low[index] = _time_low


func _float_arrays() -> Array[PackedFloat64Array]:
	return [
		_x,
		_y,
		_velocity_x,
		_velocity_y,
		_pull_x,
		_pull_y,
		_start,
		_start_low,
		_radius,
		_mass,
	]
