class_name FreeFlight
extends RefCounted
## How a ball moves between two bounces under constant gravity.


## The motion in pixels within [param seconds]: v t + g t^2 / 2.
static func motion(velocity: Vec2, gravity: Vec2, seconds: float) -> Vec2:
	return velocity.scaled(seconds).plus(gravity.scaled(seconds * seconds / 2.0))


## The velocity after [param seconds], in pixels per second: v + g t.
static func velocity_after(velocity: Vec2, gravity: Vec2, seconds: float) -> Vec2:
	return velocity.plus(gravity.scaled(seconds))


## The velocity after the ball has moved by [param way], about [param seconds] later. Its part along
## gravity follows from the height: v^2 = v0^2 + 2 g s. So energy is conserved, although within a
## frame the lecture takes the curved path as straight.
static func velocity_at(velocity: Vec2, gravity: Vec2, way: Vec2, seconds: float) -> Vec2:
	var strength := gravity.length()
	var down := gravity.normalized()
	var before := velocity.dot(down)
	var square := maxf(before * before + 2.0 * strength * way.dot(down), 0.0)
	var after := signf(before + strength * seconds) * sqrt(square)
	return velocity.plus(down.scaled(after - before))


## The first time in seconds at which height + velocity t + pull t^2 / 2 is at most 0 and falling:
## when something in free flight touches a plane on its way down. INF if that never happens. At
## height 0 or below, the time is 0 if the height falls or is about to fall; otherwise it is the
## time of the return.
static func time_to_fall(height: float, velocity: float, pull: float) -> float:
	if height <= 0.0 and (velocity < 0.0 or (velocity == 0.0 and pull < 0.0)):
		return 0.0
	var squared := velocity * velocity - 2.0 * pull * height
	# Upwards first, or from below: it comes back only if it is pulled down. Both forms add numbers
	# of the same sign, so that no digits cancel.
	if velocity >= 0.0:
		return (velocity + sqrt(maxf(squared, 0.0))) / -pull if pull < 0.0 else INF
	return 2.0 * height / (sqrt(squared) - velocity) if squared > 0.0 else INF


## "" if [param gravity], in px/s², can be used: both its components must be within
## -[param largest]..[param largest]. Otherwise one sentence with the value and what is allowed.
static func problem_of_gravity(gravity: Vec2, largest: float) -> String:
	if gravity.is_within(largest):
		return ""
	var limit := String.num_scientific(largest)
	return "Gravity must be within -%s..%s px/s² in x and y, not %s." % [limit, limit, gravity]


## Seconds until a ball that flies off a circle along its tangent is on the circle again; INF for
## never. (x, y) leads from the centre of the circle to the ball, r; the velocity v is perpendicular
## to it. So |r + v t + g t² / 2|² = r² leaves v² + r · g + (v · g) t + g² t² / 4 = 0. A ball that
## does not climb never comes back.
static func time_back_to_circle(
	x: float, y: float, vx: float, vy: float, gx: float, gy: float
) -> float:
	var growth := vx * gx + vy * gy
	var away := maxf(vx * vx + vy * vy + x * gx + y * gy, 0.0)
	var discriminant := growth * growth - (gx * gx + gy * gy) * away
	if growth >= 0.0 or discriminant < 0.0:
		return INF
	return 2.0 * away / (sqrt(discriminant) - growth)
