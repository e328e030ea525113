class_name EnergyCheck
extends RefCounted
## Looks again and again at the energy of balls under one gravity: it never grows.

## Energy is kept within this share of the largest energy of the motion.
const SHARE := 1e-9

# A fall that belongs to the scale of every motion, in pixels.
const _FALL := 50.0

## Whether no energy may be lost either.
var keeps_all := false
## How much it may grow besides rounding, in px²/s² times mass.
var allowed := 0.0

var _first := INF
var _lowest := INF
# The largest energy of the motion so far, as a scale for what rounding does.
var _scale := 0.0
# Heights are measured from here, so that no digits are lost far away.
var _origin: Vec2


## "" or what is wrong with the energy of the balls as they are now.
func problem(balls: Array[Ball], gravity: Vec2) -> String:
	if balls.is_empty():
		return ""
	if _lowest == INF:
		_origin = balls[0].position.copy()
	var pull := gravity.length()
	var energy := 0.0
	var moving := 0.0
	var rounding := 0.0
	for ball: Ball in balls:
		var kinetic := Disc.energy(ball)
		energy += kinetic - ball.mass * gravity.dot(ball.position.minus(_origin))
		moving += kinetic + ball.mass * pull * _FALL
		rounding += ball.mass * pull * InsideCheck.last_places(ball.position)
	_scale = maxf(_scale, moving)
	if _lowest == INF:
		_first = energy
		_lowest = energy
	var tolerance := SHARE * _scale + rounding
	if not energy - _lowest <= tolerance + allowed:
		return "The energy has grown by %s." % (energy - _lowest)
	if keeps_all and _first - energy > tolerance:
		return "Energy is lost: %s." % (_first - energy)
	_lowest = minf(_lowest, energy)
	return ""


## What may come from nowhere where balls lie on each other: bounces end in hops, so
## a pair that is pressed together without any speed is given that of a hop of
## [constant BallPiles.LEAST_HOP]. Two balls that part with g hop / 2 have the energy (g hop)² / 8
## times their reduced mass.
static func of_hops(balls: Array[Ball], gravity: Vec2) -> float:
	var sum := 0.0
	for one: int in balls.size():
		for other: int in one:
			sum += balls[one].mass / (1.0 + balls[one].mass / balls[other].mass)
	return sum * (gravity.length() * BallPiles.LEAST_HOP) ** 2 / 8.0
