class_name Disc
extends RefCounted
## A ball as a flat disc of even thickness: what it carries when it moves and turns.

## The moment of inertia of a disc is this times m r². A ring has 1, a solid sphere 2/5.
const INERTIA := 0.5


## The moment of inertia about the centre, m r² / 2.
static func moment_of_inertia(ball: Ball) -> float:
	return INERTIA * ball.mass * ball.radius * ball.radius


## The energy of motion, of the flight and of the spin together: m v² / 2 + I spin² / 2.
static func energy(ball: Ball) -> float:
	var flight := ball.mass * ball.velocity.length_squared()
	return 0.5 * (flight + moment_of_inertia(ball) * ball.spin * ball.spin)


## The angular momentum about [param point], m (P - point) × v + I spin; positive is clockwise on
## screen.
static func angular_momentum(ball: Ball, point: Vec2) -> float:
	var flight := ball.mass * ball.position.minus(point).cross(ball.velocity)
	return flight + moment_of_inertia(ball) * ball.spin
