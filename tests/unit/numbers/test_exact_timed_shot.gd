extends LabTest
## The exact moment to fire at a target on a line.


func test_whole_numbers_are_exact() -> void:
	var exact := _exact(Vec2.new(0, -200), Vec2.new(100, 0))
	assert_eq(exact.error_of_fire(2.0), 0.0)
	assert_eq(exact.error_of_flight(1.0), 0.0)


func test_a_moment_that_is_off_is_off_by_so_much() -> void:
	var exact := _exact(Vec2.new(0, -200), Vec2.new(100, 0))
	assert_eq(exact.error_of_fire(2.0 + 2.0 ** -40), 2.0 ** -40)
	assert_eq(exact.error_of_flight(1.0 - 2.0 ** -40), -(2.0 ** -40))


func test_a_third_is_no_double() -> void:
	# P × v = 300 · 100, W × v = 300 · 300: f is 1/3.
	var exact := ExactTimedShot.new(
		Vec2.new(0, 100), Vec2.new(0, -300), Vec2.new(-300, 0), Vec2.new(300, 0)
	)
	assert_between(absf(exact.error_of_flight(1.0 / 3.0)), 1e-18, 6e-17)


func test_parallel_ways_are_an_error() -> void:
	_exact(Vec2.new(0, -200), Vec2.new(0, 100))
	assert_push_error("are parallel")


func _exact(bullet: Vec2, velocity: Vec2) -> ExactTimedShot:
	return ExactTimedShot.new(Vec2.new(0, 100), bullet, Vec2.new(-300, -100), velocity)
