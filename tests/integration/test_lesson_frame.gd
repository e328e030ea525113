extends ScreenTest
## The lesson frame brings what a lesson needs and nothing else, shows help, and leaves nothing
## behind.

const _CLOCK := preload("res://tests/support/lessons/clock.tres")
const _STILL := preload("res://tests/support/lessons/still.tres")
const _BROKEN := preload("res://tests/support/lessons/broken.tres")
const _IMPOSSIBLE := preload("res://tests/support/lessons/impossible.tres")
const _ROUND_TRIPS := 10


func test_a_lesson_without_needs_has_an_empty_panel() -> void:
	await open_lesson(_STILL)
	assert_eq(_services().size(), 0)
	assert_eq(frame().lesson.services.size(), 0)


func test_the_panel_holds_the_needed_services_in_their_order() -> void:
	for lesson: LessonInfo in LessonIndex.lessons() + [_CLOCK]:
		await open_lesson(lesson)
		# A lesson may put a card of its own between them.
		var all: Array = frame().lesson.services.values()
		var shown: Array[Node] = _services().filter(func(part: Node) -> bool: return part in all)
		assert_eq(shown.size(), lesson.needs.size(), lesson.id)
		for i: int in lesson.needs.size():
			assert_same(shown[i], frame().lesson.services[StringName(lesson.needs[i])])
		screen().free()


func test_the_title_shows_number_and_name() -> void:
	await open_lesson(LessonIndex.lessons()[0])
	assert_reads("1  " + LessonIndex.lessons()[0].title)


func test_a_lesson_that_cannot_start_says_so_in_the_window() -> void:
	await open_lesson(_BROKEN)
	assert_engine_error("Modulo by zero")
	assert_reads("The lesson “broken” could not be opened: ")
	assert_reads("broken.gd:7")
	for action: StringName in [&"lab_reset", &"lab_copy_link", &"lab_undo"]:
		await student.press(action)
	assert_reads("The lesson “broken” could not be opened: ")


func test_a_lesson_whose_start_cannot_be_shown_says_so_in_the_window() -> void:
	await open_lesson(_IMPOSSIBLE)
	assert_push_error("The radius must not be -1.")
	assert_reads("The lesson “impossible” could not be opened: The radius must not be -1.")


func test_in_place_of_a_lesson_that_cannot_start_another_can_be_opened() -> void:
	await open_lesson(_IMPOSSIBLE)
	assert_push_error("The radius must not be -1.")
	watch_signals(frame())
	frame().follow_link("#no_such_lesson")
	assert_reads("There is no lesson “no_such_lesson”.")
	frame().follow_link("#normals?mistake=9")
	assert_signal_emitted_with_parameters(
		frame(), "other_lesson_wanted", [LessonIndex.find(&"normals")]
	)


func test_the_address_is_followed_by_every_lesson_also_by_one_that_cannot_start() -> void:
	for lesson: LessonInfo in [_STILL, _IMPOSSIBLE]:
		await open_lesson(lesson)
		assert_eq(WebPage._follower, frame().follow_link, lesson.id)
		screen().free()
	assert_push_error("The radius must not be -1.")


func test_good_news_does_not_look_like_a_refusal() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	var place := frame().get_node("%NoticePlace") as PanelContainer
	await student.enter(Screen.named(screen(), "x of a") as LineEdit, "abc")
	var of_refusal := place.get_theme_stylebox(&"panel")
	await student.press_key(KEY_ESCAPE)
	await student.press(&"lab_copy_link")
	assert_reads("✓ Copied: ")
	assert_ne(place.get_theme_stylebox(&"panel"), of_refusal)


func test_good_news_covers_no_board_and_a_refusal_covers_no_panel() -> void:
	for size: Vector2i in [Vector2i(1280, 720), Vector2i(800, 600), Vector2i(720, 1280)]:
		await resize(size)
		for lesson: LessonInfo in LessonIndex.lessons():
			await open_lesson(lesson)
			var place := frame().get_node("%NoticePlace") as Control
			var board := frame().get_node("%BoardPlace") as Control
			await student.press(&"lab_copy_link")
			var rect := place.get_global_rect()
			assert_true(place.visible)
			assert_false(rect.intersects(board.get_global_rect()), "%s at %s" % [lesson.id, size])
			assert_true(screen().get_global_rect().encloses(rect), "%s at %s" % [lesson.id, size])
			frame().follow_link("#no_such_lesson")
			await student.settle()
			rect = place.get_global_rect()
			assert_true(board.get_global_rect().encloses(rect), "%s at %s" % [lesson.id, size])
			screen().free()


func test_a_good_change_clears_the_refusal_of_the_one_before() -> void:
	for id: StringName in [&"dot_product", &"reflection"]:
		await open_lesson(LessonIndex.find(id))
		frame().lesson.noticed.emit("This is refused.")
		frame().lesson.services[&"formula"].emit_signal(&"number_entered", "ax", 2.0)
		assert_does_not_read("This is refused.")
		screen().free()


func test_the_back_button_leads_to_the_start_screen() -> void:
	await open_start_screen()
	await student.press_key(KEY_ENTER)
	await click_button("Back to the lessons")
	assert_null(frame())
	assert_eq(screen().scene_file_path, START_SCREEN)


func test_without_a_graphics_card_the_window_draws_with_eight_bits_a_color() -> void:
	var window := get_window()
	for is_on: bool in [true, false]:
		SoftwareDrawing.is_on = is_on
		assert_false(window.transparent_bg)
		await open_lesson(_STILL)
		assert_eq(window.transparent_bg, is_on)
		screen().free()
		assert_false(window.transparent_bg)


func test_where_nothing_listens_no_way_back_is_offered() -> void:
	await open_lesson(_STILL)
	assert_null(Screen.button(screen(), "Back to the lessons"))
	assert_false(_help().contains("Esc"), _help())


func test_going_back_and_forth_leaves_nothing_behind() -> void:
	await _go_back_and_forth()
	var nodes := Performance.get_monitor(Performance.OBJECT_NODE_COUNT)
	var resources := Performance.get_monitor(Performance.OBJECT_RESOURCE_COUNT)
	var objects := Performance.get_monitor(Performance.OBJECT_COUNT)
	for round_trip: int in _ROUND_TRIPS:
		await _go_back_and_forth()
	assert_eq(Performance.get_monitor(Performance.OBJECT_NODE_COUNT), nodes)
	assert_eq(Performance.get_monitor(Performance.OBJECT_RESOURCE_COUNT), resources)
	var growth := Performance.get_monitor(Performance.OBJECT_COUNT) - objects
	assert_lt(growth, _ROUND_TRIPS / 2.0, "the test runner's own objects come and go")
	assert_eq(Node.get_orphan_node_ids(), [] as Array[int])


func test_the_help_names_the_keys_of_the_frame_and_of_the_services_brought() -> void:
	await open_lesson(_CLOCK)
	for part: String in ["R reset", "Ctrl+Z undo", "Tab next part", "P play or pause"]:
		assert_true(_help().contains(part), part)
	assert_false(_help().contains("step"), "no steps, no help for them")


func test_the_help_shows_a_binding_as_it_is_now() -> void:
	var old := InputMap.action_get_events(&"lab_reset")
	var key := InputEventKey.new()
	key.physical_keycode = KEY_F5
	InputMap.action_erase_events(&"lab_reset")
	InputMap.action_add_event(&"lab_reset", key)
	await open_lesson(_STILL)
	assert_true(_help().contains("F5 reset"), _help())
	InputMap.action_erase_events(&"lab_reset")
	for event: InputEvent in old:
		InputMap.action_add_event(&"lab_reset", event)


func test_the_help_names_the_gamepads_buttons_once_one_is_pressed() -> void:
	await open_start_screen()
	await student.press_key(KEY_ENTER)
	await student.press_pad(JOY_BUTTON_DPAD_DOWN)
	assert_true(_help().contains("B back"), _help())
	assert_true(_help().contains("Y reset"), _help())
	await student.press_key(KEY_F9)
	assert_true(_help().contains("Esc back"), _help())


func _go_back_and_forth() -> void:
	await open_start_screen()
	await student.press_key(KEY_ENTER)
	await student.press(&"lab_back")
	screen().free()
	await student.settle()


func _services() -> Array[Node]:
	return frame().get_node("%Services").get_children()


func _help() -> String:
	return (frame().get_node("%Help") as Label).text.replace("\u00a0", " ")
