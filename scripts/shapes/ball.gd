class_name Ball
extends RefCounted
## A round body that moves: its position, velocity, spin, radius and mass.

## The centre, in pixels.
var position: Vec2
## Pixels per second.
var velocity: Vec2
## Pixels, above 0.
var radius: float
## The mass in any unit, above 0. Only collisions of balls with each other use it.
var mass: float
## How fast the ball turns, in radians per second, clockwise on screen. Only friction uses and
## changes it.
var spin: float


## A ball, at rest unless [param at_velocity] or [param with_spin] is given. Both vectors are
## copied, so that nothing is shared.
func _init(
	at_position: Vec2,
	with_radius: float,
	at_velocity: Vec2 = Vec2.new(),
	with_mass: float = 1.0,
	with_spin: float = 0.0
) -> void:
	position = at_position.copy()
	velocity = at_velocity.copy()
	radius = with_radius
	mass = with_mass
	spin = with_spin


## A ball that shares nothing with this one.
func copy() -> Ball:
	return Ball.new(position, radius, velocity, mass, spin)


## "" if this ball can be used; otherwise one sentence with the value and what is allowed. All its
## numbers must be finite and no larger than [param largest]; radius and mass must be above 0.
func problem(largest: float = INF) -> String:
	var wrong := _problem_of_numbers()
	if wrong:
		return wrong
	var limit := String.num_scientific(largest)
	if not (position.is_within(largest) and velocity.is_within(largest)):
		var values := [limit, limit, position, velocity]
		return "A ball's position and velocity must be within -%s..%s, not %s and %s." % values
	if absf(spin) > largest:
		return "A ball's spin must be within -%s..%s rad/s, not %s." % [limit, limit, spin]
	if radius > largest or mass > largest:
		return "A ball's radius and mass must be at most %s, not %s and %s." % [limit, radius, mass]
	return ""


func _problem_of_numbers() -> String:
	if not (position.is_finite() and velocity.is_finite()):
		return (
			"A ball's position and velocity must be finite, not %s and %s." % [position, velocity]
		)
	if not (radius > 0.0 and is_finite(radius)):
		return "A ball's radius must be above 0 and finite, not %s." % radius
	if not (mass > 0.0 and is_finite(mass)):
		return "A ball's mass must be above 0 and finite, not %s." % mass
	if not is_finite(spin):
		return "A ball's spin must be finite, not %s rad/s." % spin
	return ""
