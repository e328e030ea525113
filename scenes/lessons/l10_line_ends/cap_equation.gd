class_name CapEquation
extends RefCounted
## The quadratic a t² + b t + c = 0 whose roots are the fractions of the frame at which a ball is
## one radius away from a point, with all its parts for the formula lines. [CapImpact] computes the
## same in one go.

## From the point to the ball's centre at the beginning of the frame, in pixels.
var difference: Vec2
## The way of the whole frame, in pixels.
var motion: Vec2
## The ball's radius, in pixels.
var radius: float
## motion . motion; 0 for a ball at rest, which has no roots.
var a: float
## 2 difference . motion; negative while the ball approaches.
var b: float
## difference . difference - radius²; negative where ball and point overlap.
var c: float


## The equation for a ball that moves by [param by] from [param from], and [param point].
func _init(from: Vec2, by: Vec2, with_radius: float, point: Vec2) -> void:
	difference = from.minus(point)
	motion = by.copy()
	radius = with_radius
	a = motion.dot(motion)
	b = 2.0 * difference.dot(motion)
	c = difference.dot(difference) - radius * radius


## b² - 4 a c: below 0 the ball passes the point by, at 0 it grazes it.
func discriminant() -> float:
	return b * b - 4.0 * a * c


## Whether the distance is ever the radius, before, in or after the frame.
func has_roots() -> bool:
	return a > 0.0 and discriminant() >= 0.0


## The fraction of the frame at which the ball comes to the point; only with [method has_roots].
func first_root() -> float:
	return (-b - sqrt(discriminant())) / (2.0 * a)


## The fraction of the frame at which the ball would leave the point again; only with
## [method has_roots].
func second_root() -> float:
	return (-b + sqrt(discriminant())) / (2.0 * a)


## Pixels between the point and the ball's centre after [param fraction] of the frame.
func distance_at(fraction: float) -> float:
	return difference.plus(motion.scaled(fraction)).length()
