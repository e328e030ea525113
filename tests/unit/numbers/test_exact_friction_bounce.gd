extends LabTest
## The bounce with friction to twice the digits, against the law in doubles and against numbers that
## are known.

const _BOUNCES := 300


func test_it_knows_the_numbers_of_the_table() -> void:
	var ball := Ball.new(Vec2.zero(), 20.0, Vec2.new(300.0, 400.0))
	var sticks := ExactFrictionBounce.new(ball, Vec2.new(7.0, 0.0), 1.0, 0.25)
	assert_eq(sticks.error_of(Vec2.new(200.0, -400.0)), 0.0)
	assert_eq(sticks.error_of_spin(10.0), 0.0)
	assert_eq(sticks.error_of(Vec2.new(203.0, -396.0)), 5.0)
	assert_eq(sticks.error_of_spin(12.0), 2.0)
	var slips := ExactFrictionBounce.new(ball, Vec2.new(7.0, 0.0), 1.0, 0.1)
	assert_almost_eq(slips.error_of(Vec2.new(220.0, -400.0)), 0.0, 1e-13)
	assert_almost_eq(slips.error_of_spin(8.0), 0.0, 1e-14)
	var hits := Ball.new(Vec2.zero(), 20.0, Vec2.new(250.0, 0.0))
	var thrown := ExactFrictionBounce.new(hits, Vec2.new(60.0, -80.0), 1.0, 0.2)
	assert_eq(thrown.error_of_other(Vec2.new(175.0, 100.0)), 0.0)
	assert_eq(thrown.error_of_other_spin(2.5), 0.0)


func test_doubles_are_off_by_a_few_last_digits() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 7
	for number: int in _BOUNCES:
		var along := Vec2.unit_radians(rng.randf() * TAU).scaled(rng.randf_range(0.1, 90.0))
		var tangent := along.normalized()
		var normal := Vec2.new(tangent.y, -tangent.x)
		var velocity := tangent.scaled(rng.randf_range(-400.0, 400.0))
		velocity.add(normal.scaled(rng.randf_range(-500.0, -1.0)))
		var ball := Ball.new(Vec2.zero(), rng.randf_range(1.0, 50.0), velocity, 1.0, rng.randfn())
		var bounciness := rng.randf()
		var friction := rng.randf_range(0.0, 0.7)
		var exact := ExactFrictionBounce.new(ball, along, bounciness, friction)
		var one := ball.copy()
		FrictionBounce.bounce(one, normal, bounciness, friction)
		assert_lt(exact.error_of(one.velocity), 3e-12)
		assert_lt(absf(exact.error_of_spin(one.spin)) * ball.radius, 3e-12)
		var first := ball.copy()
		var second := Ball.new(Vec2.zero(), ball.radius)
		BallFrictionBounce.bounce(first, second, normal, bounciness, friction)
		assert_lt(exact.error_of_other(second.velocity), 3e-12)
		assert_lt(absf(exact.error_of_other_spin(second.spin)) * ball.radius, 3e-12)
