class_name FrictionContact
extends RefCounted
## A ball that touches a line, or an equal ball at rest, and what friction makes of it. The contact
## is at the origin of the board; all impulses are per mass, in px/s.
##
## The normal n points to the ball. The tangent t is n turned by 90 degrees, clockwise on screen.

## The ball as it comes.
var ball: Ball
## The ball at rest that it meets; null for a line.
var other: Ball
## The direction of the surface, of any length above 0.
var along: Vec2
## The unit normal n, to [member ball].
var normal: Vec2
## The unit tangent t, along the surface.
var tangent: Vec2
## The bounciness C, 0..1.
var bounciness: float
## The friction µ, 0 or more.
var friction: float


## Of [param its_ball] on a surface along [param its_along], with the bounciness [param c] and the
## friction [param mu]. Where both balls are is set here.
func _init(its_ball: Ball, its_along: Vec2, c: float, mu: float, its_other: Ball = null) -> void:
	along = its_along.copy()
	tangent = along.normalized()
	normal = Vec2.new(tangent.y, -tangent.x)
	ball = its_ball.copy()
	ball.position = normal.scaled(ball.radius)
	if its_other:
		other = its_other.copy()
		other.position = normal.scaled(-other.radius)
	bounciness = c
	friction = mu


## The part of the velocity along the surface, v · t.
func along_speed() -> float:
	return ball.velocity.dot(tangent)


## The part along n, v · n: below 0, because the ball comes.
func normal_speed() -> float:
	return ball.velocity.dot(normal)


## The slip u = v · t - r ω: how fast the surfaces rub along each other, in px/s.
func slip() -> float:
	return along_speed() - ball.radius * ball.spin


## The impulse along n, jn = -(1 + C) v · n.
func push() -> float:
	return -(1.0 + bounciness) * normal_speed()


## The most that friction can be, µ jn.
func limit() -> float:
	return friction * push()


## Whether the surfaces stick, or slip on.
func regime() -> Friction.Regime:
	return Friction.regime(slip(), push(), friction)


## The impulse jt along t.
func grip() -> float:
	return Friction.impulse(slip(), push(), friction)


## Which part of the impulse changes the ball: all of it at a line, half of it at an equal ball.
func share() -> float:
	return 0.5 if other else 1.0


## The balls as they leave, by [method FrictionBounce.bounce] or [method BallFrictionBounce.bounce].
func after() -> Array[Ball]:
	var leaving := _copies()
	if other:
		BallFrictionBounce.bounce(leaving[0], leaving[1], normal, bounciness, friction)
	else:
		FrictionBounce.bounce(leaving[0], normal, bounciness, friction)
	return leaving


## The balls if [param along_surface] were the impulse along t, and [param turning] what of it turns
## them.
func after_with(along_surface: float, turning: float) -> Array[Ball]:
	var leaving := _copies()
	var change := normal.scaled(push()).plus(tangent.scaled(along_surface)).scaled(share())
	var turn := -turning * share() / (Disc.INERTIA * ball.radius)
	leaving[0].velocity.add(change)
	leaving[0].spin += turn
	if other:
		leaving[1].velocity.subtract(change)
		leaving[1].spin += turn
	return leaving


## The balls as they come.
func before() -> Array[Ball]:
	return _copies()


## The energy of flight and spin of [param balls] together, in mass times px²/s².
static func energy(balls: Array[Ball]) -> float:
	var sum := 0.0
	for one in balls:
		sum += Disc.energy(one)
	return sum


## What of this energy the flight along n has, the flight along t, and the spin.
func energy_parts(balls: Array[Ball]) -> PackedFloat64Array:
	var parts: PackedFloat64Array = [0.0, 0.0, 0.0]
	for one in balls:
		parts[0] += 0.5 * one.mass * one.velocity.dot(normal) ** 2
		parts[1] += 0.5 * one.mass * one.velocity.dot(tangent) ** 2
		parts[2] += 0.5 * Disc.moment_of_inertia(one) * one.spin ** 2
	return parts


## The angular momentum of [param balls] about the contact, in mass times px²/s; positive is
## clockwise on screen.
static func angular_momentum(balls: Array[Ball]) -> float:
	var sum := 0.0
	for one in balls:
		sum += Disc.angular_momentum(one, Vec2.zero())
	return sum


## What of this angular momentum the flight has, and the spin.
static func momentum_parts(balls: Array[Ball]) -> PackedFloat64Array:
	var parts: PackedFloat64Array = [0.0, 0.0]
	for one in balls:
		parts[0] += one.mass * one.position.cross(one.velocity)
		parts[1] += Disc.moment_of_inertia(one) * one.spin
	return parts


## What the bounce takes along n: (1 - C²) (v · n)² / 2, times the share.
func lost_to_bounce() -> float:
	return 0.5 * share() * (1.0 - bounciness ** 2) * normal_speed() ** 2


## What friction takes: u² / 6 where the surfaces stick, µ jn (|u| - 3/2 µ jn) where they slip,
## times the share.
func lost_to_friction() -> float:
	if regime() == Friction.Regime.STICK:
		return share() * slip() ** 2 / 6.0
	return share() * limit() * (absf(slip()) - 1.5 * limit())


## The largest of all speeds here: differences below a small share of it are rounding.
func speed_scale() -> float:
	return ball.velocity.length() + absf(ball.radius * ball.spin) + push() * (1.0 + friction)


func _copies() -> Array[Ball]:
	var balls: Array[Ball] = [ball.copy()]
	if other:
		balls.append(other.copy())
	return balls
