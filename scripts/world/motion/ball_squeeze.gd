class_name BallSqueeze
extends RefCounted
## What surfaces around a ball do to it when they come nearer to each other: whether they leave it
## any velocity at all.
##
## A surface with the unit normal n, towards the ball, whose touched point moves with w, leaves the
## ball only velocities v with v · n >= w · n. Two surfaces that face each other leave none if they
## come nearer; three whose normals enclose the ball leave none if the space between them shrinks.

## Normals that differ by less than this, in radians, are opposite or enclose nothing.
const LEAST_ANGLE := 1e-6

var _centre: Vec2
var _radius: float
var _slack: float
# Of each surface: its normal, how fast it comes along that (px/s), and how far it is from touching
# the ball (px).
var _normals: Array[Vec2] = []
var _speeds: PackedFloat64Array = []
var _gaps: PackedFloat64Array = []


## A ball with its centre here. It touches what is no farther from it than [param slack] pixels.
func _init(centre: Vec2, radius: float, slack: float) -> void:
	_centre = centre
	_radius = radius
	_slack = slack


## Adds a surface by its nearest point and the velocity of that point.
func add(point: Vec2, velocity: Vec2) -> void:
	var away := _centre.minus(point)
	var distance := away.length()
	if distance == 0.0:
		return
	var normal := away.divided(distance)
	_normals.append(normal)
	_speeds.append(velocity.dot(normal))
	_gaps.append(distance - _radius)


## Whether the surfaces that touch the ball leave it no velocity.
func is_crushing() -> bool:
	for one in _normals.size():
		if _gaps[one] > _slack:
			continue
		for other in one:
			if _gaps[other] <= _slack and _are_closing(one, other):
				return true
			for third in other:
				if maxf(_gaps[other], _gaps[third]) <= _slack and _enclose(one, other, third):
					return true
	return false


## Whether one of the surfaces faces the one with this normal, which moves with [param velocity],
## and both come nearer to each other.
func faces(normal: Vec2, velocity: Vec2) -> bool:
	for other in _normals.size():
		if _are_opposite(normal, _normals[other]) and velocity.dot(normal) + _speeds[other] > 0.0:
			return true
	return false


func _are_closing(one: int, other: int) -> bool:
	if not _are_opposite(_normals[one], _normals[other]):
		return false
	return _is_coming(_speeds[one] + _speeds[other])


static func _are_opposite(one: Vec2, other: Vec2) -> bool:
	return absf(one.cross(other)) < LEAST_ANGLE and one.dot(other) < 0.0


# The normals with these weights add up to 0; so the speeds, weighted alike, must not be above 0.
func _enclose(one: int, other: int, third: int) -> bool:
	var weight := _normals[other].cross(_normals[third])
	var of_other := _normals[third].cross(_normals[one])
	var of_third := _normals[one].cross(_normals[other])
	if weight < 0.0:
		weight = -weight
		of_other = -of_other
		of_third = -of_third
	if minf(weight, minf(of_other, of_third)) < LEAST_ANGLE:
		return false
	return _is_coming(
		weight * _speeds[one] + of_other * _speeds[other] + of_third * _speeds[third]
	)


# Above 0 by more than rounding.
func _is_coming(speed: float) -> bool:
	var fastest := 0.0
	for one in _speeds:
		fastest = maxf(fastest, absf(one))
	return speed > 1e-12 * fastest
