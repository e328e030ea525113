extends LabTest
## A straight line between two points.


func test_its_vector_goes_from_start_to_end() -> void:
	assert_vec2(_segment().along(), Vec2.new(30, 40), 0.0)
	assert_eq(_segment().length(), 50.0)


func test_the_normal_is_a_quarter_turn_clockwise_on_screen() -> void:
	assert_vec2(LineSegment.new(Vec2.zero(), Vec2.new(9, 0)).normal(), Vec2.new(0, 1), 0.0)
	assert_vec2(_segment().normal(), Vec2.new(-0.8, 0.6), 1e-15)


func test_the_normal_stays_when_the_line_is_moved() -> void:
	var moved := LineSegment.new(Vec2.new(1010, -480), Vec2.new(1040, -440))
	assert_vec2(moved.normal(), _segment().normal(), 0.0)


func test_a_turned_round_segment_has_the_opposite_normal() -> void:
	var segment := _segment()
	var turned := LineSegment.new(segment.end, segment.start)
	assert_vec2(turned.normal(), segment.normal().negated(), 0.0)


func test_the_share_is_0_at_the_start_and_1_at_the_end() -> void:
	var segment := _segment()
	assert_almost_eq(segment.share_of(segment.start), 0.0, 1e-15)
	assert_almost_eq(segment.share_of(segment.end), 1.0, 1e-15)


func test_the_share_goes_on_beyond_the_ends() -> void:
	var segment := LineSegment.new(Vec2.new(10, 0), Vec2.new(30, 0))
	assert_eq(segment.share_of(Vec2.new(0, 7)), -0.5)
	assert_eq(segment.share_of(Vec2.new(40, -7)), 1.5)


func test_the_closest_point_is_a_foot_or_an_end() -> void:
	var segment := LineSegment.new(Vec2.new(10, 0), Vec2.new(30, 0))
	assert_vec2(segment.closest_point(Vec2.new(15, 7)), Vec2.new(15, 0), 1e-14)
	assert_vec2(segment.closest_point(Vec2.new(0, 7)), Vec2.new(10, 0), 0.0)
	assert_vec2(segment.closest_point(Vec2.new(99, -7)), Vec2.new(30, 0), 0.0)


func test_no_other_point_of_the_segment_is_closer() -> void:
	var vectors := random_vectors(81, 300)
	var excesses := PackedFloat64Array()
	for index: int in range(0, vectors.size(), 3):
		var segment := LineSegment.new(vectors[index], vectors[index + 1])
		var point := vectors[index + 2]
		var least := INF
		for share: int in 201:
			var sample := segment.start.lerped(segment.end, share / 200.0)
			least = minf(least, point.distance_to(sample))
		excesses.append(point.distance_to(segment.closest_point(point)) - least)
	assert_all_at_most(excesses, 1e-12)


func test_a_segment_of_no_length_has_no_normal_and_one_closest_point() -> void:
	var dot := LineSegment.new(Vec2.new(3, 4), Vec2.new(3, 4))
	assert_vec2(dot.normal(), Vec2.zero(), 0.0)
	assert_eq(dot.share_of(Vec2.new(9, 9)), 0.0)
	assert_vec2(dot.closest_point(Vec2.new(9, 9)), Vec2.new(3, 4), 0.0)


func test_it_shares_nothing_with_what_it_was_made_of() -> void:
	var from := Vec2.new(10, 20)
	var to := Vec2.new(40, 60)
	var segment := LineSegment.new(from, to)
	from.x = 99.0
	to.x = 99.0
	assert_vec2(segment.start, Vec2.new(10, 20), 0.0)
	assert_vec2(segment.end, Vec2.new(40, 60), 0.0)


func test_a_copy_shares_nothing() -> void:
	var segment := _segment()
	var copy := segment.copy()
	copy.start.x = 99.0
	copy.end.y = 99.0
	assert_vec2(segment.start, Vec2.new(10, 20), 0.0)
	assert_vec2(segment.end, Vec2.new(40, 60), 0.0)


func test_a_good_segment_has_no_problem() -> void:
	assert_eq(_segment().problem(), "")


func test_a_segment_that_cannot_be_used_says_why() -> void:
	var dot := LineSegment.new(Vec2.new(3, 4), Vec2.new(3, 4))
	assert_string_contains(dot.problem(), "longer than 0")
	assert_string_contains(dot.problem(), "(3, 4)")
	var endless := LineSegment.new(Vec2.zero(), Vec2.new(INF, 0))
	assert_string_contains(endless.problem(), "finite")
	assert_string_contains(LineSegment.new(Vec2.new(NAN, 0), Vec2.zero()).problem(), "finite")


func test_a_segment_may_reach_the_limit() -> void:
	assert_eq(LineSegment.new(Vec2.new(5, -5), Vec2.new(-5, 5)).problem(5.0), "")


func test_an_end_beyond_the_limit_is_named_with_the_limit() -> void:
	var near := Vec2.new(1, 2)
	var far := Vec2.new(0, -6)
	var text := "A segment's ends must be within -5..5 px, not %s and %s."
	assert_eq(LineSegment.new(far, near).problem(5.0), text % [far, near])
	assert_eq(LineSegment.new(near, far).problem(5.0), text % [near, far])


static func _segment() -> LineSegment:
	return LineSegment.new(Vec2.new(10, 20), Vec2.new(40, 60))


func test_the_distance_of_two_segments() -> void:
	var level := LineSegment.new(Vec2.new(0, 0), Vec2.new(10, 0))
	var others: Dictionary[LineSegment, float] = {
		LineSegment.new(Vec2.new(5, -5), Vec2.new(5, 5)): 0.0,
		LineSegment.new(Vec2.new(5, 3), Vec2.new(5, 9)): 3.0,
		LineSegment.new(Vec2.new(13, 4), Vec2.new(20, 9)): 5.0,
		LineSegment.new(Vec2.new(-5, 2), Vec2.new(20, 2)): 2.0,
		LineSegment.new(Vec2.new(5, 0), Vec2.new(20, 0)): 0.0,
		LineSegment.new(Vec2.new(12, 0), Vec2.new(20, 0)): 2.0,
	}
	for other in others:
		assert_almost_eq(level.distance_to(other), others[other], 1e-15)
		assert_almost_eq(other.distance_to(level), others[other], 1e-15)
