class_name FreeFlight
extends RefCounted
## How a ball moves between two bounces, under gravity that stays as it is.


## The way in pixels within [param seconds]: v t + g t^2 / 2.
static func motion(velocity: Vec2, gravity: Vec2, seconds: float) -> Vec2:
	return velocity.scaled(seconds).plus(gravity.scaled(seconds * seconds / 2.0))


## The velocity after [param seconds], in pixels per second: v + g t.
static func velocity_after(velocity: Vec2, gravity: Vec2, seconds: float) -> Vec2:
	return velocity.plus(gravity.scaled(seconds))


## The velocity once the ball has got as far as [param way], about [param seconds] later. Its part
## along gravity is the one that belongs to the height: v^2 = v0^2 + 2 g s. So the energy stays,
## although within a frame the lecture takes the curved path as straight.
static func velocity_at(velocity: Vec2, gravity: Vec2, way: Vec2, seconds: float) -> Vec2:
	var strength := gravity.length()
	var down := gravity.normalized()
	var before := velocity.dot(down)
	var square := maxf(before * before + 2.0 * strength * way.dot(down), 0.0)
	var after := signf(before + strength * seconds) * sqrt(square)
	return velocity.plus(down.scaled(after - before))
