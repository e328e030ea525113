class_name BallBounce
extends RefCounted
## Two balls under Newton's laws: along the contact normal each leaves the common speed u of their
## centre of mass as it came, less the share that is lost: v' = u - C (v - u). Across the normal
## nothing changes. A wall is the limit of a very heavy ball with u = 0.


## How fast the centre of mass of both moves along [param normal], in pixels per second.
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
