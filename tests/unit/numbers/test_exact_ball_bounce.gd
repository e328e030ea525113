extends LabTest
## The exact bounce of two balls, for readouts.


func test_an_exact_answer_has_no_error() -> void:
	var one := Ball.new(Vec2.new(), 1.0, Vec2.new(6.0, 0.0), 1.0)
	var two := Ball.new(Vec2.new(2.0, 0.0), 1.0, Vec2.new(), 2.0)
	var along := Vec2.new(3.0, 0.0)
	assert_eq(ExactBallBounce.error_of(Vec2.new(-2.0, 0.0), one, two, along, 1.0), 0.0)
	assert_eq(ExactBallBounce.error_of(Vec2.new(4.0, 0.0), two, one, along, 1.0), 0.0)
	assert_eq(ExactBallBounce.error_of(Vec2.new(-1.0, 0.0), one, two, along, 1.0), 1.0)


func test_the_bounce_in_doubles_is_off_by_rounding_alone() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 12
	var worst := 0.0
	for number: int in 200:
		var normal := Vec2.unit_radians(rng.randf() * TAU)
		var one := Ball.new(Vec2.new(), 1.0, normal.scaled(rng.randf() * 5.0), 1.0 + rng.randf())
		var two := Ball.new(normal.scaled(2.0), 1.0, Vec2.new(), 1.0 + rng.randf())
		var before := one.copy()
		BallBounce.apply(one, two, normal.negated(), 0.5)
		var error := ExactBallBounce.error_of(
			one.velocity, before, Ball.new(Vec2.new(), 1.0, Vec2.new(), two.mass), normal, 0.5
		)
		worst = maxf(worst, error)
	assert_between(worst, 1e-17, 4e-15)
