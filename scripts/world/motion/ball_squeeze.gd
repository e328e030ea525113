class_name BallSqueeze
extends RefCounted
## What surfaces around a ball do to it when they come nearer to each other: when they crush it.
##
## A surface with the unit normal n, towards the ball, that is g px away and comes with the speed s
## along n, leaves the ball only places with g + n · way >= s t. Weights w >= 0 with which the
## normals of two opposite surfaces, or of three around the ball, add up to 0 make the way drop out:
## so after t = sum(w g) / sum(w s) no place is left.

## Normals that differ by less than this, in radians, are opposite or enclose nothing.
const LEAST_ANGLE := 1e-6

## Seconds until the ball is crushed; INF where nothing comes nearer. [method find] writes it.
var seconds := INF
## With this velocity the ball has room until then, in px/s.
var velocity: Vec2

var _ball: Ball
# Of each surface: its normal, how fast it comes along that (px/s), and how far it is from touching
# the ball (px).
var _normals: Array[Vec2] = []
var _speeds: PackedFloat64Array = []
var _gaps: PackedFloat64Array = []


## Begins with this ball and no surface.
func _init(ball: Ball) -> void:
	_ball = ball


## Adds a surface by its nearest point and the velocity of that point.
func add(point: Vec2, point_velocity: Vec2) -> void:
	var away := _ball.position.minus(point)
	var distance := away.length()
	if distance == 0.0:
		return
	var normal := away.divided(distance)
	_normals.append(normal)
	_speeds.append(point_velocity.dot(normal))
	_gaps.append(distance - _ball.radius)


## Finds out when the surfaces crush the ball that are no farther from it than [param reach] pixels.
## Those that are no farther than [param slack] touch it.
func find(reach: float, slack: float) -> void:
	for one in _normals.size():
		for other in one:
			if maxf(_gaps[one], _gaps[other]) > reach:
				continue
			var cross := _normals[one].cross(_normals[other])
			if absf(cross) < LEAST_ANGLE:
				if _normals[one].dot(_normals[other]) < 0.0:
					_weigh([one, other], [1.0, 1.0], slack)
				continue
			for third in other:
				if _gaps[third] <= reach:
					_weigh_three([one, other, third], signf(cross), cross, slack)


func _weigh_three(places: PackedInt32Array, side: float, cross: float, slack: float) -> void:
	var weights: PackedFloat64Array = [
		side * _normals[places[1]].cross(_normals[places[2]]),
		side * _normals[places[2]].cross(_normals[places[0]]),
		side * cross
	]
	if minf(weights[0], weights[1]) >= LEAST_ANGLE:
		_weigh(places, weights, slack)


# The surfaces at these places, whose normals add up to 0 with these weights.
func _weigh(places: PackedInt32Array, weights: PackedFloat64Array, slack: float) -> void:
	var room := 0.0
	var speed := 0.0
	var fastest := 0.0
	for index in places.size():
		var gap := _gaps[places[index]]
		room += weights[index] * (gap if gap > slack else 0.0)
		speed += weights[index] * _speeds[places[index]]
		fastest = maxf(fastest, absf(weights[index] * _speeds[places[index]]))
	# More than rounding.
	if speed > 1e-12 * fastest and room / speed < seconds:
		seconds = room / speed
		velocity = _velocity_into(places)


# The velocity with which the ball touches the first two of these surfaces when it is crushed;
# between two that are opposite it keeps its velocity along them.
func _velocity_into(places: PackedInt32Array) -> Vec2:
	if seconds == 0.0:
		return _ball.velocity.copy()
	var one := _normals[places[0]]
	var speed := _speeds[places[0]] - _gaps[places[0]] / seconds
	if places.size() == 2:
		return _ball.velocity.rejection(one).plus(one.scaled(speed))
	var other := _normals[places[1]]
	var other_speed := _speeds[places[1]] - _gaps[places[1]] / seconds
	# v · one = speed and v · other = other_speed.
	var sum := other.normal().scaled(-speed).plus(one.normal().scaled(other_speed))
	return sum.divided(one.cross(other))
