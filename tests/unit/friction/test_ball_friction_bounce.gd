extends LabTest
## The bounce of two balls with friction: the numbers of the lesson, and what it keeps and loses.

var _normal := Vec2.new(-0.8, -0.6)


# The "throw" of pool: with friction the ball that is hit does not leave along the normal.
func test_the_lesson_s_pool_balls() -> void:
	var slick := _pool(0.0)
	assert_vec2(slick[1].velocity, Vec2.new(160, 120), 1e-13)
	assert_eq(slick[1].spin, 0.0)
	var rough := _pool(0.2)
	assert_vec2(rough[1].velocity, Vec2.new(175, 100), 1e-13)
	assert_vec2(rough[0].velocity, Vec2.new(75, -100), 1e-13)
	assert_almost_eq(rough[0].spin, rough[1].spin, 1e-15)


func test_balls_that_move_apart_are_left_alone() -> void:
	var one := Ball.new(Vec2.zero(), 20, Vec2.new(-250, 0), 1.0, 3.0)
	var other := Ball.new(Vec2.new(32, 24), 20)
	var regime := BallFrictionBounce.bounce(one, other, _normal, 1.0, 0.2)
	assert_eq([regime, one.spin, other.spin], [Friction.Regime.NONE, 3.0, 0.0])
	assert_vec2(one.velocity, Vec2.new(-250, 0), 0.0)


func test_without_friction_it_is_the_bounce_of_newton() -> void:
	for pair in _pairs(100):
		var one := pair.one.copy()
		var other := pair.other.copy()
		BallBounce.apply(one, other, pair.normal, pair.bounciness)
		pair.friction = 0.0
		pair.bounce()
		assert_vec2(pair.one.velocity, one.velocity, 1e-12)
		assert_vec2(pair.other.velocity, other.velocity, 1e-12)


func test_momentum_and_angular_momentum_are_kept() -> void:
	var changes: PackedFloat64Array = []
	for pair in _pairs(200):
		var momentum := pair.momentum()
		var turning := pair.angular_momentum()
		pair.bounce()
		changes.append(pair.momentum().distance_to(momentum) / momentum.length())
		changes.append(absf(pair.angular_momentum() - turning) / pair.size_of_turning())
	assert_all_at_most(changes, 1e-12)


# With the common mass 1 / M = 1 / m1 + 1 / m2: M (1 - C²) vn² / 2, and sticking M slip² / 6,
# slipping M µ jn (|slip| - 3/2 µ jn).
func test_the_energy_that_is_lost() -> void:
	var errors: PackedFloat64Array = []
	var sticks := 0
	for pair in _pairs(200):
		var slip := pair.slip()
		var approach := pair.relative().dot(pair.normal)
		var grip := pair.friction * (1.0 + pair.bounciness) * -approach
		var lost := 0.5 * (1.0 - pair.bounciness ** 2) * approach ** 2
		var before := Disc.energy(pair.one) + Disc.energy(pair.other)
		var mass := pair.one.mass * pair.other.mass / (pair.one.mass + pair.other.mass)
		if pair.bounce() == Friction.Regime.STICK:
			sticks += 1
			assert_almost_eq(pair.slip(), 0.0, 1e-10)
			lost += slip * slip / 6.0
		else:
			lost += grip * (absf(slip) - 1.5 * grip)
		var after := Disc.energy(pair.one) + Disc.energy(pair.other)
		errors.append(absf(before - after - mass * lost) / before)
	assert_all_at_most(errors, 1e-13)
	assert_between(sticks, 40, 160)


func test_the_balls_swapped_give_the_same() -> void:
	for pair in _pairs(100):
		var one := pair.one.copy()
		var other := pair.other.copy()
		pair.bounce()
		var normal := pair.normal.negated()
		BallFrictionBounce.bounce(other, one, normal, pair.bounciness, pair.friction)
		assert_vec2(one.velocity, pair.one.velocity, 1e-12)
		assert_almost_eq(other.spin, pair.other.spin, 1e-12)


func test_a_very_heavy_ball_is_a_wall() -> void:
	for pair in _pairs(100):
		pair.other.mass = 1e30
		pair.other.spin = 0.0
		var alone := pair.one.copy()
		var wall := pair.other.velocity.copy()
		FrictionBounce.bounce(alone, pair.normal, pair.bounciness, pair.friction, wall)
		pair.bounce()
		assert_vec2(pair.one.velocity, alone.velocity, 1e-11)
		assert_almost_eq(pair.one.spin, alone.spin, 1e-11)


func test_what_cannot_be_used_is_an_error_and_changes_nothing() -> void:
	var one := Ball.new(Vec2.zero(), 20, Vec2.new(250, 0))
	var other := Ball.new(Vec2.new(32, 24), 20)
	BallFrictionBounce.bounce(one, other, Vec2.zero(), 1.0, 0.1)
	assert_push_error("The normal must have length 1, but has length 0.0.")
	BallFrictionBounce.bounce(one, other, _normal, NAN, 0.1)
	assert_push_error("The bounciness C must be within 0..1, not nan.")
	BallFrictionBounce.bounce(one, other, _normal, 1.0, NAN)
	assert_push_error("The friction µ must be within 0..1e+152, not nan.")
	assert_vec2(one.velocity, Vec2.new(250, 0), 0.0)
	assert_vec2(other.velocity, Vec2.zero(), 0.0)


func _pool(friction: float) -> Array[Ball]:
	var one := Ball.new(Vec2.zero(), 20, Vec2.new(250, 0))
	var other := Ball.new(Vec2.new(32, 24), 20)
	BallFrictionBounce.bounce(one, other, _normal, 1.0, friction)
	return [one, other]


static func _pairs(count: int) -> Array[Pair]:
	var rng := RandomNumberGenerator.new()
	rng.seed = 91
	var pairs: Array[Pair] = []
	while pairs.size() < count:
		pairs.append(Pair.new(rng))
	return pairs


class Pair:
	var one: Ball
	var other: Ball
	var normal: Vec2
	var bounciness: float
	var friction: float

	func _init(rng: RandomNumberGenerator) -> void:
		normal = Vec2.random_unit(rng)
		one = _random_ball(rng)
		other = _random_ball(rng)
		one.position = other.position.plus(normal.scaled(one.radius + other.radius))
		if relative().dot(normal) > 0.0:
			var swapped := one.velocity
			one.velocity = other.velocity
			other.velocity = swapped
		bounciness = rng.randf()
		friction = rng.randf_range(0.01, 0.6)

	func relative() -> Vec2:
		return one.velocity.minus(other.velocity)

	func slip() -> float:
		var along := relative().dot(Vec2.new(-normal.y, normal.x))
		return along - one.radius * one.spin - other.radius * other.spin

	func momentum() -> Vec2:
		return one.velocity.scaled(one.mass).plus(other.velocity.scaled(other.mass))

	func angular_momentum() -> float:
		var point := Vec2.new(37, -20)
		return Disc.angular_momentum(one, point) + Disc.angular_momentum(other, point)

	# A sum in which nothing cancels.
	func size_of_turning() -> float:
		var sum := 0.0
		for ball: Ball in [one, other]:
			sum += ball.mass * ball.velocity.length() * (ball.position.length() + 50.0)
		return sum

	func bounce() -> Friction.Regime:
		return BallFrictionBounce.bounce(one, other, normal, bounciness, friction)

	static func _random_ball(rng: RandomNumberGenerator) -> Ball:
		var velocity := Vec2.random_unit(rng).scaled(rng.randf_range(1, 500))
		var place := Vec2.random_unit(rng).scaled(rng.randf_range(0, 300))
		var spin := rng.randf_range(-20, 20)
		return Ball.new(place, rng.randf_range(5, 30), velocity, rng.randf_range(0.5, 5), spin)
