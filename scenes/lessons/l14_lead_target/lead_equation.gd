class_name LeadEquation
extends RefCounted
## The equation |P + V t| = R + s t for the moment at which a bullet touches, and what its square
## a t² + 2 b t + c = 0 is made of. [LeadAim] finds its roots without losing digits.

# A difference up to this share of its terms is rounding.
const _ROUNDING := 1.0 / 2.0 ** 50

## P: from the shooter to the target, in pixels.
var way: Vec2
## V: the velocity of the target as the shooter sees it, in pixels per second.
var velocity: Vec2
## s: the speed of the bullet, in pixels per second; above 0.
var speed: float
## R: the radii of both together, in pixels.
var radius: float
## V · V - s²; above 0 where the target is faster, and 0 where only rounding makes a difference.
var a: float
## P · V - s R.
var b: float
## P · P - R².
var c: float
## b² - a c; below 0 there is no root.
var discriminant: float


## The equation with these numbers. The vectors are copied.
func _init(from_shooter: Vec2, its_velocity: Vec2, its_speed: float, its_radius: float) -> void:
	way = from_shooter.copy()
	velocity = its_velocity.copy()
	speed = its_speed
	radius = its_radius
	# As LeadAim has it: where both are nearly equal, a difference of squares loses its digits.
	var fast := velocity.length()
	a = (fast - speed) * (fast + speed)
	if absf(a) <= _ROUNDING * (velocity.length_squared() + speed * speed):
		a = 0.0
	b = way.dot(velocity) - speed * radius
	c = way.length_squared() - radius * radius
	discriminant = b * b - a * c


## Whether both touch from the start.
func touches_at_once() -> bool:
	return way.length() <= radius


## The moments from 0 on at which the bullet can touch, the earlier first; none where both touch at
## once.
func times() -> PackedFloat64Array:
	if touches_at_once():
		return []
	return LeadAim.times(way, velocity, speed, radius)


## The root that is no hit: below 0, or the later one of two. NAN where there is none. Taken without
## a difference of nearly equal numbers.
func other_root() -> float:
	var root := sqrt(discriminant)
	if a == 0.0 or is_nan(root) or touches_at_once():
		return NAN
	return (root - b) / a if b <= 0.0 else -c / (b + root)


## The root (-b + √D) / a where it is below 0, as it is for a bullet that is faster than the target;
## else NAN.
func root_below_zero() -> float:
	var root := (sqrt(discriminant) - b) / a
	return root if root < 0.0 and root > -INF and not touches_at_once() else NAN


## P + V t after [param seconds].
func way_after(seconds: float) -> Vec2:
	return way.plus(velocity.scaled(seconds))


## R + s t after [param seconds].
func reach_after(seconds: float) -> float:
	return radius + speed * seconds


## The direction that hits first, of length 1; zero where none hits.
func direction() -> Vec2:
	if touches_at_once():
		return way.normalized()
	var found := times()
	return way_after(found[0]).normalized() if found else Vec2.new()
