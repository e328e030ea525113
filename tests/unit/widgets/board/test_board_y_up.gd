extends LabTest
## The board turned over: y up, as in mathematics.

var _board: Board


func before_each() -> void:
	_board = Board.new()
	_board.size = Vector2(800.0, 600.0)
	add_child_autofree(_board)
	_board.pixels_per_unit = 40.0


func test_y_points_down_the_screen_at_first() -> void:
	assert_eq(_board.to_screen(Vec2.new(1.0, 2.0)), Vector2(440.0, 380.0))
	assert_eq(_board.y_sign(), 1.0)


func test_with_y_up_a_larger_y_is_higher_on_the_screen() -> void:
	_board.is_y_up = true
	assert_eq(_board.to_screen(Vec2.new(1.0, 2.0)), Vector2(440.0, 220.0))
	assert_eq(_board.y_sign(), -1.0)


func test_with_y_up_a_pixel_leads_back_to_its_point() -> void:
	_board.is_y_up = true
	for point in random_vectors(7, 50, 9.0):
		assert_vec2(_board.to_plane(_board.to_screen(point)), point, 1e-4)


func test_turning_the_board_over_has_everything_drawn_again() -> void:
	watch_signals(_board)
	_board.is_y_up = true
	assert_signal_emitted(_board, "view_changed")


func test_with_y_up_the_key_up_raises_y() -> void:
	assert_vec2(_nudged_up(), Vec2.new(0.0, -1.0), 0.0)
	_board.is_y_up = true
	assert_vec2(_nudged_up(), Vec2.new(0.0, 1.0), 0.0)


func _nudged_up() -> Vec2:
	var handle := Handle.new()
	_board.add_child(handle)
	var asked: Array[Vec2] = []
	handle.moved.connect(func(point: Vec2) -> void: asked.append(point))
	handle.grab_focus()
	var key := InputEventKey.new()
	key.keycode = KEY_UP
	key.pressed = true
	get_viewport().push_input(key)
	handle.free()
	return asked[0] if asked.size() == 1 else null
