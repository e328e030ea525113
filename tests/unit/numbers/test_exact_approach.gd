extends LabTest
## How near a bullet comes to its target, to about 100 bits.


func test_a_straight_way_passes_at_the_distance_of_a_line() -> void:
	var place := Vec2.new(-240, 0)
	var velocity := Vec2.new(150, -90)
	var approach := _straight(place, velocity)
	var line := LineSegment.new(place, place.plus(velocity))
	var wanted := ExactLineDistance.signed_distance(Vec2.zero(), line)
	assert_eq(approach.least_distance(10.0, 0.0), absf(wanted.to_float()))


func test_what_hits_exactly_misses_by_nothing() -> void:
	assert_eq(_straight(Vec2.new(-240, -180), Vec2.new(120, 90)).least_distance(5.0, 2.0), 0.0)


func test_a_miss_of_one_last_place_is_seen() -> void:
	var place := Vec2.new(-240, -180.0 * (1.0 + EPSILON))
	var miss := _straight(place, Vec2.new(120, 90)).least_distance(5.0, 2.0)
	# Seen along the way, whose direction is (0.8, 0.6).
	assert_almost_eq(miss / (last_place(180.0) * 0.8), 1.0, 1e-9)


func test_what_flies_away_is_nearest_at_the_start_and_what_comes_late_at_the_end() -> void:
	assert_eq(_straight(Vec2.new(3, 4), Vec2.new(3, 4)).least_distance(5.0, 1.0), 5.0)
	assert_eq(_straight(Vec2.new(100, 0), Vec2.new(-10, 0)).least_distance(5.0, 1.0), 50.0)


func test_a_parabola_hits_the_slide_s_target() -> void:
	# Seen from the target: 200 px to the left, shot at (200, -150), gravity 300.
	var start := ExactVector.from_vec2(Vec2.new(-200, 0))
	var velocity := ExactVector.from_vec2(Vec2.new(200, -150))
	var approach := ExactApproach.new(start, velocity, Vec2.new(0, 300))
	assert_eq(approach.least_distance(3.0, 1.0), 0.0)


func test_the_nearest_of_two_passes_counts_without_a_guess() -> void:
	# Up past the target at a distance, and down nearer to it.
	var start := ExactVector.from_vec2(Vec2.new(-40, 0))
	var velocity := ExactVector.from_vec2(Vec2.new(20, -300))
	var approach := ExactApproach.new(start, velocity, Vec2.new(0, 300))
	assert_almost_eq(approach.least_distance(3.0, 0.0), 0.0, 1e-12)


func test_a_target_on_a_circle_is_met() -> void:
	# The bullet comes to (0, -100) after half a second, and so does the target.
	var start := ExactVector.from_vec2(Vec2.new(0, -200))
	var approach := ExactApproach.new(start, ExactVector.from_vec2(Vec2.new(0, 200)))
	approach.set_circle(100.0, DoubleDouble.from_float(0.0), -PI)
	# -PI is a double: a quarter of a turn is missed by 100 px times what PI lacks.
	assert_almost_eq(approach.least_distance(2.0, 0.5), 0.0, 1e-14)
	approach.set_circle(100.0, DoubleDouble.from_float(0.01), -PI)
	# The target is 1 px too far on its way, across that of the bullet.
	var miss := 200.0 / Vec2.new(200.0, 100.0 * PI).length()
	assert_almost_eq(approach.least_distance(2.0, 0.5), miss, 1e-2)


func _straight(place: Vec2, velocity: Vec2) -> ExactApproach:
	return ExactApproach.new(ExactVector.from_vec2(place), ExactVector.from_vec2(velocity))
