extends LabTest
## The impact of a ball with a segment that has round caps and two sides.

const RADIUS := 10.0


func test_a_ball_bounces_on_the_line_between_its_ends() -> void:
	var impact := _with_floor(Vec2.new(0, -50), Vec2.new(0, 80))
	assert_true(impact.hit)
	assert_eq(impact.fraction, 0.5)
	assert_vec2(impact.normal, Vec2.new(0, -1), 0.0)
	assert_eq(impact.feature, Impact.Feature.LINE)


func test_both_sides_work() -> void:
	var from_below := _with_floor(Vec2.new(0, 50), Vec2.new(0, -80))
	assert_eq(from_below.fraction, 0.5)
	assert_vec2(from_below.normal, Vec2.new(0, 1), 0.0)


func test_a_turned_round_segment_gives_the_same() -> void:
	var there := _with_floor(Vec2.new(0, -50), Vec2.new(20, 80))
	var turned := LineSegment.new(Vec2.new(100, 0), Vec2.new(-100, 0))
	var back := SegmentImpact.with_segment(Vec2.new(0, -50), Vec2.new(20, 80), RADIUS, turned)
	assert_eq(back.fraction, there.fraction)
	assert_vec2(back.normal, there.normal, 0.0)


func test_a_ball_bounces_on_each_end() -> void:
	var left := _with_floor(Vec2.new(-106, -28), Vec2.new(0, 40))
	assert_eq(left.feature, Impact.Feature.START)
	assert_almost_eq(left.fraction, 0.5, 1e-15)
	assert_vec2(left.normal, Vec2.new(-0.6, -0.8), 1e-15)
	var right := _with_floor(Vec2.new(106, -28), Vec2.new(0, 40))
	assert_eq(right.feature, Impact.Feature.END)
	assert_vec2(right.normal, Vec2.new(0.6, -0.8), 1e-15)


func test_a_ball_that_runs_along_the_line_bounces_on_its_end() -> void:
	var impact := _with_floor(Vec2.new(-150, 0), Vec2.new(80, 0))
	assert_eq(impact.feature, Impact.Feature.START)
	assert_eq(impact.fraction, 0.5)
	assert_vec2(impact.normal, Vec2.new(-1, 0), 0.0)


func test_the_nearer_of_two_ends_is_met() -> void:
	var impact := _with_floor(Vec2.new(150, 0), Vec2.new(-400, 0))
	assert_eq(impact.feature, Impact.Feature.END)
	assert_eq(impact.fraction, 0.1)


func test_the_start_is_met_before_an_end_farther_on() -> void:
	var impact := _with_floor(Vec2.new(-150, 0), Vec2.new(400, 0))
	assert_eq(impact.feature, Impact.Feature.START)
	assert_eq(impact.fraction, 0.1)


func test_of_two_ends_touched_at_once_the_start_counts() -> void:
	var short := LineSegment.new(Vec2.new(-6, 0), Vec2.new(6, 0))
	var impact := SegmentImpact.with_caps(Vec2.new(0, -48), Vec2.new(0, 80), RADIUS, short)
	assert_eq(impact.fraction, 0.5)
	assert_eq(impact.feature, Impact.Feature.START)


func test_the_ends_belong_to_the_line() -> void:
	assert_true(SegmentImpact.is_beside_line(Vec2.new(-100, -7), _floor()))
	assert_true(SegmentImpact.is_beside_line(Vec2.new(100, 7), _floor()))
	assert_false(SegmentImpact.is_beside_line(Vec2.new(-100.001, -7), _floor()))
	assert_false(SegmentImpact.is_beside_line(Vec2.new(100.001, 7), _floor()))


func test_a_segment_faces_even_a_point_close_to_it() -> void:
	var below := SegmentImpact.facing_segment(Vec2.new(30, 0.25), _floor())
	assert_vec2(below.start, Vec2.new(-100, 0), 0.0)
	var above := SegmentImpact.facing_segment(Vec2.new(30, -0.25), _floor())
	assert_vec2(above.start, Vec2.new(100, 0), 0.0)


func test_a_segment_is_not_turned_for_a_point_on_it() -> void:
	var facing := SegmentImpact.facing_segment(Vec2.new(30, 0), _floor())
	assert_vec2(facing.start, Vec2.new(-100, 0), 0.0)


func test_an_infinite_line_is_not_a_segment() -> void:
	assert_false(_with_floor(Vec2.new(130, -50), Vec2.new(0, 80)).hit)


func test_without_caps_a_ball_passes_beside_an_end() -> void:
	var flat := SegmentImpact.with_line_part(Vec2.new(106, -28), Vec2.new(0, 40), RADIUS, _floor())
	assert_false(flat.hit)
	assert_eq(flat.outcome, Impact.Outcome.PASSES_BESIDE)


func test_the_end_is_tested_at_the_impact_not_after_the_frame() -> void:
	# It touches beside the end, and is above the line only after the frame.
	var onto_cap := _with_floor(Vec2.new(-145, -50), Vec2.new(80, 80))
	assert_eq(onto_cap.feature, Impact.Feature.START)
	# It touches the line, and is beside the end only after the frame.
	var onto_line := _with_floor(Vec2.new(70, -50), Vec2.new(50, 80))
	assert_eq(onto_line.feature, Impact.Feature.LINE)
	assert_eq(onto_line.fraction, 0.5)


func test_a_ball_that_moves_away_does_not_bounce() -> void:
	var impact := _with_floor(Vec2.new(0, -5), Vec2.new(0, -80))
	assert_false(impact.hit)
	assert_eq(impact.outcome, Impact.Outcome.MOVING_AWAY)


func test_a_ball_that_rolls_along_the_line_does_not_bounce_on_its_end() -> void:
	assert_false(_with_floor(Vec2.new(0, -10), Vec2.new(400, 0)).hit)


func test_a_sunk_ball_that_moves_away_does_not_bounce_on_the_end_inside() -> void:
	# The nearest point is on the line all the way; the end is never what it touches.
	assert_false(_with_floor(Vec2.new(0, -5), Vec2.new(200, -0.1)).hit)


func test_a_sunk_ball_that_leaves_may_cross_the_circle_of_the_other_end() -> void:
	var short := LineSegment.new(Vec2.zero(), Vec2.new(16, 0))
	var impact := SegmentImpact.with_segment(Vec2.new(-1, -5), Vec2.new(100, -25), RADIUS, short)
	assert_false(impact.hit)
	assert_eq(impact.outcome, Impact.Outcome.MOVING_AWAY)


func test_a_ball_sunk_into_both_ends_is_turned_back_by_the_nearer_one() -> void:
	var short := LineSegment.new(Vec2.zero(), Vec2.new(2, 0))
	var impact := SegmentImpact.with_segment(Vec2.new(5, -4), Vec2.new(-10, 0), RADIUS, short)
	assert_eq(impact.fraction, 0.0)
	assert_eq(impact.feature, Impact.Feature.END)
	assert_vec2(impact.normal, Vec2.new(0.6, -0.8), 1e-15)


func test_a_ball_sunk_into_one_end_touches_that_end() -> void:
	var at_start := _with_floor(Vec2.new(-104, -3), Vec2.new(80, 0))
	assert_eq(at_start.feature, Impact.Feature.START)
	assert_vec2(at_start.normal, Vec2.new(-0.8, -0.6), 1e-15)
	var at_end := _with_floor(Vec2.new(104, -3), Vec2.new(-80, 0))
	assert_eq(at_end.feature, Impact.Feature.END)
	assert_vec2(at_end.normal, Vec2.new(0.8, -0.6), 1e-15)


func test_a_sunk_ball_that_approaches_is_turned_back_at_once() -> void:
	var impact := _with_floor(Vec2.new(0, -5), Vec2.new(0, 80))
	assert_eq(impact.fraction, 0.0)
	assert_vec2(impact.normal, Vec2.new(0, -1), 0.0)


func test_a_fast_ball_does_not_tunnel() -> void:
	var impact := _with_floor(Vec2.new(0, -50), Vec2.new(0, 1e9))
	assert_true(impact.hit)
	assert_almost_eq(impact.position.y, -RADIUS, 1e-6)


func test_a_segment_of_no_length_is_a_round_point() -> void:
	var point := LineSegment.new(Vec2.zero(), Vec2.zero())
	var impact := SegmentImpact.with_segment(Vec2.new(-50, 0), Vec2.new(80, 0), RADIUS, point)
	assert_true(impact.hit)
	assert_eq(impact.fraction, 0.5)


func test_random_impacts_agree_with_a_dense_sampling_of_the_distance() -> void:
	var hits := 0
	var problems := PackedStringArray()
	var vectors := random_vectors(61, 3000)
	for index: int in range(0, vectors.size(), 4):
		var segment := LineSegment.new(vectors[index], vectors[index + 1])
		var old := vectors[index + 2].scaled(1.5)
		var motion := vectors[index + 3].scaled(2.0)
		if _distance(old, segment) <= RADIUS:
			continue
		var impact := SegmentImpact.with_segment(old, motion, RADIUS, segment)
		hits += 1 if impact.hit else 0
		var problem := _difference_from_sampling(impact, old, motion, segment)
		if problem:
			problems.append(problem)
	assert_gt(hits, 60, "enough hits to mean something")
	assert_eq(problems, PackedStringArray())


func test_random_impacts_are_approaching_contacts_at_the_radius() -> void:
	var distances := PackedFloat64Array()
	var approaches := PackedFloat64Array()
	var vectors := random_vectors(62, 3000)
	for index: int in range(0, vectors.size(), 4):
		var segment := LineSegment.new(vectors[index], vectors[index + 1])
		var old := vectors[index + 2].scaled(1.5)
		var motion := vectors[index + 3].scaled(2.0)
		var impact := SegmentImpact.with_segment(old, motion, RADIUS, segment)
		if impact.hit:
			approaches.append(motion.dot(impact.normal))
		if impact.hit and impact.fraction > 0.0:
			distances.append(absf(_distance(impact.position, segment) - RADIUS))
	assert_gt(distances.size(), 60, "enough hits to mean something")
	assert_all_at_most(distances, 1e-10)
	assert_all_at_most(approaches, 0.0)


func test_the_earliest_wall_wins_wherever_it_is_in_the_list() -> void:
	var near := _wall_at(30.0)
	var far := _wall_at(60.0)
	var first := _shot([near, far] as Array[LineSegment])
	var last := _shot([far, near] as Array[LineSegment])
	assert_eq(first.fraction, 0.2)
	assert_eq(first.segment_index, 0)
	assert_eq(last.fraction, 0.2)
	assert_eq(last.segment_index, 1)


func test_the_last_hit_does_not_win() -> void:
	var walls: Array[LineSegment] = [_wall_at(50.0), _wall_at(30.0), _wall_at(70.0)]
	assert_eq(_shot(walls).segment_index, 1)


func test_a_missed_wall_does_not_count() -> void:
	var beside := LineSegment.new(Vec2.new(20, 50), Vec2.new(20, 90))
	var walls: Array[LineSegment] = [beside, _wall_at(60.0)]
	assert_eq(_shot(walls).segment_index, 1)


func test_without_walls_there_is_no_impact() -> void:
	var impact := _shot([] as Array[LineSegment])
	assert_false(impact.hit)
	assert_eq(impact.segment_index, -1)


func test_walls_out_of_reach_are_no_impact() -> void:
	assert_false(_shot([_wall_at(200.0), _wall_at(-60.0)] as Array[LineSegment]).hit)


func test_of_two_walls_touched_at_once_the_first_in_the_list_counts() -> void:
	assert_eq(_shot([_wall_at(60.0), _wall_at(60.0)] as Array[LineSegment]).segment_index, 0)


func test_in_a_corner_the_wall_that_is_met_first_counts() -> void:
	var floor_line := LineSegment.new(Vec2.new(-100, 40), Vec2.new(100, 40))
	var walls: Array[LineSegment] = [_wall_at(60.0), floor_line]
	var impact := SegmentImpact.with_segments(Vec2.zero(), Vec2.new(100, 100), RADIUS, walls)
	assert_eq(impact.segment_index, 1)
	assert_almost_eq(impact.fraction, 0.3, 1e-15)


func test_the_order_of_random_segments_does_not_matter() -> void:
	var vectors := random_vectors(71, 400)
	var differences := PackedFloat64Array()
	for index: int in range(0, vectors.size(), 20):
		var segments: Array[LineSegment] = []
		for pair: int in range(index, index + 18, 2):
			segments.append(LineSegment.new(vectors[pair], vectors[pair + 1]))
		var there := _random_shot(vectors, index, segments)
		segments.reverse()
		var back := _random_shot(vectors, index, segments)
		differences.append(absf(there.fraction - back.fraction) if there.hit == back.hit else INF)
	assert_all_at_most(differences, 0.0)


static func _floor() -> LineSegment:
	return LineSegment.new(Vec2.new(-100, 0), Vec2.new(100, 0))


static func _with_floor(old: Vec2, motion: Vec2) -> Impact:
	return SegmentImpact.with_segment(old, motion, RADIUS, _floor())


# Walks along the motion in 500 strides. Returns "" if the impact is in the first stride that ends
# nearer than the radius, or if there is neither; otherwise a sentence.
static func _difference_from_sampling(
	impact: Impact, old: Vec2, motion: Vec2, segment: LineSegment
) -> String:
	for stride: int in range(1, 501):
		if _distance(old.plus(motion.scaled(stride / 500.0)), segment) < RADIUS - 1e-9:
			var is_in_stride := (
				impact.hit
				and impact.fraction <= stride / 500.0
				and impact.fraction >= (stride - 1) / 500.0
			)
			return (
				""
				if is_in_stride
				else "touches in stride %d, not at %s" % [stride, impact.fraction]
			)
	# Between two strides a ball may dip into the line unseen, but not deeper than half a stride.
	var middle := old.plus(motion.scaled(impact.fraction + 0.001))
	if impact.hit and _distance(middle, segment) < RADIUS - 0.5:
		return "a touch at %s was not sampled" % impact.fraction
	return ""


# The height of the triangle, by Heron's formula for its area. Beyond an end, the distance from it.
static func _distance(point: Vec2, segment: LineSegment) -> float:
	var a := point.distance_to(segment.start)
	var b := point.distance_to(segment.end)
	var c := segment.start.distance_to(segment.end)
	if a * a + c * c <= b * b or b * b + c * c <= a * a:
		return minf(a, b)
	var half := (a + b + c) / 2.0
	return 2.0 * sqrt(maxf(half * (half - a) * (half - b) * (half - c), 0.0)) / c


static func _wall_at(x: float) -> LineSegment:
	return LineSegment.new(Vec2.new(x, -100), Vec2.new(x, 100))


static func _shot(segments: Array[LineSegment]) -> Impact:
	return SegmentImpact.with_segments(Vec2.zero(), Vec2.new(100, 0), RADIUS, segments)


static func _random_shot(vectors: Array[Vec2], index: int, segments: Array[LineSegment]) -> Impact:
	return SegmentImpact.with_segments(
		vectors[index + 18], vectors[index + 19].scaled(3.0), 5.0, segments
	)
