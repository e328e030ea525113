class_name BallMeeting
extends RefCounted
## Two balls at the moment at which they meet, and what Newton's laws make of their velocities. All
## lengths in units of the plane, all velocities in units per second.
##
## The normal n points from ball 1 to ball 2. Only what lies along n changes.

## Which of the balls on the board is ball 1, counted from 0.
var first := 0
## Which is ball 2.
var second := 1
## When they meet, in seconds since the start.
var time := 0.0
## Ball 1 as it is when they touch, before the bounce.
var one: Ball
## Ball 2.
var two: Ball
## The unit normal n, from the centre of ball 1 to that of ball 2.
var normal: Vec2
## The bounciness C, 0..1.
var bounciness := 1.0


## Of [param ball_one] and [param ball_two], which touch, with this bounciness.
func _init(ball_one: Ball, ball_two: Ball, its_bounciness: float) -> void:
	one = ball_one
	two = ball_two
	bounciness = its_bounciness
	normal = two.position.minus(one.position).normalized()


## The closing speed w along n: above 0 as long as they approach.
func closing_speed() -> float:
	return one.velocity.minus(two.velocity).dot(normal)


## m₁ + m₂.
func total_mass() -> float:
	return one.mass + two.mass


## m₁ m₂ / (m₁ + m₂), the reduced mass.
func reduced_mass() -> float:
	return one.mass * (two.mass / total_mass())


## The impulse J = (1 + C) m₁ m₂ / (m₁ + m₂) w that each gives the other, in mass times speed.
func impulse() -> float:
	return (1.0 + bounciness) * reduced_mass() * closing_speed()


## V, the velocity of the centre of mass: the bounce does not change it.
func center_velocity() -> Vec2:
	return momentum().divided(total_mass())


## Where the centre of mass is when they meet.
func center() -> Vec2:
	var sum := one.position.scaled(one.mass).plus(two.position.scaled(two.mass))
	return sum.divided(total_mass())


## Both velocities after the bounce, by [method BallBounce.apply].
func velocities_after() -> Array[Vec2]:
	var after_one := one.copy()
	var after_two := two.copy()
	BallBounce.apply(after_one, after_two, normal.negated(), bounciness)
	return [after_one.velocity, after_two.velocity]


## The momentum P of both together before the bounce.
func momentum() -> Vec2:
	return momentum_of([one.velocity, two.velocity])


## The momentum of both with these velocities.
func momentum_of(velocities: Array[Vec2]) -> Vec2:
	return velocities[0].scaled(one.mass).plus(velocities[1].scaled(two.mass))


## The kinetic energy of both before the bounce.
func energy() -> float:
	return energy_of([one.velocity, two.velocity])


## The kinetic energy of both with these velocities.
func energy_of(velocities: Array[Vec2]) -> float:
	return (
		one.mass * velocities[0].length_squared() / 2.0
		+ two.mass * velocities[1].length_squared() / 2.0
	)


## What the bounce costs: (1 - C²) m₁ m₂ / (m₁ + m₂) w² / 2, for the share of the closing speed that
## does not come back.
func lost_energy() -> float:
	return (1.0 - bounciness ** 2) * reduced_mass() * closing_speed() ** 2 / 2.0


## The largest of all speeds here: differences below a share of it are rounding.
func speed_scale() -> float:
	return one.velocity.length() + two.velocity.length()
