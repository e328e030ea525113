class_name BallBounce
extends RefCounted
## The bounce of two balls under Newton's laws. Along the contact normal, seen from their centre of
## mass with the speed u, each ball leaves as fast as it came, times the bounciness C:
## v' = u - C (v - u). Across the normal nothing changes. A wall is the limit of a very heavy ball
## with u = 0.


## The speed of the centre of mass of both balls along [param normal], in pixels per second.
static func center_speed(one: Ball, other: Ball, normal: Vec2) -> float:
	var momentum := one.mass * one.velocity.dot(normal) + other.mass * other.velocity.dot(normal)
	return momentum / (one.mass + other.mass)


## Bounces both balls off each other if they approach; [param normal] has length 1 and points from
## the other ball to the first, [param bounciness] C is 0..1.
static func apply(one: Ball, other: Ball, normal: Vec2, bounciness: float = 1.0) -> void:
	var approach := one.velocity.minus(other.velocity).dot(normal)
	if approach >= 0.0:
		return
	var total := one.mass + other.mass
	var change := -(1.0 + bounciness) * approach
	one.velocity.add(normal.scaled(change * (other.mass / total)))
	other.velocity.subtract(normal.scaled(change * (one.mass / total)))
