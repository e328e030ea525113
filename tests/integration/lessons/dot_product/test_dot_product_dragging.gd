extends DotProductTest
## Clicks, drags and touches on the board of the lesson on the dot product.


func test_the_lesson_starts_with_the_vectors_of_the_lecture() -> void:
	assert_a([0, 0, 7, 1])
	assert_b([0, 0, 8, -6])


func test_a_left_click_sets_the_head_of_a_on_the_grid() -> void:
	await student.click_at(place(-3.2, -3.9))
	assert_a([0, 0, -3, -4])
	assert_b([0, 0, 8, -6])


func test_a_right_click_sets_the_head_of_b_on_the_grid() -> void:
	await student.click_at(place(-3.2, -3.9), MOUSE_BUTTON_RIGHT)
	assert_a([0, 0, 7, 1])
	assert_b([0, 0, -3, -4])


func test_a_right_click_on_an_arrow_or_a_handle_sets_b_too() -> void:
	await student.click_at(place(4.2, 0.6), MOUSE_BUTTON_RIGHT)
	assert_b([0, 0, 4, 1])
	await student.click_at(place(7.1, 1.1), MOUSE_BUTTON_RIGHT)
	assert_b([0, 0, 7, 1])


func test_a_finger_sets_a() -> void:
	await student.touch(place(-4.1, -2.9))
	assert_a([0, 0, -4, -3])


func test_dragging_on_the_empty_board_lets_the_head_follow() -> void:
	await drag(Vec2.new(-2, 3), Vec2.new(-5.3, 4.2))
	assert_a([0, 0, -5, 4])


func test_dragging_a_head_snaps_to_the_grid() -> void:
	await drag(Vec2.new(7, 1), Vec2.new(3.3, -3.8))
	assert_a([0, 0, 3, -4])
	await drag(Vec2.new(8, -6), Vec2.new(-2.4, 5.4))
	assert_b([0, 0, -2, 5])


func test_shift_frees_a_dragged_head_from_the_grid() -> void:
	await drag(Vec2.new(7, 1), Vec2.new(3.3, -3.8), true)
	assert_almost_eq(ends("a")[2], 3.3, 0.02)
	assert_almost_eq(ends("a")[3], -3.8, 0.02)


func test_taking_hold_beside_the_middle_of_a_handle_moves_nothing() -> void:
	await student.drag(place(7, 1) + Vector2(9, 9), place(7, 1) + Vector2(10, 9))
	assert_a([0, 0, 7, 1])


func test_dragging_a_tail_leaves_the_head_where_it_is() -> void:
	await drag(Vec2.new(0, 0), Vec2.new(2.1, 2.9))
	assert_b([2, 3, 8, -6])
	await drag(Vec2.new(0, 0), Vec2.new(-2.1, 1.2))
	assert_a([-2, 1, 7, 1])


func test_dragging_the_body_moves_the_whole_vector() -> void:
	await drag(Vec2.new(3.5, 0.5), Vec2.new(1.5, 3.5))
	assert_a([-2, 3, 5, 4])


func test_a_head_that_lies_on_the_other_arrow_can_be_taken() -> void:
	await drag(Vec2.new(7, 1), Vec2.new(4, -3))
	assert_a([0, 0, 4, -3], "a lies along b now")
	await drag(Vec2.new(4, -3), Vec2.new(6, 2))
	assert_a([0, 0, 6, 2])
	assert_b([0, 0, 8, -6])


func test_a_head_behind_the_graph_can_be_taken() -> void:
	await go_to_step()
	var plot := Screen.named(screen(), "a · b, right: cos φ")
	var lesson := frame().lesson
	var middle := (
		lesson.get_global_transform().affine_inverse() * plot.get_global_rect().get_center()
	)
	var behind := lesson.board.snapped_to_step(lesson.board.to_plane(middle))
	await student.enter(field("x of a"), str(behind.x))
	await student.enter(field("y of a"), str(behind.y))
	await drag(Vec2.new(ends("a")[2], ends("a")[3]), Vec2.new(0, 4))
	assert_a([0, 0, 0, 4])


func test_a_head_and_a_shaft_are_taken_21_window_pixels_beside_their_middle() -> void:
	for size: Vector2i in [Vector2i(1280, 720), Vector2i(800, 600), Vector2i(720, 1280)]:
		await resize(size)
		var beside := Vector2(3, -21) / student.window.get_final_transform().get_scale()
		await student.drag(place(7, 1) + beside, place(7, 4) + beside)
		# On a small board the steps of the grid are wider.
		var head := frame().lesson.board.snapped_to_step(Vec2.new(7, 4))
		assert_a([0, 0, head.x, head.y], "head at %s" % size)
		await student.press(&"lab_reset")
		await student.drag(place(3.5, 0.5) + beside, place(3.5, 3.5) + beside)
		var tail := frame().lesson.board.snapped_to_step(Vec2.new(0, 3))
		assert_a([tail.x, tail.y, tail.x + 7, tail.y + 1], "shaft at %s" % size)
		await student.press(&"lab_reset")
