extends LabTest
## Motions by time alone: their pieces, and what is refused.

var _times: PackedFloat64Array = [0.0, 0.5, 2.0]
var _ways: Array[Vec2] = [Vec2.zero(), Vec2.new(10, 0), Vec2.new(10, -30)]


func test_a_steady_motion_is_one_piece() -> void:
	var motion := SegmentMotion.steady(Vec2.new(3, 4))
	assert_eq([motion.piece_at(0.0), motion.piece_at(1e9), motion.piece_end(0)], [0, 0, INF])
	assert_vec2(motion.velocity_of(0), Vec2.new(3, 4), 0.0)


func test_a_path_ends_at_rest() -> void:
	var motion := SegmentMotion.along(_times, _ways)
	assert_eq([motion.piece_at(0.0), motion.piece_at(0.5), motion.piece_at(9.0)], [0, 1, 2])
	assert_eq([motion.piece_end(0), motion.piece_end(1), motion.piece_end(2)], [0.5, 2.0, INF])
	assert_vec2(motion.velocity_of(0), Vec2.new(20, 0), 0.0)
	assert_vec2(motion.velocity_of(1), Vec2.new(0, -20), 0.0)
	assert_vec2(motion.velocity_of(2), Vec2.zero(), 0.0)
	assert_vec2(motion.way_of(2), Vec2.new(10, -30), 0.0)
	assert_almost_eq(motion.longest_way(), sqrt(1000.0), 1e-12)


func test_a_path_begins_again() -> void:
	var ways: Array[Vec2] = [Vec2.zero(), Vec2.new(10, 0), Vec2.zero()]
	var motion := SegmentMotion.along(_times, ways, true)
	for round_number: int in [0, 1, 7, 1000]:
		var start := 2.0 * round_number
		var piece := motion.piece_at(start)
		assert_eq(piece, 2 * round_number)
		assert_eq([motion.piece_begin(piece), motion.piece_end(piece)], [start, start + 0.5])
		assert_eq(motion.piece_end(piece + 1), start + 2.0)
		assert_eq(motion.piece_at(start + 1.0), piece + 1)
		assert_vec2(motion.way_of(piece + 1), Vec2.new(10, 0), 0.0)


# Times are sums: the end of a piece may be missed by a last place.
func test_just_before_the_end_of_a_piece_the_next_one_lasts() -> void:
	var motion := SegmentMotion.along(_times, _ways)
	assert_eq(motion.piece_at(0.5 * (1.0 - 1.0 / 2.0 ** 52)), 1)
	assert_eq(motion.piece_at(0.5 - 1e-12), 0)


func test_what_is_given_is_copied() -> void:
	var velocity := Vec2.new(1, 2)
	var motion := SegmentMotion.steady(velocity)
	velocity.x = 9.0
	assert_vec2(motion.velocity_of(0), Vec2.new(1, 2), 0.0)


func test_what_cannot_be_is_refused_with_its_value() -> void:
	var good := SegmentMotion.along(_times, _ways)
	assert_eq(good.problem(1e15), "")
	for row: Array in [
		[PackedFloat64Array([0.0]), _ways, "two times or more and a way for each, not 1 and 3."],
		[
			PackedFloat64Array([0.5, 1.0, 2.0]),
			_ways,
			"begins at 0 s with the way (0, 0), not at 0.5 s"
		],
		[PackedFloat64Array([0.0, 2.0, 2.0]), _ways, "must rise, not go from 2.0 s to 2.0 s."],
		[PackedFloat64Array([0.0, 1.0, NAN]), _ways, "must rise, not go from 1.0 s to nan s."],
	]:
		var times: PackedFloat64Array = row[0]
		var sentence: String = row[2]
		assert_string_contains(SegmentMotion.along(times, _ways).problem(1e15), sentence)
	assert_string_contains(
		SegmentMotion.along(_times, _ways, true).problem(1e15), "ends with the way (0, 0), not with"
	)
	assert_string_contains(
		SegmentMotion.steady(Vec2.new(NAN, 0)).problem(1e15), "must be within -1e+15..1e+15, not"
	)
	assert_string_contains(
		SegmentMotion.turning(Vec2.zero(), INF).problem(1e15), "rad/s, not by inf."
	)


func test_the_world_refuses_and_stays_as_it_was() -> void:
	var world := EventWorlds.world([Vector4(0, 0, 9, 0)], [])
	var bad := SegmentMotion.steady(Vec2.new(1e16, 0))
	assert_string_contains(world.set_segment_motion(0, bad), "must be within -1e+15..1e+15")
	assert_eq(world.set_segment_motion(3, bad), "There is no segment at the place 3.")
	assert_string_contains(world.set_belt_speed(0, NAN), "A belt must run with -1e+15..1e+15 px/s")
	assert_no_refusal(world.advance(1.0))
	assert_vec2(world.segment(0).start, Vec2.zero(), 0.0)


func test_a_motion_ends_where_the_segment_is_or_where_it_is_put() -> void:
	var world := EventWorlds.world([Vector4(0, 0, 9, 0), Vector4(0, 50, 9, 50)], [])
	for place: int in 2:
		assert_no_refusal(world.set_segment_motion(place, SegmentMotion.steady(Vec2.new(2, 0))))
	assert_no_refusal(world.advance(1.5))
	assert_no_refusal(world.set_segment_motion(0, null))
	assert_no_refusal(world.move_segment(1, LineSegment.new(Vec2.new(0, 70), Vec2.new(9, 70))))
	assert_no_refusal(world.advance(1.0))
	assert_vec2(world.segment(0).start, Vec2.new(3, 0), 0.0)
	assert_vec2(world.segment(1).start, Vec2.new(0, 70), 0.0)
	assert_no_refusal(world.remove_segment(0))
	assert_eq(world.segment_count(), 2)
