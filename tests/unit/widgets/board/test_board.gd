extends LabTest
## The plane of a board on the screen, and back.

const _SIZE := Vector2(800, 600)
const _TINY: PackedFloat64Array = [0.004, 0.001, 0.003, -0.002]

var _board: Board


func before_each() -> void:
	_board = Board.new()
	_board.size = _SIZE
	add_child_autofree(_board)


func test_the_origin_is_in_the_middle_and_y_points_down() -> void:
	_board.fit([Vec2.new(7, 1), Vec2.new(8, -6)])
	assert_eq(_board.to_screen(Vec2.new(0, 0)), _SIZE / 2.0)
	assert_gt(_board.to_screen(Vec2.new(0, 1)).y, _SIZE.y / 2.0)
	assert_gt(_board.to_screen(Vec2.new(1, 0)).x, _SIZE.x / 2.0)


func test_to_plane_is_the_inverse_of_to_screen() -> void:
	for reach: float in [1e-3, 1.0, 10.0, 1e6, 1e15]:
		var points := random_vectors(3, 50, reach)
		_board.fit(points)
		for point: Vec2 in points:
			assert_vec2(_board.to_plane(_board.to_screen(point)), point, reach * 1e-5)


func test_all_points_are_inside_after_fitting() -> void:
	for points: Array[Vec2] in _situations():
		_board.fit(points)
		for point: Vec2 in points:
			assert_true(Rect2(Vector2.ZERO, _SIZE).has_point(_board.to_screen(point)), str(point))


func test_a_step_of_the_grid_is_neither_narrow_nor_wide() -> void:
	for points: Array[Vec2] in _situations():
		_board.fit(points)
		var step := _board.grid_step * _board.pixels_per_unit
		assert_between(step, Board.NARROWEST_STEP * 0.999, Board.WIDEST_STEP * 1.001)


func test_a_step_is_1_2_or_5_times_a_power_of_ten() -> void:
	for exponent: int in range(-6, 16):
		for share: float in [1.0, 1.7, 3.3, 6.1]:
			_board.fit([Vec2.new(share * pow(10.0, exponent), 0)])
			var power := pow(10.0, floorf(log(_board.grid_step) / log(10.0) + 1e-9))
			var mantissa := snappedf(_board.grid_step / power, 1e-9)
			assert_has([1.0, 2.0, 5.0], mantissa, str(_board.grid_step))


func test_ordinary_vectors_snap_to_whole_units() -> void:
	_board.fit([Vec2.new(7, 1), Vec2.new(8, -6)])
	assert_eq(_board.grid_step, 1.0)
	assert_vec2(_board.snapped_to_step(Vec2.new(2.4, -3.6)), Vec2.new(2, -4), 0.0)


func test_huge_and_tiny_vectors_snap_to_steps_of_their_size() -> void:
	_board.fit([Vec2.new(4e15, 3e15), Vec2.new(6e15, -8e15)])
	assert_eq(_board.grid_step, 1e15)
	_board.fit([Vec2.new(_TINY[0], _TINY[1]), Vec2.new(_TINY[2], _TINY[3])])
	assert_lt(_board.grid_step, 0.001)


func test_zero_vectors_alone_leave_an_ordinary_grid() -> void:
	_board.fit([Vec2.new(0, 0)])
	assert_eq(_board.grid_step, 1.0)
	assert_eq(_board.pixels_per_unit, Board.WIDEST_STEP)


func test_a_step_of_its_own_comes_before_that_of_the_grid() -> void:
	_board.fit([Vec2.new(700, 100)])
	_board.snap_step = 0.5
	assert_vec2(_board.snapped_to_step(Vec2.new(2.4, -3.6)), Vec2.new(2.5, -3.5), 0.0)


func test_a_point_far_outside_stays_finite_and_keeps_its_direction() -> void:
	_board.fit([Vec2.new(7, 1)])
	var far := _board.to_screen(Vec2.new(3e99, 4e99)) - _SIZE / 2.0
	assert_true(far.is_finite())
	assert_almost_eq(far.normalized().x, 0.6, 1e-6)


func test_a_change_of_the_view_is_told() -> void:
	watch_signals(_board)
	_board.fit([Vec2.new(7, 1)])
	assert_signal_emit_count(_board, "view_changed", 1)
	_board.size = Vector2(400, 400)
	assert_signal_emit_count(_board, "view_changed", 2)


func _situations() -> Array[Array]:
	return [
		[Vec2.new(7, 1), Vec2.new(8, -6)] as Array[Vec2],
		[Vec2.new(4e15, 3e15), Vec2.new(6e15, -8e15)] as Array[Vec2],
		[Vec2.new(_TINY[0], _TINY[1]), Vec2.new(_TINY[2], _TINY[3])] as Array[Vec2],
		[Vec2.new(0, 0)] as Array[Vec2],
		[Vec2.new(1, 0)] as Array[Vec2],
		[Vec2.new(0.999, 0)] as Array[Vec2],
		[Vec2.new(-1e100, 1e100)] as Array[Vec2],
		[Vec2.new(0, 1e-100)] as Array[Vec2],
	]


func test_a_board_that_does_not_keep_the_origin_has_the_points_in_its_middle() -> void:
	_board.keeps_origin = false
	var corners: Array[Vec2] = [Vec2.new(300, 100), Vec2.new(500, 160)]
	_board.fit(corners)
	assert_almost_eq(_board.to_screen(Vec2.new(400, 130)), _board.size / 2.0, Vector2(1e-6, 1e-6))
	var first := _board.to_screen(corners[0])
	assert_true(Rect2(Vector2.ZERO, _board.size).has_point(first))
	assert_lt(first.x, _board.margin + 1.0, "it is as large as there is room")
