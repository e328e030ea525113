extends ScreenTest
## A drag belongs to what was pressed, and ends when the button is up, a key acts, another finger
## comes down or the window loses the focus. What has been let go does not follow the pointer.

const _FAR := Vector2(70, -50)

## What ends a drag while the button is still down.
const _ENDS: PackedStringArray = ["a key", "the lost focus", "a release unseen"]


func test_every_handle_of_every_lesson_is_let_go_by_a_key() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		for i: int in _handle_places().size():
			var at := _handle_places()[i]
			await _hold_and_move(at)
			await student.press(&"lab_copy_link")
			await _assert_is_let_go(at, "%s, handle %d" % [lesson.id, i])
		screen().free()


func test_whatever_ends_a_drag_ends_it_on_handle_board_and_graph() -> void:
	for end: String in _ENDS:
		await open_lesson(LessonIndex.find(&"dot_product"))
		await go_to_step()
		var graph := Screen.named(screen(), "a · b, right: cos φ").get_global_rect().get_center()
		for at: Vector2 in [_place(7, 1), _place(-3, -4), graph]:
			await _hold_and_move(at)
			await _end(end)
			await _assert_is_let_go(at, end)
			assert_false(Screen.button(screen(), "Undo").disabled, "the drag until %s counts" % end)
		screen().free()


func test_whatever_ends_a_drag_ends_it_on_the_timeline() -> void:
	for end: String in _ENDS:
		await open_lesson(LessonIndex.find(&"angled_lines"))
		var options := frame().lesson.services[&"options"] as LessonOptions
		options.chosen.emit("method", SteppingMethods.Method.EVENT_WORLD)
		await student.settle()
		var bar := frame().lesson.find_child("Bar", true, false) as TimelineBar
		var at := bar.get_global_rect().get_center()
		await _hold_and_move(at)
		await _end(end)
		await _assert_is_let_go(at, end)
		screen().free()


func test_a_line_that_is_drawn_ends_with_what_ends_a_drag() -> void:
	for end: String in _ENDS:
		await open_lesson(LessonIndex.find(&"angled_lines"))
		var count := _line_count()
		var at := _place(-100, -150)
		await _hold_and_move(at)
		await _end(end)
		if end == "a release unseen":
			student.move_to(at)
		assert_eq(_line_count(), count + 1, end)
		await _assert_is_let_go(at, end)
		screen().free()


func test_a_line_deleted_in_its_drag_leaves_the_others_alone() -> void:
	await open_lesson(LessonIndex.find(&"angled_lines"))
	var lines := _lines()
	await _hold_and_move(_place(180, -10))
	await student.press(&"lab_delete_line")
	var left := _lines()
	assert_eq(left.size(), lines.size() - 4)
	student.move_to(_place(150, 60))
	student.release(_place(150, 60))
	await student.settle()
	assert_eq(_lines(), left)


func test_a_situation_picked_in_a_drag_stays_as_it_is() -> void:
	await open_lesson(LessonIndex.find(&"angled_lines"))
	await _hold_and_move(_place(180, -10))
	await student.press(&"lab_preset_5")
	var picked := frame().lesson.state()
	student.move_to(_place(150, 60))
	student.release(_place(150, 60))
	await student.settle()
	assert_eq(frame().lesson.state(), picked)


func test_undo_in_a_drag_takes_the_drag_back() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	var first := frame().lesson.state()
	await _hold_and_move(_place(7, 1))
	await student.press(&"lab_undo")
	student.move_to(_place(1, 5))
	student.release(_place(1, 5))
	await student.settle()
	assert_eq(frame().lesson.state(), first)
	assert_true(Screen.button(screen(), "Undo").disabled)


func test_shift_alone_ends_no_drag() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	await _hold_and_move(_place(7, 1))
	await student.press_key(KEY_SHIFT, true)
	student.move_to(_place(3.25, 1), true)
	student.release(_place(3.25, 1))
	await student.settle()
	var a: PackedFloat64Array = frame().lesson.state()["a"]
	assert_almost_eq(a[0], 3.25, 0.05)


func test_two_fingers_drag_nothing_and_one_drags_again() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	for at: Vector2 in [_place(7, 1), _place(-3, -4)]:
		student.put_finger(0, at, true)
		student.slide_finger(0, at + _FAR)
		await student.settle()
		var before := frame().lesson.state()
		student.put_finger(1, at + Vector2(200, 0), true)
		student.slide_finger(0, at - _FAR)
		student.slide_finger(1, at + Vector2(300, 0))
		student.put_finger(1, at + Vector2(300, 0), false)
		student.slide_finger(0, at - 2.0 * _FAR)
		student.put_finger(0, at - 2.0 * _FAR, false)
		await student.settle()
		assert_eq(frame().lesson.state(), before)
	student.put_finger(0, _place(8, -6), true)
	student.slide_finger(0, _place(5, 5))
	student.put_finger(0, _place(5, 5), false)
	await student.settle()
	assert_eq(_vector("b"), PackedFloat64Array([5, 5]))


func test_the_other_button_begins_a_drag_of_its_own() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	student.move_to(_place(-3, -4))
	student.hold(_place(-3, -4))
	student.hold(_place(-3, -4), MOUSE_BUTTON_RIGHT)
	student.move_to(_place(-5, 2))
	student.release(_place(-5, 2), MOUSE_BUTTON_RIGHT)
	student.release(_place(-5, 2))
	await student.settle()
	assert_eq(_vector("a"), PackedFloat64Array([-3, -4]))
	assert_eq(_vector("b"), PackedFloat64Array([-5, 2]))


func _hold_and_move(at: Vector2) -> void:
	student.move_to(at)
	student.hold(at)
	student.move_to(at + _FAR)
	await student.settle()


func _end(what: String) -> void:
	match what:
		"a key":
			await student.press(&"lab_copy_link")
		"the lost focus":
			student.window.propagate_notification(NOTIFICATION_WM_WINDOW_FOCUS_OUT)
		"a release unseen":
			student.release_unseen()


# The first movement tells of a button that was released unseen.
func _assert_is_let_go(at: Vector2, text: String) -> void:
	student.move_to(at + _FAR)
	var before := frame().lesson.state()
	student.move_to(at - _FAR)
	student.release(at - _FAR)
	await student.settle()
	assert_eq(frame().lesson.state(), before, text)


func _handle_places() -> PackedVector2Array:
	var places: PackedVector2Array = []
	for control: Control in Screen.controls(frame().lesson):
		if control is Handle and control is not ArrowBody:
			places.append(control.get_global_rect().get_center())
	return places


func _place(x: float, y: float) -> Vector2:
	var lesson := frame().lesson
	return lesson.get_global_transform() * lesson.board.to_screen(Vec2.new(x, y))


func _vector(letter: String) -> PackedFloat64Array:
	return frame().lesson.state()[letter]


func _lines() -> PackedFloat64Array:
	var world: Dictionary = frame().lesson.state()["world"]
	return world["lines"]


func _line_count() -> int:
	return roundi(_lines().size() / 4.0)
