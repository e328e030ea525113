extends ScreenTest
## The start screen: cards that can be read, and opened by mouse, finger, keyboard and gamepad.

const _SIZES: Array[Vector2i] = [Vector2i(1280, 720), Vector2i(800, 600), Vector2i(390, 844)]


func test_a_card_for_every_lesson_shows_number_title_line_and_picture() -> void:
	await open_start_screen()
	var cards := _cards()
	var lessons := LessonIndex.lessons()
	assert_eq(cards.size(), lessons.size())
	for i: int in lessons.size():
		assert_true(Screen.reads(cards[i], "%d  %s" % [i + 1, lessons[i].title]), lessons[i].id)
		assert_true(Screen.reads(cards[i], lessons[i].summary), lessons[i].id)
		assert_not_null((cards[i].get_node("%Picture") as TextureRect).texture, lessons[i].id)


func test_a_screen_reader_is_told_title_and_line_of_a_card() -> void:
	await open_start_screen()
	var lesson := LessonIndex.lessons()[0]
	var spoken := "1  %s. %s" % [lesson.title, lesson.summary]
	assert_eq(_cards()[0].accessibility_name, spoken)


func test_the_first_card_has_the_focus() -> void:
	await open_start_screen()
	assert_same(student.window.gui_get_focus_owner(), _cards()[0])


func test_enter_opens_the_card_with_the_focus() -> void:
	await open_start_screen()
	await student.press_key(KEY_ENTER)
	_assert_first_lesson_is_open()


func test_the_gamepads_a_opens_the_card_with_the_focus() -> void:
	await open_start_screen()
	await student.press_pad(JOY_BUTTON_A)
	_assert_first_lesson_is_open()


func test_a_click_opens_a_card() -> void:
	await open_start_screen()
	await student.click(_cards()[0])
	_assert_first_lesson_is_open()


func test_a_finger_opens_a_card() -> void:
	await open_start_screen()
	await student.touch(_cards()[0].get_global_rect().get_center())
	_assert_first_lesson_is_open()


func test_tab_and_enter_open_every_lesson_in_its_order() -> void:
	for i: int in LessonIndex.lessons().size():
		await open_start_screen()
		for tab: int in i:
			await student.press_key(KEY_TAB)
		await student.press_key(KEY_ENTER)
		assert_eq(frame().lesson_info.id, LessonIndex.ids()[i])
		screen().free()


func test_escape_and_the_gamepads_b_lead_back_from_a_lesson() -> void:
	for leave: Callable in [
		student.press_key.bind(KEY_ESCAPE), student.press_pad.bind(JOY_BUTTON_B)
	]:
		await open_start_screen()
		await student.press_key(KEY_ENTER)
		_assert_first_lesson_is_open()
		await leave.call()
		assert_null(frame())
		assert_eq(_cards().size(), LessonIndex.lessons().size())
		screen().free()


func test_no_notice_is_shown_unless_something_is_wrong() -> void:
	await open_start_screen()
	assert_false((screen().get_node("%NoticePlace") as Control).visible)


func test_the_way_back_leads_to_the_card_of_the_lesson_that_was_left() -> void:
	for size: Vector2i in _SIZES:
		await resize(size)
		await open_start_screen()
		for tab: int in 9:
			await student.press_key(KEY_TAB)
		await student.press_key(KEY_ENTER)
		await student.press_key(KEY_ESCAPE)
		await student.settle()
		assert_same(student.window.gui_get_focus_owner(), _cards()[9], str(size))
		_assert_is_in_sight(_cards()[9])
		screen().free()


func test_the_refusal_of_an_unknown_lesson_is_in_sight() -> void:
	for size: Vector2i in _SIZES:
		await resize(size)
		LessonRequest.ask("nonsense")
		await open_start_screen()
		await student.settle()
		assert_reads("There is no lesson “nonsense”.")
		_assert_is_in_sight(screen().get_node("%Notice") as Control)
		screen().free()


func test_the_refusal_of_a_link_is_in_sight_however_far_one_has_scrolled() -> void:
	await resize(_SIZES[0])
	await open_start_screen()
	for tab: int in 9:
		await student.press_key(KEY_TAB)
	screen().call(&"_follow_link", "#nonsense")
	await student.settle()
	_assert_is_in_sight(screen().get_node("%Notice") as Control)


func _assert_is_in_sight(control: Control) -> void:
	var place := control.get_global_rect()
	var window := student.window.get_visible_rect()
	assert_true(window.encloses(place), "%s at %s in %s" % [control.name, place, window])


func _assert_first_lesson_is_open() -> void:
	assert_not_null(frame())
	if frame():
		assert_eq(frame().lesson_info.id, LessonIndex.ids()[0])


func _cards() -> Array[LessonCard]:
	var found: Array[LessonCard] = []
	for control: Control in Screen.controls(screen()):
		if control is LessonCard:
			found.append(control as LessonCard)
	return found
