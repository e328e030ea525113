extends LabTest
## The distance of a ball from an infinite line, part 11 of the lecture.

## Its normal is (0.6, -0.8), up and to the right.
var line := LineSegment.new(Vec2.new(200, 150), Vec2.new(-200, -150))


func test_the_difference_vector_leads_from_the_line_to_the_point() -> void:
	assert_vec2(LineDistance.difference(Vec2.new(120, -35), line), Vec2.new(-80, -185), 0.0)


# Mistake 10: without dividing by the length of the line, this is 50000.
func test_the_normal_is_unit() -> void:
	assert_almost_eq(LineDistance.signed_distance(Vec2.new(120, -35), line), 100.0, 1e-12)


# Mistake 9: the normal is (y, -x) or (y, x) instead of (-y, x).
func test_the_good_side_is_kept() -> void:
	var floor_line := LineSegment.new(Vec2.new(5, 0), Vec2.new(0, 0))
	assert_eq(LineDistance.signed_distance(Vec2.new(2, -3), floor_line), 3.0)
	assert_eq(LineDistance.signed_distance(Vec2.new(2, 3), floor_line), -3.0)


# The distance straight up, as in part 2, is 125. With it a collision would be found too late.
func test_straight_up_is_longer() -> void:
	var point := Vec2.new(120, -35)
	var below := Vec2.new(120, 90)
	assert_almost_eq(LineDistance.signed_distance(below, line), 0.0, 1e-12)
	assert_lt(LineDistance.signed_distance(point, line), point.distance_to(below))


func test_any_point_of_the_line_will_do() -> void:
	for share: float in [-3.0, -0.5, 0.3, 1.0, 7.0]:
		var shift := line.along().scaled(share)
		var slid := LineSegment.new(line.start.plus(shift), line.end.plus(shift))
		for point: Vec2 in random_vectors(61, 50):
			var want := LineDistance.signed_distance(point, line)
			assert_almost_eq(LineDistance.signed_distance(point, slid), want, 1e-11)


func test_the_distance_is_length_times_sine_of_the_angle() -> void:
	for point: Vec2 in random_vectors(62, 200):
		var to_point := point.minus(line.start)
		var angle := to_point.angle_radians() - line.along().angle_radians()
		var want := to_point.length() * sin(angle)
		assert_almost_eq(LineDistance.signed_distance(point, line), want, 1e-11)


func test_the_distance_is_right_to_the_last_bits() -> void:
	var errors := PackedFloat64Array()
	var vectors := random_vectors(63, 900)
	for i: int in range(0, 900, 3):
		var random_line := LineSegment.new(vectors[i], vectors[i + 1])
		var distance := LineDistance.signed_distance(vectors[i + 2], random_line)
		var error := ExactLineDistance.error_of(distance, vectors[i + 2], random_line)
		errors.append(absf(error) / vectors[i].distance_to(vectors[i + 2]))
	assert_all_at_most(errors, 4.0 * EPSILON)


func test_a_line_read_backwards_has_its_good_side_on_the_other_side() -> void:
	var backwards := LineSegment.new(line.end, line.start)
	for point: Vec2 in random_vectors(64, 50):
		var want := -LineDistance.signed_distance(point, line)
		assert_almost_eq(LineDistance.signed_distance(point, backwards), want, 1e-11)


func test_the_distance_is_along_the_perpendicular() -> void:
	for distance: float in [-250.0, -1.0, 0.5, 80.0]:
		var point := Vec2.new(60, 45).plus(line.normal().scaled(distance))
		assert_almost_eq(LineDistance.signed_distance(point, line), distance, 1e-12)


func test_the_gap_is_the_distance_less_the_radius() -> void:
	assert_almost_eq(LineDistance.gap(Ball.new(Vec2.new(120, -35), 30), line), 70.0, 1e-12)
	assert_almost_eq(LineDistance.gap(Ball.new(Vec2.new(75, 25), 30), line), -5.0, 1e-12)


func test_a_ball_closer_than_its_radius_overlaps() -> void:
	var floor_line := LineSegment.new(Vec2.new(5, 0), Vec2.new(0, 0))
	assert_false(LineDistance.is_overlapping(Ball.new(Vec2.new(2, -10), 9.5), floor_line))
	assert_true(LineDistance.is_overlapping(Ball.new(Vec2.new(2, -10), 10.5), floor_line))


func test_a_ball_that_just_touches_does_not_overlap() -> void:
	var floor_line := LineSegment.new(Vec2.new(5, 0), Vec2.new(0, 0))
	assert_false(LineDistance.is_overlapping(Ball.new(Vec2.new(2, -10), 10), floor_line))


func test_a_ball_behind_the_line_counts_as_overlapping() -> void:
	assert_true(LineDistance.is_overlapping(Ball.new(Vec2.new(-300, 500), 1), line))


func test_the_line_has_no_ends() -> void:
	assert_almost_eq(LineDistance.gap(Ball.new(Vec2.new(263, 166), 30), line), -5.0, 1e-12)
