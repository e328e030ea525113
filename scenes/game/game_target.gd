class_name GameTarget
extends RefCounted
## A target of the game: it rests, goes to and fro on a line, or round in a circle. Where it is at
## any time is known in closed form.

## Its radius, in pixels.
const RADIUS := 16.0

## One end of its line, or the middle of its circle.
var from: Vec2
## The other end of its line.
var to: Vec2
## The radius of its circle, in pixels; 0 for a line.
var circle := 0.0
## Pixels per second; 0 where it rests. On a circle above 0 is clockwise on screen.
var speed := 0.0


## A target that rests.
static func at(place: Vec2) -> GameTarget:
	var target := GameTarget.new()
	target.from = place
	target.to = place
	return target


## A target that goes to and fro.
static func between(one: Vec2, other: Vec2, its_speed: float) -> GameTarget:
	var target := GameTarget.new()
	target.from = one
	target.to = other
	target.speed = its_speed
	return target


## A target that goes round.
static func around(middle: Vec2, its_circle: float, its_speed: float) -> GameTarget:
	var target := GameTarget.at(middle)
	target.circle = its_circle
	target.speed = its_speed
	return target


## Where its centre is at [param time], in seconds since the level began.
func place_at(time: float) -> Vec2:
	if circle > 0.0:
		return from.plus(Vec2.unit_radians(speed * time / circle).scaled(circle))
	var length := from.distance_to(to)
	if length == 0.0 or speed == 0.0:
		return from.copy()
	# There and back again: a wave of triangles.
	var way := fposmod(speed * time, 2.0 * length)
	return from.moved_toward(to, minf(way, 2.0 * length - way))


## Its velocity then, in px/s.
func velocity_at(time: float) -> Vec2:
	if circle > 0.0:
		return Vec2.unit_radians(speed * time / circle).normal().scaled(speed)
	var length := from.distance_to(to)
	if length == 0.0:
		return Vec2.zero()
	var is_coming := fposmod(speed * time, 2.0 * length) < length
	return to.minus(from).normalized().scaled(speed if is_coming else -speed)
