class_name BallFrictionImpact
extends RefCounted
## The first impact of two spinning balls in straight flight, with friction, and how both go on.
## Read [member hit] first: without a hit, only velocities and spins have a meaning, and are those
## that the balls have.

## Whether the balls meet.
var hit := false
## Seconds until the impact; 0 where they touch or overlap already and approach.
var time := 0.0
## From the second ball to the first; length 1.
var normal: Vec2
## Whether the surfaces slip or stick.
var regime := Friction.Regime.NONE
## The first ball's velocity after the impact, in pixels per second.
var velocity_one: Vec2
## The first ball's spin after the impact, in radians per second.
var spin_one := 0.0
## The second ball's velocity after the impact.
var velocity_other: Vec2
## The second ball's spin after the impact.
var spin_other := 0.0


## The impact of two balls, which are not changed: seen from the second, the first one flies towards
## a point, with the sum of both radii as its radius. [param bounciness] C is 0..1, [param friction]
## µ is 0 or more. What cannot be used is an error.
static func between(
	one: Ball, other: Ball, bounciness: float, friction: float
) -> BallFrictionImpact:
	var impact := BallFrictionImpact.new()
	impact._keep(one, other)
	if not _is_usable(one, other, bounciness, friction):
		return impact
	var way := one.position.minus(other.position)
	var velocity := one.velocity.minus(other.velocity)
	var finder := StraightImpactFinder.new()
	impact.hit = finder.with_point(
		way.x, way.y, velocity.x, velocity.y, one.radius + other.radius, 0.0, 0.0
	)
	if impact.hit:
		var normal_then := Vec2.new(finder.normal_x, finder.normal_y)
		impact._bounce(one, other, finder.time, normal_then, bounciness, friction)
	return impact


## The same by the quadratic formula of the lecture, within [param longest] seconds. Where the balls
## graze, or are far from each other, b² - 4 a c loses its digits.
static func between_by_the_slide(
	one: Ball, other: Ball, bounciness: float, friction: float, longest: float
) -> BallFrictionImpact:
	var impact := BallFrictionImpact.new()
	impact._keep(one, other)
	if not _is_usable(one, other, bounciness, friction):
		return impact
	var motion := one.velocity.minus(other.velocity).scaled(longest)
	var reach := one.radius + other.radius
	var found := CapImpact.with_point(
		one.position, motion, reach, other.position, Impact.Feature.START
	)
	impact.hit = found.hit
	if found.hit:
		var seconds := found.fraction * longest
		impact._bounce(one, other, seconds, found.normal, bounciness, friction)
	return impact


func _keep(one: Ball, other: Ball) -> void:
	velocity_one = one.velocity.copy()
	spin_one = one.spin
	velocity_other = other.velocity.copy()
	spin_other = other.spin


func _bounce(
	one: Ball, other: Ball, at_time: float, with_normal: Vec2, bounciness: float, friction: float
) -> void:
	time = at_time
	normal = with_normal
	var first := one.copy()
	var second := other.copy()
	regime = BallFrictionBounce.bounce(first, second, normal, bounciness, friction)
	_keep(first, second)


static func _is_usable(one: Ball, other: Ball, bounciness: float, friction: float) -> bool:
	for problem: String in [
		one.problem(Friction.LARGEST),
		other.problem(Friction.LARGEST),
		FrictionBounce.problem_of_surface(bounciness, friction),
		Friction.problem_of_sizes(
			one.position.distance_to(other.position) + one.radius + other.radius,
			one.velocity.distance_to(other.velocity)
		),
	]:
		if problem:
			push_error("BallFrictionImpact: " + problem)
			return false
	return true
