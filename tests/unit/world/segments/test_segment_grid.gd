extends LabTest
## The grid finds the same first impact as the scan over all segments, to the last bit.

const _SEGMENTS := 200
const _SHOTS := 400


func test_grid_and_scan_agree_in_straight_flight() -> void:
	assert_eq(_differences(1.0, Vec2.zero()), PackedInt32Array())


func test_grid_and_scan_agree_under_gravity() -> void:
	assert_eq(_differences(1.0, Vec2.new(90, 300)), PackedInt32Array())


func test_they_agree_for_balls_larger_than_a_cell() -> void:
	assert_eq(_differences(30.0, Vec2.zero()), PackedInt32Array())
	assert_eq(_differences(30.0, Vec2.new(0, 200)), PackedInt32Array())


func test_they_agree_far_from_the_origin() -> void:
	assert_eq(_differences(1.0, Vec2.zero(), 1e9), PackedInt32Array())


func test_a_removed_segment_is_no_longer_met() -> void:
	var grid := SegmentGrid.new()
	for place: int in 20:
		grid.put(place, _upright(10.0 * place))
	assert_true(grid.first_impact(-50, 0, 100, 0, 1, INF))
	assert_eq(grid.index, 0)
	grid.remove(0)
	assert_true(grid.first_impact(-50, 0, 100, 0, 1, INF))
	assert_eq(grid.index, 1)


func test_a_moved_segment_is_met_where_it_is_now() -> void:
	var grid := SegmentGrid.new()
	for place: int in 20:
		grid.put(place, _upright(10.0 * place))
	grid.first_impact(-50, 0, 100, 0, 1, INF)
	grid.put(7, _upright(-30.0))
	assert_true(grid.first_impact(-50, 0, 100, 0, 1, INF))
	assert_eq([grid.index, grid.time], [7, 0.19])


func test_nothing_is_met_beyond_the_horizon() -> void:
	var grid := SegmentGrid.new()
	for place: int in 20:
		grid.put(place, _upright(10.0 * place))
	assert_false(grid.first_impact(-50, 0, 100, 0, 1, 0.48))
	assert_true(grid.first_impact(-50, 0, 100, 0, 1, 0.5))


func test_segments_in_one_row_need_few_cells() -> void:
	var grid := SegmentGrid.new()
	for place: int in 1000:
		grid.put(place, LineSegment.new(Vec2.new(place, 0), Vec2.new(place + 1, 0)))
	assert_true(grid.first_impact(500.5, 7, 0, -1, 1e-9, INF))
	assert_eq(grid.index, 500)
	assert_lt(grid._first_entry.size(), 4001)


# The shots for which grid and scan find different impacts.
func _differences(radius: float, pull: Vec2, offset: float = 0.0) -> PackedInt32Array:
	var grid := SegmentGrid.new()
	var scan := SegmentScan.new()
	var vectors := random_vectors(17, 2 * _SEGMENTS + 2 * _SHOTS, 500.0)
	var moved := Vec2.new(offset, -offset)
	for place: int in _SEGMENTS:
		var start := vectors[2 * place].plus(moved)
		var segment := LineSegment.new(start, start.plus(vectors[2 * place + 1].scaled(0.1)))
		grid.put(place, segment)
		scan.put(place, segment)
	var different := PackedInt32Array()
	for shot: int in _SHOTS:
		var from := vectors[2 * _SEGMENTS + 2 * shot].scaled(1.5).plus(moved)
		var velocity := vectors[2 * _SEGMENTS + 2 * shot + 1]
		if _found(grid, from, velocity, pull, radius) != _found(scan, from, velocity, pull, radius):
			different.append(shot)
	return different


static func _found(
	among: SegmentScan, from: Vec2, velocity: Vec2, pull: Vec2, radius: float
) -> Array:
	if pull.length() == 0.0:
		among.first_impact(from.x, from.y, velocity.x, velocity.y, radius, INF)
	else:
		among.first_accelerated_impact(
			from.x, from.y, velocity.x, velocity.y, pull.x, pull.y, radius, INF
		)
	return [among.index, among.time if among.index >= 0 else INF]


static func _upright(x: float) -> LineSegment:
	return LineSegment.new(Vec2.new(x, -20), Vec2.new(x, 20))
