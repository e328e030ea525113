extends ScreenTest
## The address of the page follows the board after complete changes, and not too often.

const _WAIT := 0.6

var _told: PackedStringArray = []
var _address: LessonAddress


func before_each() -> void:
	super()
	_told.clear()
	await open_lesson(LessonIndex.find(&"dot_product"))
	_address = LessonAddress.new(frame().lesson_info.id, frame().link)
	_address.changed.connect(func(text: String) -> void: _told.append(text))
	frame().add_child(_address)


func test_nothing_is_told_before_something_changes() -> void:
	await get_tree().create_timer(_WAIT).timeout
	assert_eq(_told, PackedStringArray())


func test_the_first_change_is_told_at_once_and_those_that_follow_together() -> void:
	for value: float in [3.0, 4.0, 5.0]:
		frame().lesson.services[&"formula"].emit_signal(&"number_entered", "ax", value)
		_address.note()
		await student.settle()
	assert_eq(_told, PackedStringArray(["dot_product?a=3,1"]))
	await get_tree().create_timer(_WAIT).timeout
	assert_eq(_told, PackedStringArray(["dot_product?a=3,1", "dot_product?a=5,1"]))


func test_a_lesson_that_is_left_tells_what_it_has_not_told_yet() -> void:
	for step: int in [1, 2]:
		await go_to_step(step)
		_address.note()
		await student.settle()
	screen().free()
	assert_eq(_told, PackedStringArray(["dot_product?step=2", "dot_product?step=3"]))


func test_a_board_that_no_link_can_hold_is_not_told() -> void:
	frame().lesson.show_state(
		{"a": PackedFloat64Array([1e-200, 0.0])}.merged(frame().lesson.state())
	)
	_address.note()
	await student.settle()
	assert_eq(_told, PackedStringArray())


func test_the_frame_says_of_each_complete_change_and_each_step_that_it_came() -> void:
	watch_signals(frame().lesson)
	await student.press(&"lab_next_step")
	assert_signal_emit_count(frame().lesson, "step_changed", 1)


func test_the_address_of_the_start_screen_leads_back_to_it() -> void:
	screen().free()
	await open_start_screen()
	await student.press_key(KEY_ENTER)
	frame().follow_link("")
	await student.settle()
	assert_null(frame())
