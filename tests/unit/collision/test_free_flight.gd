extends LabTest
## How a ball moves between two bounces, and which gravity can be used.

const _GRAVITY := 10.0


func test_a_ball_falls_by_half_g_t_squared() -> void:
	var motion := FreeFlight.motion(Vec2.new(3, -4), Vec2.new(0, _GRAVITY), 2.0)
	assert_vec2(motion, Vec2.new(6, 12), 0.0)
	var velocity := FreeFlight.velocity_after(Vec2.new(3, -4), Vec2.new(0, _GRAVITY), 2.0)
	assert_vec2(velocity, Vec2.new(3, 16), 0.0)


func test_the_velocity_along_gravity_follows_from_the_height() -> void:
	var velocity := FreeFlight.velocity_at(
		Vec2.new(3, -4), Vec2.new(0, _GRAVITY), Vec2.new(6, 12), 2.0
	)
	assert_vec2(velocity, Vec2.new(3, 16), 1e-12)


func test_the_time_to_fall_solves_the_equation_of_the_fall() -> void:
	for speed: float in [-4.0, 0.0, 4.0]:
		var seconds := FreeFlight.time_to_fall(100.0, speed, -_GRAVITY)
		var height := 100.0 + speed * seconds - _GRAVITY * seconds * seconds / 2.0
		assert_almost_eq(height, 0.0, 1e-12, "speed %s" % speed)


func test_what_is_not_pulled_down_and_rises_never_falls() -> void:
	assert_eq(FreeFlight.time_to_fall(100.0, 4.0, 0.0), INF)


func test_gravity_may_reach_the_limit() -> void:
	assert_eq(FreeFlight.problem_of_gravity(Vec2.new(5, -5), 5.0), "")


func test_gravity_beyond_the_limit_is_named_with_the_limit() -> void:
	assert_eq(
		FreeFlight.problem_of_gravity(Vec2.new(0, -6), 5.0),
		"Gravity must be within -5..5 px/s² in x and y, not (0, -6)."
	)
	assert_ne(FreeFlight.problem_of_gravity(Vec2.new(NAN, 0), 5.0), "")


func test_a_ball_that_flies_off_a_circle_uphill_is_on_it_again() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 4
	var found := 0
	for i: int in 1000:
		var angle := rng.randf_range(-PI, PI)
		var from := Vec2.unit_radians(angle).scaled(10.0)
		var velocity := Vec2.unit_radians(angle + PI / 2.0).scaled(rng.randf_range(-90.0, 90.0))
		var seconds := FreeFlight.time_back_to_circle(
			from.x, from.y, velocity.x, velocity.y, 0, 300
		)
		if seconds < INF and seconds > 0.0:
			found += 1
			var at := from.plus(FreeFlight.motion(velocity, Vec2.new(0, 300), seconds))
			assert_almost_eq(at.length(), 10.0, 1e-9)
			var half := FreeFlight.motion(velocity, Vec2.new(0, 300), 0.5 * seconds)
			assert_gt(from.plus(half).length(), 10.0, "it is outside until then")
			assert_lt(velocity.y, 0.0, "it climbs")
	assert_gt(found, 20)
