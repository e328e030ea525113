extends LabTest
## The point of impact with an infinite line, part 13 of the lecture.

const RADIUS := 10.0

## Its normal is (0.6, -0.8), up and to the right.
var line := LineSegment.new(Vec2.new(60, 45), Vec2.new(-60, -45))


# Mistake 15: dividing a by the new distance gives -1.33.
func test_b_is_old_less_new() -> void:
	assert_eq(PointOfImpact.fraction(50, -30, 10), 0.5)


# Mistake 16: without its sign the distance 30 gives 2, which is right only in front of the line.
func test_distances_are_signed() -> void:
	assert_eq(PointOfImpact.fraction(50, -30, 10), 0.5)
	assert_eq(PointOfImpact.fraction(50, 30, 10), 2.0)


# Mistake 17: outside of 0..1 nothing is hit in this frame, and nothing is divided by b = 0.
func test_share_is_limited() -> void:
	var too_short := PointOfImpact.with_line(Vec2.new(6, -58), Vec2.new(0, 37.5), RADIUS, line)
	assert_false(too_short.hit)
	assert_eq(too_short.outcome, Impact.Outcome.TOO_FAR)
	var along := PointOfImpact.with_line(Vec2.new(-34, -88), Vec2.new(80, 60), RADIUS, line)
	assert_false(along.hit)
	assert_eq(along.outcome, Impact.Outcome.PARALLEL)


# Mistake 20: counted from the new position the time would be -0.5.
func test_time_is_from_old() -> void:
	assert_eq(PointOfImpact.fraction(8, -2, 3), 0.5)
	var wall := LineSegment.new(Vec2.new(0, 5), Vec2.new(0, 0))
	var impact := PointOfImpact.with_line(Vec2.new(8, 0), Vec2.new(-10, 0), 3.0, wall)
	assert_eq(impact.fraction, 0.5)
	assert_vec2(impact.position, Vec2.new(3, 0), 0.0)


func test_the_frame_of_the_lecture() -> void:
	var impact := PointOfImpact.with_line(Vec2.new(6, -58), Vec2.new(0, 100), RADIUS, line)
	assert_true(impact.hit)
	assert_almost_eq(impact.fraction, 0.5, 1e-15)
	assert_vec2(impact.position, Vec2.new(6, -8), 1e-13)
	assert_vec2(impact.normal, Vec2.new(0.6, -0.8), 1e-15)


func test_the_place_does_not_depend_on_the_speed() -> void:
	for speed: float in [10.0, 38.0, 72.0, 500.0, 1e6]:
		var old := Vec2.new(6, -8 - speed / 4.0)
		var impact := PointOfImpact.with_line(old, Vec2.new(0, speed), RADIUS, line)
		assert_almost_eq(impact.fraction, 0.25, 1e-13, "%s px per frame" % speed)
		assert_vec2(impact.position, Vec2.new(6, -8), 1e-15 * speed + 1e-13)


func test_the_ball_just_touches_at_the_point_of_impact() -> void:
	var errors := PackedFloat64Array()
	for old: Vec2 in _places_in_front(81):
		for motion: Vec2 in random_vectors(82, 20, 300.0):
			var impact := PointOfImpact.with_line(old, motion, RADIUS, line)
			if impact.hit:
				var new := old.plus(motion)
				errors.append(
					(
						ExactContact.distance_from(impact.position, old, new, RADIUS, line)
						* absf(motion.dot(impact.normal))
						/ motion.length()
					)
				)
	assert_gt(errors.size(), 100)
	assert_all_at_most(errors, 1e-12)


func test_it_hits_exactly_if_the_frame_ends_closer_than_the_radius() -> void:
	for old: Vec2 in _places_in_front(83):
		for motion: Vec2 in random_vectors(84, 20, 300.0):
			var impact := PointOfImpact.with_line(old, motion, RADIUS, line)
			var ends_too_close := line.normal().dot(old.plus(motion).minus(line.start)) < RADIUS
			assert_eq(impact.hit, ends_too_close, "%s by %s" % [old, motion])


func test_a_ball_that_moves_away_hits_nothing() -> void:
	var impact := PointOfImpact.with_line(Vec2.new(12, -16), Vec2.new(0, -50), RADIUS, line)
	assert_false(impact.hit)
	assert_eq(impact.outcome, Impact.Outcome.MOVING_AWAY)


# Mistake 14: a ball that overlaps and is on its way out has t = 0.25, and must not be stopped.
func test_a_ball_on_its_way_out_hits_nothing() -> void:
	var impact := PointOfImpact.with_line(Vec2.new(3, -4), Vec2.new(0, -25), RADIUS, line)
	assert_false(impact.hit)
	assert_eq(impact.outcome, Impact.Outcome.MOVING_AWAY)


func test_a_ball_that_overlaps_and_approaches_touches_at_once() -> void:
	var impact := PointOfImpact.with_line(Vec2.new(3, -4), Vec2.new(0, 25), RADIUS, line)
	assert_true(impact.hit)
	assert_eq(impact.fraction, 0.0)
	assert_vec2(impact.position, Vec2.new(3, -4), 0.0)


func test_a_contact_at_the_very_end_of_the_frame_counts() -> void:
	var floor_line := LineSegment.new(Vec2.new(5, 0), Vec2.new(0, 0))
	var impact := PointOfImpact.with_line(Vec2.new(0, -30), Vec2.new(7, 20), RADIUS, floor_line)
	assert_true(impact.hit)
	assert_eq(impact.fraction, 1.0)


func test_a_touching_ball_that_hardly_moves_touches_now() -> void:
	var floor_line := LineSegment.new(Vec2.new(5, 0), Vec2.new(0, 0))
	var impact := PointOfImpact.with_line(Vec2.new(0, -10), Vec2.new(0, 1e-20), 10.0, floor_line)
	assert_true(impact.hit)
	assert_eq(impact.fraction, 0.0)


# The motion is so small against the distance that the computed old - new is 3 steps of 2^-23, where
# 2.6 steps would be right.
func test_the_time_is_right_for_a_motion_that_is_small_against_the_distance() -> void:
	var floor_line := LineSegment.new(Vec2.new(5, 0), Vec2.new(0, 0))
	var gap := 2.0 ** 30 - (2.0 ** 30 - 1.0 / 2.0 ** 22)
	var motion := Vec2.new(0, 1.3 * gap)
	var impact := PointOfImpact.with_line(
		Vec2.new(0, -(2.0 ** 30)), motion, 2.0 ** 30 - gap, floor_line
	)
	assert_true(impact.hit)
	assert_almost_eq(impact.fraction, 1.0 / 1.3, 1e-15)


func test_a_ball_at_rest_hits_nothing() -> void:
	var impact := PointOfImpact.with_line(Vec2.new(3, -4), Vec2.zero(), RADIUS, line)
	assert_false(impact.hit)


func test_the_old_position_is_neither_changed_nor_shared() -> void:
	var old := Vec2.new(3, -4)
	var impact := PointOfImpact.with_line(old, Vec2.new(0, 25), RADIUS, line)
	impact.position.add(Vec2.new(1, 1))
	assert_vec2(old, Vec2.new(3, -4), 0.0)


# Places whose distance from the line is above the radius.
func _places_in_front(seed_number: int) -> Array[Vec2]:
	return random_vectors(seed_number, 60).filter(
		func(place: Vec2) -> bool: return place.minus(line.start).dot(line.normal()) > RADIUS
	)
