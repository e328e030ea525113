class_name DroppedBall
extends RefCounted
## A ball dropped on a level floor: its exact height, and its energy.
##
## From each highest point the ball falls by g t^2 / 2. A bounce leaves the fraction C of the speed,
## so C^2 of the height. With C < 1 the infinitely many bounces take t0 (1 + C) / (1 - C) in all,
## where t0 = sqrt(2 h / g) is the time of the first fall. After that the ball lies on the floor.

## The height of the ball's lowest point above the floor at the start, in pixels.
const HEIGHT := 200.0
## Pixels per second squared, downwards.
const GRAVITY := 1000.0
## The ball's radius, in pixels.
const RADIUS := 10.0
## The time after which the ball is measured, in seconds.
const SECONDS := 60.0
## The coefficients of restitution C, each a situation.
const BOUNCINESSES: PackedFloat64Array = [1.0, 0.8, 0.5, 0.0]


## The ball at its start, at rest.
static func ball() -> Ball:
	return Ball.new(Vec2.new(0.0, -HEIGHT - RADIUS), RADIUS)


## The floor, a level segment through the origin.
static func floors() -> Array[LineSegment]:
	return [LineSegment.new(Vec2.new(-500.0, 0.0), Vec2.new(500.0, 0.0))]


## The height in pixels after [param seconds], computed with 106 bits and then rounded.
static func height_after(seconds: float, bounciness: float) -> float:
	if seconds >= rest_time(bounciness):
		return 0.0
	var left := DoubleDouble.from_float(seconds)
	var fall := DoubleDouble.from_float(2.0 * HEIGHT)
	fall = fall.divided(DoubleDouble.from_float(GRAVITY)).square_root()
	# The time since the latest bounce, and the length of the hop that follows it.
	left = left.minus(fall)
	if left.to_float() < 0.0:
		return _fallen(DoubleDouble.from_float(HEIGHT), DoubleDouble.from_float(seconds))
	var hop := fall.plus(fall).times(DoubleDouble.from_float(bounciness))
	if bounciness == 1.0:
		var hops := floorf(left.to_float() / hop.to_float())
		left = left.minus(hop.times(DoubleDouble.from_float(hops)))
	else:
		while left.minus(hop).to_float() >= 0.0:
			left = left.minus(hop)
			hop = hop.times(DoubleDouble.from_float(bounciness))
	# The height within a hop of length T: g t (T - t) / 2.
	var height := left.times(hop.minus(left)).times(DoubleDouble.from_float(GRAVITY / 2.0))
	return height.to_float()


## The time in seconds until the ball lies still; infinite for C = 1.
static func rest_time(bounciness: float) -> float:
	if bounciness == 1.0:
		return INF
	return sqrt(2.0 * HEIGHT / GRAVITY) * (1.0 + bounciness) / (1.0 - bounciness)


## The energy of a ball at this height and speed, as a fraction of the energy at the start.
static func energy_share(height: float, speed: float) -> float:
	return (speed * speed / 2.0 + GRAVITY * height) / (GRAVITY * HEIGHT)


## The name of the situation in tables.
static func situation_of(bounciness: float) -> String:
	return "C = %s" % bounciness


static func _fallen(from: DoubleDouble, seconds: DoubleDouble) -> float:
	var way := seconds.times(seconds).times(DoubleDouble.from_float(GRAVITY / 2.0))
	return from.minus(way).to_float()
