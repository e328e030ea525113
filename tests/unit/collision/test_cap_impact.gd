extends LabTest
## The impact of a ball with the round end of a line, by the quadratic.

const END := Impact.Feature.END


func test_the_worked_example_touches_after_half_a_frame() -> void:
	var impact := _impact(Vec2.new(-8, 0), Vec2.new(10, 0), 3.0)
	assert_true(impact.hit)
	assert_eq(impact.fraction, 0.5)
	assert_vec2(impact.position, Vec2.new(-3, 0), 0.0)


func test_the_normal_points_from_the_end_to_the_ball() -> void:
	var impact := _impact(Vec2.new(-7, -11), Vec2.new(6, 16), 5.0)
	assert_eq(impact.fraction, 0.5)
	assert_vec2(impact.position, Vec2.new(-4, -3), 1e-15)
	assert_vec2(impact.normal, Vec2.new(-0.8, -0.6), 1e-15)


func test_the_end_may_be_anywhere() -> void:
	var cap := Vec2.new(300, -200)
	var moved := CapImpact.with_point(
		cap.plus(Vec2.new(-7, -11)), Vec2.new(6, 16), 5.0, cap, Impact.Feature.START
	)
	assert_eq(moved.fraction, 0.5)
	assert_eq(moved.feature, Impact.Feature.START)


func test_the_discriminant_is_rooted_not_squared() -> void:
	# a = 100, b = -160, c = 55 and D = 3600. With D squared the time would be -64799.
	var fraction := _impact(Vec2.new(-8, 0), Vec2.new(10, 0), 3.0).fraction
	assert_almost_eq(100.0 * fraction * fraction - 160.0 * fraction + 55.0, 0.0, 1e-12)
	assert_between(fraction, 0.0, 1.0)


func test_a_ball_at_rest_has_no_time_of_impact() -> void:
	var impact := _impact(Vec2.new(-8, 0), Vec2.zero(), 3.0)
	assert_false(impact.hit)
	assert_eq(impact.outcome, Impact.Outcome.MOVING_AWAY)


func test_a_near_miss_has_no_time_and_no_normal() -> void:
	var impact := _impact(Vec2.new(-8, 4), Vec2.new(10, 0), 3.0)
	assert_false(impact.hit)
	assert_eq(impact.outcome, Impact.Outcome.PASSES_BESIDE)
	assert_null(impact.normal)


func test_grazing_is_no_impact() -> void:
	var impact := _impact(Vec2.new(-8, 3), Vec2.new(10, 0), 3.0)
	assert_false(impact.hit)
	assert_eq(impact.outcome, Impact.Outcome.PASSES_BESIDE)


func test_the_time_counts_from_the_old_position() -> void:
	# Counted from the new position it would be -0.5.
	var old := Vec2.new(-8, 0)
	var motion := Vec2.new(10, 0)
	var impact := _impact(old, motion, 3.0)
	assert_vec2(impact.position, old.plus(motion.scaled(impact.fraction)), 0.0)
	assert_almost_eq(impact.position.length(), 3.0, 1e-15)


func test_an_end_beyond_the_frame_is_not_reached() -> void:
	var impact := _impact(Vec2.new(-14, 0), Vec2.new(10, 0), 3.0)
	assert_false(impact.hit)
	assert_eq(impact.outcome, Impact.Outcome.TOO_FAR)


func test_an_end_touched_at_the_end_of_the_frame_counts() -> void:
	assert_eq(_impact(Vec2.new(-13, 0), Vec2.new(10, 0), 3.0).fraction, 1.0)


func test_a_ball_that_moves_away_is_left_alone() -> void:
	assert_false(_impact(Vec2.new(8, 0), Vec2.new(10, 0), 3.0).hit)
	assert_false(_impact(Vec2.new(2, 0), Vec2.new(10, 0), 3.0).hit)


func test_a_ball_that_overlaps_and_approaches_touches_at_once() -> void:
	var impact := _impact(Vec2.new(-2, 0), Vec2.new(10, 0), 3.0)
	assert_eq(impact.fraction, 0.0)
	assert_vec2(impact.position, Vec2.new(-2, 0), 0.0)
	assert_vec2(impact.normal, Vec2.new(-1, 0), 0.0)


func test_a_ball_just_off_the_end_does_not_touch_at_once() -> void:
	assert_almost_eq(_impact(Vec2.new(-3.125, 0), Vec2.new(10, 0), 3.0).fraction, 0.0125, 1e-15)


func test_a_slow_ball_touches_as_a_fast_one_does() -> void:
	var impact := _impact(Vec2.new(-3.0 - 1.0 / 64.0, 0), Vec2.new(1.0 / 32.0, 0), 3.0)
	assert_true(impact.hit)
	assert_almost_eq(impact.fraction, 0.5, 1e-12)


func test_a_ball_whose_centre_is_on_the_end_is_left_alone() -> void:
	assert_false(_impact(Vec2.zero(), Vec2.new(10, 0), 3.0).hit)


func test_neither_the_old_position_nor_the_motion_is_changed() -> void:
	var old := Vec2.new(-2, 0)
	var motion := Vec2.new(10, 0)
	var impact := _impact(old, motion, 3.0)
	impact.position.x = 99.0
	assert_vec2(old, Vec2.new(-2, 0), 0.0)
	assert_vec2(motion, Vec2.new(10, 0), 0.0)


func test_random_impacts_are_where_the_distance_is_the_radius() -> void:
	var distances := PackedFloat64Array()
	var lengths := PackedFloat64Array()
	for impact: Impact in _random_impacts(51):
		if impact.hit and impact.fraction > 0.0:
			distances.append(absf(impact.position.length() - 20.0))
			lengths.append(absf(impact.normal.length() - 1.0))
	assert_gt(distances.size(), 100, "enough hits to mean something")
	assert_all_at_most(distances, 1e-11)
	assert_all_at_most(lengths, 4.0 * EPSILON)


func test_random_impacts_agree_with_the_angle_between_motion_and_end() -> void:
	# Independent of the quadratic: sine and cosine of the angle at the ball's centre.
	var errors := PackedFloat64Array()
	var vectors := random_vectors(52, 2000)
	for index: int in range(0, vectors.size(), 2):
		var old := vectors[index]
		var motion := vectors[index + 1].scaled(3.0)
		var want := _time_by_trigonometry(old, motion, 20.0)
		var got := _impact(old, motion, 20.0)
		if got.hit != (want >= 0.0 and want <= 1.0):
			fail_test("hit is %s, but the fraction is %s from %s" % [got.hit, want, old])
		elif got.hit:
			errors.append(absf(got.fraction - want))
	assert_all_at_most(errors, 1e-11)


static func _impact(old: Vec2, motion: Vec2, radius: float) -> Impact:
	return CapImpact.with_point(old, motion, radius, Vec2.zero(), END)


static func _random_impacts(seed_number: int) -> Array[Impact]:
	var found: Array[Impact] = []
	var vectors := random_vectors(seed_number, 3000)
	for index: int in range(0, vectors.size(), 2):
		found.append(_impact(vectors[index], vectors[index + 1].scaled(3.0), 20.0))
	return found


# The distance to the foot of the perpendicular, less the other leg of the right triangle whose
# hypotenuse is the radius. -1 for a miss, 0 for a ball that overlaps and approaches.
static func _time_by_trigonometry(old: Vec2, motion: Vec2, radius: float) -> float:
	var angle := old.negated().angle_to(motion)
	var ahead := old.length() * cos(angle)
	var beside := old.length() * sin(angle)
	if ahead <= 0.0 or absf(beside) >= radius:
		return -1.0
	if old.length() <= radius:
		return 0.0
	return (ahead - sqrt(radius * radius - beside * beside)) / motion.length()
