class_name FrictionBounce
extends RefCounted
## The bounce off a line or a cap with friction: [Bounce] along the normal, [Friction] along the
## surface. What is touched may move; only the difference of the velocities counts.


## Changes velocity and spin of [param ball] if it approaches what it touches, and tells what the
## contact did. [param normal] has length 1 and points to the ball's centre, [param bounciness] C is
## 0..1, [param friction] µ is 0 or more. [param wall_velocity] is that of the touched point, in
## px/s. Values that cannot be used are an error, and nothing changes.
static func bounce(
	ball: Ball, normal: Vec2, bounciness: float, friction: float, wall_velocity := Vec2.zero()
) -> Friction.Regime:
	var problem := problem_of(normal, bounciness, friction)
	if not problem and not wall_velocity.is_within(Friction.LARGEST):
		var limit := String.num_scientific(Friction.LARGEST)
		var values := [limit, limit, wall_velocity]
		problem = "The velocity of a wall must be within -%s..%s px/s, not %s." % values
	if problem:
		push_error("FrictionBounce.bounce: " + problem)
		return Friction.Regime.NONE
	var relative := ball.velocity.minus(wall_velocity)
	if not Bounce.is_approaching(relative, normal):
		return Friction.Regime.NONE
	var tangent := Vec2.new(-normal.y, normal.x)
	var slip := relative.dot(tangent) - ball.radius * ball.spin
	var push := -(1.0 + bounciness) * relative.dot(normal)
	var grip := Friction.impulse(slip, push, friction)
	ball.velocity.add(normal.scaled(push).plus(tangent.scaled(grip)))
	ball.spin -= grip / (Disc.INERTIA * ball.radius)
	return Friction.regime(slip, push, friction)


## "" if these can be used for a bounce with friction; otherwise one sentence with the value and
## what is allowed.
static func problem_of(normal: Vec2, bounciness: float, friction: float) -> String:
	if not absf(normal.length() - 1.0) <= 1e-9:
		return "The normal must have length 1, but has length %s." % normal.length()
	return problem_of_surface(bounciness, friction)


## The same for what belongs to the surface alone.
static func problem_of_surface(bounciness: float, friction: float) -> String:
	var problem := Bounce.problem_of_bounciness(bounciness)
	return problem if problem else Friction.problem_of(friction)
