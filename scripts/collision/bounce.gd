class_name Bounce
extends RefCounted
## Parts 14 and 15 of the lecture: the law of reflection, v - (1 + C) (v . n) n, and when to apply
## it.


## Whether the velocity has a part against the normal. A ball that already moves away must not be
## reflected again: it would stick to the line.
static func is_approaching(velocity: Vec2, normal: Vec2) -> bool:
	return velocity.dot(normal) < 0.0


## Reflects the velocity off a line with this unit normal if the ball approaches; otherwise it does
## not change. [param bounciness] C is 0..1: with 0 the ball slides on, with 1 it keeps its speed.
static func apply(velocity: Vec2, normal: Vec2, bounciness: float = 1.0) -> void:
	if is_approaching(velocity, normal):
		velocity.reflect(normal, bounciness)


## "" if [param bounciness] can be used; otherwise one sentence with the value and what is allowed.
static func problem_of_bounciness(bounciness: float) -> String:
	if bounciness >= 0.0 and bounciness <= 1.0:
		return ""
	return "The bounciness C must be within 0..1, not %s." % bounciness
