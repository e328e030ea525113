extends LabTest
## Of several impacts in one frame the earliest happens.

const RADIUS := 10.0


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
	var impact := EarliestImpact.among(Vec2.zero(), Vec2.new(100, 100), RADIUS, walls)
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


static func _wall_at(x: float) -> LineSegment:
	return LineSegment.new(Vec2.new(x, -100), Vec2.new(x, 100))


static func _shot(segments: Array[LineSegment]) -> Impact:
	return EarliestImpact.among(Vec2.zero(), Vec2.new(100, 0), RADIUS, segments)


static func _random_shot(vectors: Array[Vec2], index: int, segments: Array[LineSegment]) -> Impact:
	return EarliestImpact.among(vectors[index + 18], vectors[index + 19].scaled(3.0), 5.0, segments)
