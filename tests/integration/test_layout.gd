extends ScreenTest
## Nothing overlaps, is cut off, is too small or moves by itself, at every size, with larger text
## and with longer texts, at each step, in many states and while a lesson plays.

const MeasureLayout := preload("res://tools/checks/measure_layout.gd")
## The states that are looked at besides the start: more by `./lab layout --states`.
const _STATES := 3
## The sizes at which each step and these states are looked at; at the others the last step.
const _WITH_STATES: Array[Vector2i] = [Vector2i(390, 844), Vector2i(1280, 720)]
## Lessons that do not fit on a phone with text of the largest size: the one draws five boards side
## by side, in the second a line of running numbers needs a row more after a while, the third tells
## a number of 16 digits.
const _TOO_NARROW: Array[StringName] = [&"line_ends", &"easy_bounce", &"projection_proof"]
## In Dutch a name on the plot of the fourth is one long word.
const _TOO_NARROW_IN_DUTCH: Array[StringName] = [
	&"line_ends", &"easy_bounce", &"projection_proof", &"error_and_time"
]
const _NONE: Array[StringName] = []
## The sizes at which text is larger, and texts are longer.
const _OTHERS: Array[Vector2i] = [Vector2i(390, 844), Vector2i(844, 390), Vector2i(1280, 720)]


func before_each() -> void:
	super()
	# What it adds is looked at with files of its own, in test_desk_layout.gd.
	WorkshopChild.is_allowed = false


func after_each() -> void:
	WorkshopChild.is_allowed = true
	_lengthen_texts(0.0)
	TranslationServer.pseudolocalization_enabled = false
	await super.after_each()


func test_the_start_screen_fits_at_every_size() -> void:
	await open_start_screen()
	for size: Vector2i in MeasureLayout.SIZES:
		await resize(size)
		await _assert_fits("start screen at %s" % size)


func test_every_lesson_fits_at_every_size_at_each_step_and_while_it_plays(
	size: Vector2i = use_parameters(MeasureLayout.SIZES)
) -> void:
	# Whoever waits for a silent program ends it.
	gut.p("%dx%d" % [size.x, size.y])
	await resize(size)
	await _survey_all(size, _STATES if size in _WITH_STATES else 0)


func test_every_lesson_fits_with_large_text() -> void:
	KeptChoices.keep("text_size", WindowFit.TEXT_SIZES[-1])
	for size: Vector2i in [Vector2i(390, 844), Vector2i(1280, 720)]:
		await resize(size)
		await _survey_all(size, 0, _TOO_NARROW if size.x < size.y else _NONE)


func test_every_lesson_fits_in_dutch_on_a_phone_with_text_of_each_size() -> void:
	LabText.speak("nl")
	await resize(_OTHERS[0])
	for text in WindowFit.TEXT_SIZES:
		KeptChoices.keep("text_size", text)
		await _survey_all(_OTHERS[0], 0, _TOO_NARROW_IN_DUTCH if text > 1.0 else _NONE)


func test_the_ways_to_other_lessons_go_where_the_title_needs_their_room() -> void:
	for text in WindowFit.TEXT_SIZES:
		KeptChoices.keep("text_size", text)
		await resize(_OTHERS[0])
		Navigation.open_lesson(get_tree(), LessonIndex.find(&"dot_product"))
		await student.settle()
		var next := frame().get_node("%NextLesson") as Button
		assert_eq(next.visible, text == WindowFit.TEXT_SIZES[0])
		await go_to_step()
		var lessons := LessonAgenda.lessons()
		var behind := lessons[lessons.find(LessonIndex.find(&"dot_product")) + 1]
		await click_button("On to lesson %s" % LessonIndex.heading_of(behind))
		assert_eq(frame().lesson_info.id, behind.id)
		screen().free()


func test_every_lesson_fits_in_radians_turned_over() -> void:
	for choice: Conventions.Choice in Conventions.Choice.values():
		Conventions.choose(choice, true)
	for size: Vector2i in _WITH_STATES:
		await resize(size)
		await _survey_all(size, 0)


func test_the_question_unfolded_fits() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		for size: Vector2i in _OTHERS:
			await resize(size)
			var text := "%s at %s" % [lesson.id, size]
			_assert_panel_shows_all_in_a_large_window(text)
			await _fold_question(false)
			await _assert_fits(text + ", unfolded")
			await _fold_question(true)
		screen().free()


func test_what_is_too_small_broken_or_moving_is_found() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	var survey := LayoutSurvey.new()
	var services := frame().get_node("%Services") as Control
	var button := Button.new()
	button.add_theme_font_size_override(&"font_size", 9)
	button.text = "x"
	services.add_child(button)
	var label := Label.new()
	label.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	label.text = "w".repeat(60)
	services.add_child(label)
	services.move_child(label, 0)
	var transport := frame().lesson.services[&"transport"] as Transport
	transport.advanced.connect(func(_seconds: float) -> void: label.custom_minimum_size.y += 40.0)
	await survey.look_at(frame(), "a spoilt lesson", 0)
	var found := "\n".join(survey.problems.keys())
	assert_string_contains(found, "Button of Services is a target of ")
	assert_string_contains(found, "Button of Services is a text of 9.0 px")
	assert_string_contains(found, "w” is broken inside")
	assert_string_contains(found, "Transport moves while it plays")


func test_all_fits_with_longer_texts_too() -> void:
	TranslationServer.pseudolocalization_enabled = true
	_lengthen_texts(0.3)
	await test_the_start_screen_fits_at_every_size()
	screen().free()
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		for size: Vector2i in _OTHERS:
			await resize(size)
			await _assert_fits("%s at %s" % [lesson.id, size])
		screen().free()


func test_a_tall_window_has_the_board_above_the_panel() -> void:
	await open_lesson(LessonIndex.lessons()[0])
	await resize(Vector2i(720, 1280))
	var board := frame().lesson.get_global_rect()
	var panel := (frame().get_node("%Panel") as Control).get_global_rect()
	assert_gte(panel.position.y, board.end.y)
	assert_gte(board.size.x, 700.0)


func test_a_button_in_the_head_keeps_its_height_beside_a_title_of_three_lines() -> void:
	await open_lesson(LessonIndex.find(&"more_dimensions"))
	await resize(Vector2i(720, 1280))
	var title := frame().get_node("%Title") as Label
	title.text = "11\nThree dimensions\nand four"
	await student.settle()
	assert_gt(title.size.y, 60.0)
	for button: Button in title.get_parent().find_children("*", "Button", false, false):
		assert_eq(button.size.y, button.get_combined_minimum_size().y, button.name)


# What is measured by itself may just have been told in more lines: containers follow a frame later.
func _assert_fits(text: String) -> void:
	if Layout.problems(screen()):
		await student.settle()
	assert_eq(", ".join(Layout.problems(screen())), "", text)


# In a window of the usual size or more; in a smaller one the panel scrolls.
func _assert_panel_shows_all_in_a_large_window(text: String) -> void:
	var bar := (frame().get_node("%Panel") as ScrollContainer).get_v_scroll_bar()
	if frame().size.x >= WindowFit.USUAL.x:
		assert_lte(bar.max_value, bar.page, text)


func _survey_all(size: Vector2i, state_count: int, without: Array[StringName] = _NONE) -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		if lesson.id in without:
			continue
		# With the ways to the other lessons in the top bar.
		Navigation.open_lesson(get_tree(), lesson)
		await student.settle()
		var survey := LayoutSurvey.new()
		var where := "%s at %s" % [lesson.id, size]
		await survey.look_at(frame(), where, state_count, state_count > 0)
		assert_true(survey.problems.is_empty(), str(survey.problems))
		screen().free()


func _fold_question(folded: bool) -> void:
	for control: Control in Screen.controls(screen()):
		if control is FoldableContainer:
			(control as FoldableContainer).folded = folded
	await student.settle()


# Texts are shown with foreign letters and this share longer: translations are often 30 % longer.
func _lengthen_texts(share: float) -> void:
	ProjectSettings.set_setting("internationalization/pseudolocalization/expansion_ratio", share)
	TranslationServer.reload_pseudolocalization()
