extends LabTest
## Points on the way from one position to another.


func test_half_way_is_in_the_middle() -> void:
	assert_vec2(Vec2.new(2, -4).lerped(Vec2.new(6, 4), 0.5), Vec2.new(4, 0), 0.0)


func test_a_quarter_and_three_quarters_of_the_way() -> void:
	assert_vec2(Vec2.new(2, -4).lerped(Vec2.new(6, 4), 0.25), Vec2.new(3, -2), 0.0)
	assert_vec2(Vec2.new(2, -4).lerped(Vec2.new(6, 4), 0.75), Vec2.new(5, 2), 0.0)


func test_both_ends_are_exact() -> void:
	var vectors := random_vectors(81, 200)
	for index: int in range(0, 200, 2):
		var from := vectors[index].scaled(1e-7)
		var to := vectors[index + 1]
		assert_vec2(from.lerped(to, 0.0), from, 0.0)
		assert_vec2(from.lerped(to, 1.0), to, 0.0)


func test_near_the_far_end_no_digit_is_lost_to_the_long_way() -> void:
	# The way is 1e16 long, where doubles are 2 apart; what is left of it is 0.5 * EPSILON * 1e16.
	var got := Vec2.new(-1e16, 1e16).lerped(Vec2.new(0.1, -0.1), 1.0 - 0.5 * EPSILON)
	var left := 0.5 * EPSILON * 1e16
	assert_vec2(got, Vec2.new(0.1 - left, left - 0.1), 1e-15)


func test_weights_outside_0_to_1_go_on_along_the_line() -> void:
	assert_vec2(Vec2.new(2, -4).lerped(Vec2.new(6, 4), -1), Vec2.new(-2, -12), 0.0)
	assert_vec2(Vec2.new(2, -4).lerped(Vec2.new(6, 4), 2), Vec2.new(10, 12), 0.0)


func test_between_equal_positions_nothing_moves() -> void:
	var position := Vec2.new(0.1, 1.0 / 3.0)
	for step: int in 11:
		assert_vec2(position.lerped(position, step / 10.0), position, 0.0)


func test_moving_toward_covers_the_distance() -> void:
	assert_vec2(Vec2.new(1, 1).moved_toward(Vec2.new(7, 9), 5), Vec2.new(4, 5), 1e-15)
	assert_vec2(Vec2.new(1, 1).moved_toward(Vec2.new(7, 9), 0), Vec2.new(1, 1), 0.0)


func test_moving_toward_stops_at_the_target() -> void:
	for distance: float in [10.0, 10.5, 1e300, INF]:
		var moved := Vec2.new(1, 1).moved_toward(Vec2.new(7, 9), distance)
		assert_vec2(moved, Vec2.new(7, 9), 0.0)


func test_moving_toward_never_passes_the_target() -> void:
	var passed := 0
	var vectors := random_vectors(82, 400)
	for index: int in range(0, 400, 2):
		var from := vectors[index].scaled(1e8)
		var to := vectors[index + 1].scaled(1e-8)
		var almost := from.distance_to(to) * (1.0 - EPSILON)
		var moved := from.moved_toward(to, almost)
		if (moved.x - to.x) * (from.x - to.x) < 0.0 or (moved.y - to.y) * (from.y - to.y) < 0.0:
			passed += 1
	assert_eq(passed, 0)


func test_moving_toward_where_one_already_is() -> void:
	assert_vec2(Vec2.new(3, 4).moved_toward(Vec2.new(3, 4), 1), Vec2.new(3, 4), 0.0)
	assert_vec2(Vec2.new(3, 4).moved_toward(Vec2.new(3, 4), 0), Vec2.new(3, 4), 0.0)


func test_a_negative_distance_is_refused_and_gives_a_copy() -> void:
	for wrong: float in [-1.0, NAN]:
		assert_vec2(Vec2.new(1, 1).moved_toward(Vec2.new(7, 9), wrong), Vec2.new(1, 1), 0.0)
		assert_push_error("distance must be 0 or more, but is %s." % wrong)
