extends LabTest
## A round thing that moves.


func test_a_ball_is_at_rest_and_has_mass_1_unless_told_otherwise() -> void:
	var ball := Ball.new(Vec2.new(3, 4), 10.0)
	assert_vec2(ball.velocity, Vec2.zero(), 0.0)
	assert_eq(ball.spin, 0.0)
	assert_eq(ball.mass, 1.0)


func test_a_ball_holds_what_it_was_given() -> void:
	var ball := Ball.new(Vec2.new(3, 4), 10.0, Vec2.new(5, 6), 2.0, 7.0)
	assert_vec2(ball.position, Vec2.new(3, 4), 0.0)
	assert_vec2(ball.velocity, Vec2.new(5, 6), 0.0)
	assert_eq(ball.radius, 10.0)
	assert_eq(ball.mass, 2.0)
	assert_eq(ball.spin, 7.0)


func test_it_shares_nothing_with_what_it_was_made_of() -> void:
	var position := Vec2.new(3, 4)
	var velocity := Vec2.new(5, 6)
	var ball := Ball.new(position, 10.0, velocity)
	position.x = 99.0
	velocity.x = 99.0
	assert_vec2(ball.position, Vec2.new(3, 4), 0.0)
	assert_vec2(ball.velocity, Vec2.new(5, 6), 0.0)


func test_two_balls_at_rest_do_not_share_their_velocity() -> void:
	var one := Ball.new(Vec2.zero(), 10.0)
	var other := Ball.new(Vec2.zero(), 10.0)
	one.velocity.x = 99.0
	assert_vec2(other.velocity, Vec2.zero(), 0.0)


func test_a_copy_shares_nothing() -> void:
	var ball := Ball.new(Vec2.new(3, 4), 10.0, Vec2.new(5, 6), 2.0, 7.0)
	var copy := ball.copy()
	copy.position.x = 99.0
	copy.velocity.x = 99.0
	assert_vec2(ball.position, Vec2.new(3, 4), 0.0)
	assert_vec2(ball.velocity, Vec2.new(5, 6), 0.0)
	assert_eq(copy.radius, 10.0)
	assert_eq(copy.mass, 2.0)
	assert_eq(copy.spin, 7.0)


func test_a_good_ball_has_no_problem() -> void:
	assert_eq(Ball.new(Vec2.zero(), 1e-300).problem(), "")


func test_a_radius_that_cannot_be_is_named() -> void:
	assert_string_contains(Ball.new(Vec2.zero(), 0.0).problem(), "radius")
	assert_string_contains(Ball.new(Vec2.zero(), -3.0).problem(), "-3")
	assert_string_contains(Ball.new(Vec2.zero(), INF).problem(), "radius")
	assert_string_contains(Ball.new(Vec2.zero(), NAN).problem(), "radius")


func test_a_mass_that_cannot_be_is_named() -> void:
	assert_string_contains(Ball.new(Vec2.zero(), 1.0, Vec2.zero(), 0.0).problem(), "mass")
	assert_string_contains(Ball.new(Vec2.zero(), 1.0, Vec2.zero(), NAN).problem(), "mass")


func test_a_place_or_velocity_that_is_not_finite_is_named() -> void:
	assert_string_contains(Ball.new(Vec2.new(NAN, 0), 1.0).problem(), "finite")
	assert_string_contains(Ball.new(Vec2.zero(), 1.0, Vec2.new(0, INF)).problem(), "finite")


func test_a_spin_that_is_not_finite_is_named() -> void:
	for bad: float in [INF, NAN]:
		var ball := Ball.new(Vec2.zero(), 1.0, Vec2.zero(), 1.0, bad)
		assert_eq(ball.problem(), "A ball's spin must be finite, not %s rad/s." % bad)


func test_a_ball_may_reach_the_limit() -> void:
	assert_eq(Ball.new(Vec2.new(5, -5), 5.0, Vec2.new(-5, 5), 5.0).problem(5.0), "")


func test_a_number_beyond_the_limit_is_named_with_the_limit() -> void:
	var far := Vec2.new(0, -6)
	assert_eq(
		Ball.new(far, 1.0).problem(5.0),
		"A ball's position and velocity must be within -5..5, not (0, -6) and (0, 0)."
	)
	assert_string_contains(Ball.new(Vec2.zero(), 1.0, far).problem(5.0), "(0, -6)")
	assert_eq(
		Ball.new(Vec2.zero(), 6.0).problem(5.0),
		"A ball's radius and mass must be at most 5, not 6.0 and 1.0."
	)
	assert_string_contains(Ball.new(Vec2.zero(), 1.0, Vec2.zero(), 6.0).problem(5.0), "6.0")
	assert_eq(
		Ball.new(Vec2.zero(), 1.0, Vec2.zero(), 1.0, -6.0).problem(5.0),
		"A ball's spin must be within -5..5 rad/s, not -6.0."
	)
