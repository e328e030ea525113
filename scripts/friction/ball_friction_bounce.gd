class_name BallFrictionBounce
extends RefCounted
## The bounce of two balls with friction: [BallBounce] along the normal, [Friction] along the
## surfaces. By Newton's third law both get the same impulse, in opposite directions; but friction
## turns both the same way round.


## Changes velocities and spins of both balls if they approach, and tells what the contact did.
## [param normal] has length 1 and points from the other ball to the first, [param bounciness] C is
## 0..1, [param friction] µ is 0 or more. Values that cannot be used are an error, and nothing
## changes.
##
## A slide writes impulses J = -(1 + C) v.n M with 1 / M = 1 / m1 + 1 / m2, and divides them by the
## masses again. Here each ball takes its share of the change at once: m2 / (m1 + m2) of it, and
## m1 / (m1 + m2), so that no 1 / m overflows.
static func bounce(
	one: Ball, other: Ball, normal: Vec2, bounciness: float, friction: float
) -> Friction.Regime:
	var problem := FrictionBounce.problem_of(normal, bounciness, friction)
	if problem:
		push_error("BallFrictionBounce.bounce: " + problem)
		return Friction.Regime.NONE
	var relative := one.velocity.minus(other.velocity)
	if not Bounce.is_approaching(relative, normal):
		return Friction.Regime.NONE
	var tangent := Vec2.new(-normal.y, normal.x)
	var slip := relative.dot(tangent) - one.radius * one.spin - other.radius * other.spin
	var push := -(1.0 + bounciness) * relative.dot(normal)
	var grip := Friction.impulse(slip, push, friction)
	var change := normal.scaled(push).plus(tangent.scaled(grip))
	var total := one.mass + other.mass
	_take(one, change, grip, other.mass / total)
	_take(other, change.negated(), grip, one.mass / total)
	return Friction.regime(slip, push, friction)


static func _take(ball: Ball, change: Vec2, grip: float, share: float) -> void:
	ball.velocity.add(change.scaled(share))
	ball.spin -= grip * share / (Disc.INERTIA * ball.radius)
