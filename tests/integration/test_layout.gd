extends ScreenTest
## Nothing overlaps, is cut off or shortened, at every size and with longer texts.

const _SIZES: Array[Vector2i] = [
	Vector2i(1280, 720), Vector2i(1920, 1080), Vector2i(800, 600), Vector2i(720, 1280)
]


func after_each() -> void:
	_lengthen_texts(0.0)
	TranslationServer.pseudolocalization_enabled = false
	await super.after_each()


func test_the_start_screen_fits_at_every_size() -> void:
	await open_start_screen()
	for size: Vector2i in _SIZES:
		await resize(size)
		_assert_fits("start screen at %s" % size)


func test_every_lesson_fits_at_every_size_with_its_question_folded_and_not() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		for size: Vector2i in _SIZES:
			await resize(size)
			var text := "%s at %s" % [lesson.id, size]
			_assert_fits(text)
			_assert_cards_apart(text)
			_assert_panel_shows_all_in_a_wide_window(text)
			await _fold_question(false)
			_assert_fits(text + ", unfolded")
			await _fold_question(true)
		screen().free()


func test_all_fits_with_longer_texts_too() -> void:
	TranslationServer.pseudolocalization_enabled = true
	_lengthen_texts(0.3)
	await test_the_start_screen_fits_at_every_size()
	screen().free()
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		for size: Vector2i in _SIZES:
			await resize(size)
			_assert_fits("%s at %s" % [lesson.id, size])
		screen().free()


func test_a_tall_window_has_the_board_above_the_panel() -> void:
	await open_lesson(LessonIndex.lessons()[0])
	await resize(Vector2i(720, 1280))
	var board := frame().lesson.get_global_rect()
	var panel := (frame().get_node("%Panel") as Control).get_global_rect()
	assert_gte(panel.position.y, board.end.y)
	assert_gte(board.size.x, 700.0)


func _assert_fits(text: String) -> void:
	assert_eq(", ".join(Layout.problems(screen())), "", text)


func _assert_panel_shows_all_in_a_wide_window(text: String) -> void:
	var bar := (frame().get_node("%Panel") as ScrollContainer).get_v_scroll_bar()
	if frame().size.x > frame().size.y:
		assert_lte(bar.max_value, bar.page, text)


# The cards on a board are its own Controls, apart from handles and from boards inside it.
func _assert_cards_apart(text: String) -> void:
	var board := frame().lesson
	var room := Rect2(Vector2.ZERO, board.size).grow(1.0)
	var cards: Array[Control] = []
	for child: Node in board.get_children():
		var is_card := child is Control and child is not Handle and child is not Board
		if is_card and (child as Control).visible:
			cards.append(child as Control)
	for i: int in cards.size():
		assert_true(room.encloses(cards[i].get_rect()), "%s of %s" % [cards[i].name, text])
		for j: int in i:
			var common := cards[i].get_rect().intersection(cards[j].get_rect())
			var names := "%s and %s of %s" % [cards[i].name, cards[j].name, text]
			assert_lte(minf(common.size.x, common.size.y), 1.0, names)


func _fold_question(folded: bool) -> void:
	for control: Control in Screen.controls(screen()):
		if control is FoldableContainer:
			(control as FoldableContainer).folded = folded
	await student.settle()


# Texts are shown with foreign letters and this share longer: translations are often 30 % longer.
func _lengthen_texts(share: float) -> void:
	ProjectSettings.set_setting("internationalization/pseudolocalization/expansion_ratio", share)
	TranslationServer.reload_pseudolocalization()
