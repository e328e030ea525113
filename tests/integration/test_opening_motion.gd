extends ScreenTest
## What moves when a lesson is opened, until the student does anything.

const _LESSON := &"dot_product"
# More frames than a swing takes to get away from its start.
const _FRAMES := 10


func before_each() -> void:
	super()
	OpeningMotion.is_allowed = true
	Motion.reduce(false)


func after_each() -> void:
	OpeningMotion.is_allowed = false
	await super()


func test_a_lesson_moves_from_its_start_and_is_shown() -> void:
	await open_lesson(LessonIndex.find(_LESSON))
	await _wait()
	var head := _head()
	assert_ne(head, PackedFloat64Array([7, 1]))
	assert_almost_eq(Vec2.new(head[0], head[1]).length(), sqrt(50.0), 0.01, "it only turns")
	var arrow := frame().lesson.get_node("%A") as DraggableVector
	assert_eq(arrow.head_point().x, head[0])


func test_the_first_move_is_to_the_start() -> void:
	var times: PackedFloat64Array = []
	var motion := OpeningMotion.new(times.append, func() -> void: pass)
	add_child_autofree(motion)
	motion._process(5.0)
	motion._process(0.01)
	assert_eq(times[0], 0.0)
	assert_eq(times[1], 0.1, "the first frame may take long")


func test_it_ends_at_the_start_after_20_seconds() -> void:
	var told: PackedStringArray = []
	var seconds: PackedFloat64Array = []
	var motion := OpeningMotion.new(seconds.append, told.append.bind("back"))
	add_child_autofree(motion)
	for frame_number: int in 300:
		if motion.is_processing():
			motion._process(0.1)
	assert_almost_eq(seconds[-1], OpeningMotion.LONGEST, 0.11)
	assert_eq(told, PackedStringArray(["back"]))
	assert_false(OpeningMotion.is_running)


func test_whatever_the_student_does_stops_it_where_it_is() -> void:
	var deeds: Dictionary[String, Callable] = {
		"a click": func() -> void: await student.click_at(Vector2(300, 20)),
		"a key": func() -> void: await student.press_key(KEY_F),
		"the wheel":
		func() -> void: await student.click_at(Vector2(300, 20), MOUSE_BUTTON_WHEEL_DOWN),
		"a finger": func() -> void: await student.touch(Vector2(300, 20)),
		"a gamepad": func() -> void: await student.press_pad(JOY_BUTTON_RIGHT_STICK),
	}
	for deed: String in deeds:
		await open_lesson(LessonIndex.find(_LESSON))
		await _wait()
		assert_true(OpeningMotion.is_running, deed)
		await deeds[deed].call()
		var head := _head()
		await _wait()
		assert_eq(_head(), head, deed)
		assert_ne(head, PackedFloat64Array([7, 1]), deed)
		screen().free()


func test_moving_the_pointer_does_not_stop_it() -> void:
	await open_lesson(LessonIndex.find(_LESSON))
	await _wait()
	student.move_to(Vector2(200, 300))
	assert_true(OpeningMotion.is_running)


func test_a_moving_head_can_be_taken_and_does_not_jump() -> void:
	await open_lesson(LessonIndex.find(_LESSON))
	await _wait()
	var head := _head()
	var at := _place(head) + Vector2(6.0, 5.0)
	student.move_to(at)
	student.hold(at)
	head = _head()
	await _wait()
	assert_eq(_head(), head, "the press itself moves nothing")
	student.move_to(_place([3, 4]) + at - _place(head))
	student.release(_place([3, 4]))
	await student.settle()
	assert_eq(_head(), PackedFloat64Array([3, 4]))


func test_undo_goes_back_to_the_start_of_the_lesson() -> void:
	for edit: String in ["drag", "preset"]:
		await open_lesson(LessonIndex.find(_LESSON))
		await _wait()
		if edit == "drag":
			await student.drag(_place(_head()), _place([3, 4]))
		else:
			await click_button("Obtuse")
		await student.press(&"lab_undo")
		assert_eq(_head(), PackedFloat64Array([7, 1]), edit)
		assert_true((frame().get_node("%Undo") as Button).disabled, edit)
		screen().free()


func test_a_link_with_a_board_shows_that_board_and_does_not_move_it() -> void:
	LessonRequest.ask("#dot_product?a=3,4")
	await open_lesson(LessonIndex.find(_LESSON))
	await _wait()
	assert_eq(_head(), PackedFloat64Array([3, 4]))
	screen().free()
	LessonRequest.ask("#dot_product")
	await open_lesson(LessonIndex.find(_LESSON))
	await _wait()
	assert_true(OpeningMotion.is_running, "a link that names only the lesson")


func test_nothing_moves_where_motion_is_reduced() -> void:
	Motion.reduce(true)
	await open_lesson(LessonIndex.find(_LESSON))
	await _wait()
	assert_eq(_head(), PackedFloat64Array([7, 1]))


func test_the_switch_stops_what_moves_and_is_remembered() -> void:
	await open_lesson(LessonIndex.find(_LESSON))
	await student.press(&"lab_pause")
	var transport := frame().lesson.services[&"transport"] as Transport
	assert_true(transport.is_playing)
	await student.press(&"lab_motion")
	assert_false(transport.is_playing)
	assert_true(Motion.is_reduced())
	KeptChoices.read_again()
	assert_true(Motion.is_reduced(), "kept in a file")
	screen().free()
	await open_lesson(LessonIndex.find(_LESSON))
	assert_false(frame().view.menu.is_on(&"lab_motion"))
	await pick_in_view_menu("Motion")
	assert_false(Motion.is_reduced())


func _wait() -> void:
	for frame_number: int in _FRAMES:
		await get_tree().process_frame


func _head() -> PackedFloat64Array:
	return frame().lesson.state()["a"]


func _place(numbers: PackedFloat64Array) -> Vector2:
	var lesson := frame().lesson
	var point := Vec2.new(numbers[0], numbers[1])
	return lesson.get_global_transform() * lesson.board.to_screen(point)
