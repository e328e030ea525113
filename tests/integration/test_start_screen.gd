extends ScreenTest
## The start screen: cards that can be read, and opened by mouse, finger, keyboard and gamepad.

const _SIZES: Array[Vector2i] = [Vector2i(1280, 720), Vector2i(800, 600), Vector2i(390, 844)]
const _ALL_SIZES: Array[Vector2i] = [
	Vector2i(390, 844),
	Vector2i(844, 390),
	Vector2i(720, 1280),
	Vector2i(800, 600),
	Vector2i(1280, 720),
	Vector2i(1920, 1080),
	Vector2i(3840, 2160),
]
const _SMALLEST_TARGET := 44.0
const _SMALLEST_TEXT := 14.0
const _DIGITS: Array[Key] = [KEY_1, KEY_2, KEY_3, KEY_4, KEY_5, KEY_6, KEY_7, KEY_8, KEY_9, KEY_0]


func test_a_card_for_every_lesson_shows_number_title_line_and_picture() -> void:
	await open_start_screen()
	var cards := _cards()
	var lessons := _lessons_in_order()
	assert_eq(cards.size(), lessons.size())
	for i: int in lessons.size():
		assert_true(Screen.reads(cards[i], LessonIndex.heading_of(lessons[i])), lessons[i].id)
		assert_true(Screen.reads(cards[i], lessons[i].summary), lessons[i].id)
		assert_not_null((cards[i].get_node("%Picture") as TextureRect).texture, lessons[i].id)


func test_a_screen_reader_is_told_title_and_line_of_a_card() -> void:
	await open_start_screen()
	var lesson := LessonIndex.lessons()[1]
	var spoken := "2  %s. %s" % [lesson.title, lesson.summary]
	assert_eq(_cards()[1].accessibility_name, spoken)


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
		assert_same(frame().lesson_info, _lessons_in_order()[i])
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
		assert_eq(_cards().size(), LessonIndex.all().size())
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


func test_a_digit_opens_the_lesson_with_that_number_and_0_the_tenth() -> void:
	for i: int in _DIGITS.size():
		await open_start_screen()
		await student.press_key(_DIGITS[i])
		assert_same(frame().lesson_info, LessonIndex.lessons()[i])
		screen().free()


func test_home_and_end_go_to_the_first_card_and_the_last() -> void:
	for size: Vector2i in _SIZES:
		await resize(size)
		await open_start_screen()
		await student.press_key(KEY_END)
		await student.settle()
		assert_same(student.window.gui_get_focus_owner(), _all_cards()[-1], str(size))
		_assert_is_in_sight(_all_cards()[-1])
		await student.press_key(KEY_HOME)
		await student.settle()
		assert_same(student.window.gui_get_focus_owner(), _cards()[0], str(size))
		_assert_is_in_sight(_label("Vec2 Lab"))
		screen().free()


func test_arrow_keys_go_to_the_card_beside_and_below() -> void:
	await open_start_screen()
	await student.press_key(KEY_RIGHT)
	assert_same(student.window.gui_get_focus_owner(), _cards()[1])
	await student.press_key(KEY_DOWN)
	assert_same(student.window.gui_get_focus_owner(), _cards()[5])


func test_the_keys_are_named_at_the_foot_until_a_finger_comes() -> void:
	await open_start_screen()
	var help := screen().get_node("%Help") as Label
	_assert_is_in_sight(help)
	var said := help.text.replace(Steps.NO_BREAK_SPACE, " ")
	for words: String in ["1…9 lesson", "0 lesson 10", "Home first", "End last", "Enter open"]:
		assert_string_contains(said, words)
	await student.touch(Vector2(2, 2))
	assert_false(help.visible)
	await student.press_key(KEY_RIGHT)
	assert_true(help.visible)
	await student.press_pad(JOY_BUTTON_DPAD_LEFT)
	assert_string_contains(help.text.replace(Steps.NO_BREAK_SPACE, " "), "A open")


func test_headings_stand_above_their_cards_at_every_size() -> void:
	for size: Vector2i in _ALL_SIZES:
		await _draw_at(size)
		for part: LessonAgenda.Part in LessonAgenda.parts():
			var heading := _label(part.title).get_parent_control().get_global_rect()
			var card := _card_of(part.lessons[0]).get_global_rect()
			assert_true(Screen.reads(screen(), part.line), part.title)
			assert_lte(heading.end.y, card.position.y, "%s at %s" % [part.title, size])
			assert_almost_eq(heading.position.x, card.position.x, 1.0, part.title)
		screen().free()


func test_cards_fill_the_width_in_equal_columns_at_every_size() -> void:
	for size: Vector2i in _ALL_SIZES:
		await _draw_at(size)
		var shelf := (screen().get_node("%Cards") as Control).get_global_rect()
		var row: Array[Rect2] = []
		for card: ShelfCard in _all_cards():
			var place := card.get_global_rect()
			assert_almost_eq(place.size.x, _cards()[0].size.x, 1.0, str(size))
			if row and place.position.y > row[-1].position.y:
				assert_almost_eq(row[-1].end.x, shelf.end.x, 1.0, "a row is full at %s" % size)
				row.clear()
			row.append(place)
		assert_gte(shelf.size.x, screen().size.x - 48.0, str(size))
		screen().free()


func test_cards_and_their_texts_are_large_enough_and_whole_at_every_size() -> void:
	for size: Vector2i in _ALL_SIZES:
		LessonsDone.note(LessonsDone.SEEN, &"normals")
		LessonsDone.note(LessonsDone.ANSWERED, &"normals")
		await _draw_at(size)
		var pixels := student.window.get_final_transform().get_scale().x
		for control: Control in Screen.controls(screen()):
			if control is Label:
				var font_size := control.get_theme_font_size(&"font_size")
				assert_gte(font_size * pixels, _SMALLEST_TEXT, (control as Label).text)
			if control is ShelfCard:
				_assert_holds_its_parts(control as ShelfCard, str(size))
			if control is Button:
				var least := minf(control.size.x, control.size.y) * pixels
				assert_gte(least, _SMALLEST_TARGET, "%s at %s" % [control.name, size])
		assert_eq(", ".join(Layout.problems(screen())), "", str(size))
		screen().free()


func test_a_lesson_counts_as_seen_when_its_last_step_is_shown() -> void:
	await open_start_screen()
	await student.press_key(KEY_3)
	await student.press(&"lab_next_step")
	await student.press_key(KEY_ESCAPE)
	assert_false(Screen.reads(_card_of(LessonIndex.find(&"normals")), "Seen"))
	await student.press_key(KEY_3)
	await go_to_step()
	await student.press_key(KEY_ESCAPE)
	var card := _card_of(LessonIndex.find(&"normals"))
	assert_true(Screen.reads(card, "✓ Seen"))
	assert_string_ends_with(card.accessibility_name, ". Seen")
	assert_false(Screen.reads(card, "Question answered"))


func test_a_question_counts_as_answered_when_the_answer_is_right() -> void:
	await open_start_screen()
	await student.press_key(KEY_4)
	await _answer(false)
	await student.press_key(KEY_ESCAPE)
	assert_does_not_read("Question answered")
	await student.press_key(KEY_4)
	await _answer(true)
	await student.press_key(KEY_ESCAPE)
	var card := _card_of(LessonIndex.find(&"dot_product"))
	assert_true(Screen.reads(card, "✓ Question answered"))
	assert_string_ends_with(card.accessibility_name, ". Question answered")


func test_the_first_card_that_has_not_been_seen_says_start_here() -> void:
	await open_start_screen()
	_assert_starts_at(0)
	screen().free()
	LessonsDone.note(LessonsDone.SEEN, &"easy_bounce")
	await open_start_screen()
	_assert_starts_at(0)
	screen().free()
	LessonsDone.note(LessonsDone.SEEN, &"class_or_value")
	await open_start_screen()
	_assert_starts_at(2)
	screen().free()
	for lesson: LessonInfo in LessonIndex.all():
		LessonsDone.note(LessonsDone.SEEN, lesson.id)
	await open_start_screen()
	_assert_starts_at(-1)


func test_what_was_done_is_forgotten_after_one_question() -> void:
	await open_start_screen()
	assert_null(Screen.button(screen(), "Forget what I have done"), "nothing is to be forgotten")
	screen().free()
	LessonsDone.note(LessonsDone.SEEN, &"class_or_value")
	await open_start_screen()
	await click_button("Forget what I have done")
	assert_reads("Seen")
	await click_button("Keep it")
	assert_true(LessonsDone.is_any())
	await click_button("Forget what I have done")
	await click_button("Forget it")
	assert_false(LessonsDone.is_any())
	assert_does_not_read("Seen")
	assert_null(Screen.button(screen(), "Forget what I have done"))
	_assert_starts_at(0)


func test_enter_alone_forgets_nothing() -> void:
	LessonsDone.note(LessonsDone.SEEN, &"class_or_value")
	await open_start_screen()
	Screen.button(screen(), "Forget what I have done").grab_focus()
	await student.press_key(KEY_ENTER)
	await student.press_key(KEY_ENTER)
	assert_true(LessonsDone.is_any())
	assert_same(
		student.window.gui_get_focus_owner(), Screen.button(screen(), "Forget what I have done")
	)


func test_a_lesson_in_a_demo_notes_nothing() -> void:
	await open_lesson(LessonIndex.find(&"normals"))
	await go_to_step()
	assert_false(LessonsDone.is_any())


func _draw_at(size: Vector2i) -> void:
	await resize(size)
	await open_start_screen()
	for time: int in 2:
		await student.settle()


func _assert_holds_its_parts(card: ShelfCard, where: String) -> void:
	var below := 0.0
	for part: Control in [
		card.get_node("%Title"), card.get_node("%Summary"), card.get_node("%Done")
	]:
		if not part.visible:
			continue
		assert_true(Rect2(Vector2.ZERO, card.size).encloses(part.get_rect()), where)
		assert_gte(part.position.y, below, where)
		assert_gte(part.size.y, part.get_combined_minimum_size().y, where)
		below = part.get_rect().end.y


func _assert_starts_at(place: int) -> void:
	for i: int in _cards().size():
		assert_eq(Screen.reads(_cards()[i], "Start here"), i == place, str(i))


func _answer(rightly: bool) -> void:
	var question := frame().lesson.services[&"question"] as Question
	question.folded = false
	await student.settle()
	var exercise: Exercise = question.get(&"_exercise")
	var fields: Array[LineEdit] = question.get(&"_fields")
	for i: int in fields.size():
		var answer := exercise.right_answer[i] + (0.0 if rightly else 7.0)
		await student.enter(fields[i], str(answer))


func _lessons_in_order() -> Array[LessonInfo]:
	var found: Array[LessonInfo] = []
	for part: LessonAgenda.Part in LessonAgenda.parts():
		found.append_array(part.lessons)
	return found


func _card_of(lesson: LessonInfo) -> LessonCard:
	return _cards()[_lessons_in_order().find(lesson)]


func _label(text: String) -> Label:
	for control: Control in Screen.controls(screen()):
		if control is Label and Screen.text_of(control) == text:
			return control as Label
	return null


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


# Those of the workshop, too.
func _all_cards() -> Array[ShelfCard]:
	return (screen().get_node("%Cards") as LessonShelf).cards()
