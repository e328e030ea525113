class_name Bounce
extends RefCounted
## Parts 14 and 15 of the lecture: the law of reflection, v - (1 + C) (v . n) n, and when to apply
## it.


## Whether the velocity has a part against the normal. A ball that already moves away must not be
## reflected once more: it would stick to the line.
static func is_approaching(velocity: Vec2, normal: Vec2) -> bool:
	return velocity.dot(normal) < 0.0


## Reflects the velocity off a line with this unit normal if it approaches, else leaves it alone.
## [param bounciness] C is 0..1: 0 slides on, 1 keeps the speed.
static func apply(velocity: Vec2, normal: Vec2, bounciness: float = 1.0) -> void:
	if is_approaching(velocity, normal):
		velocity.reflect(normal, bounciness)
