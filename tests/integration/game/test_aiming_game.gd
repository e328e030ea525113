extends ScreenTest
## Plays the game as a new player does: by mouse, by touch on a phone, by keys, and with helpers.

const _PHONE := Vector2i(390, 844)
# A level is won within so many seconds, or the bullet is gone.
const _LONGEST := 6.0

var _game: LessonInfo = LessonIndex.game()


func test_a_level_is_hit_by_dragging_and_pressing_fire() -> void:
	await open_lesson(_game)
	assert_reads("Drag to turn the barrel, then fire.")
	await _point_at(_model().target_place())
	await click_button("Fire")
	_let_fly()
	await student.settle()
	assert_reads("Hit with the first shot!")
	assert_reads("Level 1 of 7 · shots: 1")
	await click_button("Next level")
	assert_reads("It moves: aim where it will be.")
	assert_reads("Level 2 of 7 · shots: 0")


func test_a_miss_tells_by_how_much_and_the_player_fires_again() -> void:
	await open_lesson(_game)
	await _point_at(Vec2.new(390, 240))
	await click_button("Fire")
	_let_fly()
	await student.settle()
	assert_reads("Missed by 128 px.")
	await _point_at(_model().target_place())
	await click_button("Fire")
	_let_fly()
	await student.settle()
	assert_reads("Hit!")
	assert_reads("shots: 2")


func test_all_levels_are_hit_by_touch_on_a_phone_with_the_right_helpers() -> void:
	await open_lesson(_game)
	await resize(_PHONE)
	var needed: Dictionary[int, PackedStringArray] = {
		1: ["Aim"],
		2: ["Lead"],
		3: ["Gravity"],
		4: ["Bounce"],
		5: ["Gravity"],
		6: ["Lead", "Gravity"],
		7: ["Lead", "Bounce"],
	}
	for number: int in needed:
		assert_eq(_model().level_number, number)
		for helper: String in ["Lead", "Gravity", "Bounce"]:
			var is_on := (Screen.button(screen(), helper) as CheckButton).button_pressed
			if is_on != (helper in needed[number]):
				await _touch(Screen.button(screen(), helper))
		if not _model().aims:
			await _touch(Screen.button(screen(), "Aim"))
		# A moment at which the target does not turn back on the way.
		_model().advance(0.5)
		await _touch(Screen.button(screen(), "Fire"))
		_let_fly()
		await student.settle()
		assert_true(_model().is_won(), "level %d" % number)
		if number < needed.size():
			await _touch(Screen.button(screen(), "Next level"))
	assert_reads("All 7 levels hit with 7 shots! Now without Aim?")
	assert_not_null(Screen.button(screen(), "Play again"))


func test_on_a_phone_the_button_is_below_the_board_and_large_enough_for_a_thumb() -> void:
	await open_lesson(_game)
	await resize(_PHONE)
	var button := Screen.button(screen(), "Fire").get_global_rect()
	assert_gte(button.size.y, 60.0)
	assert_gte(button.position.y, frame().lesson.board.get_global_rect().end.y)
	assert_lte(button.end.y, float(_PHONE.y))
	await resize(Vector2i(1280, 720))
	var place := Screen.button(screen(), "Fire").get_global_rect()
	assert_true(frame().lesson.board.get_global_rect().encloses(place))


func test_on_a_phone_news_move_nothing_below_them() -> void:
	await resize(_PHONE)
	var before := TranslationServer.get_locale()
	for language: String in ["en", "nl"]:
		TranslationServer.set_locale(language)
		await open_lesson(_game)
		# Nobody else writes the news.
		frame().lesson.set_process(false)
		var news: Label = frame().lesson.get(&"_news")
		var place := Screen.button(screen(), "1").get_global_rect().position
		for words: String in [
			"The helper finds no way with one or two bounces.",
			"The target is faster than the bullet and gets away.",
			"All %d levels hit with %d shots! Now without Aim?",
		]:
			news.text = tr(words).replace("%d", "77")
			await student.settle()
			assert_eq(Screen.button(screen(), "1").get_global_rect().position, place, words)
		screen().free()
	TranslationServer.set_locale(before)


func test_a_bullet_that_has_hit_stays_where_both_touch() -> void:
	await open_lesson(_game)
	await _point_at(_model().target_place())
	await click_button("Fire")
	_let_fly()
	await student.settle()
	var bullet := frame().lesson.get_node("%Bullet") as BallView
	assert_true(bullet.visible)
	assert_almost_eq(bullet.at().distance_to(_model().target_place()), GameLevel.reach(), 1e-3)
	var trail := frame().lesson.get_node("%Trail") as FlightPath
	assert_almost_eq(trail.places[-1], bullet.center, Vector2(1e-3, 1e-3))
	assert_eq((frame().lesson.get_node("%Target") as TargetMark).role, Palette.Role.RIGHT)
	await click_button("Next level")
	assert_false(bullet.visible)
	assert_false(trail.visible)


func test_a_miss_shows_where_a_target_that_moves_was() -> void:
	await open_lesson(_game)
	var passed := frame().lesson.get_node("%Passed") as TargetMark
	await click_button("2")
	await _point_at(_model().target_place())
	await click_button("Fire")
	_let_fly()
	await student.settle()
	assert_true(passed.visible)
	assert_false(_model().is_won())
	assert_vec2(passed.at(), _model().missed.passed, 0.0)
	assert_gt(passed.at().distance_to(_model().target_place()), 1.0, "it has moved on")
	await click_button("1")
	assert_false(passed.visible)


func test_keys_turn_the_barrel_and_fire() -> void:
	await open_lesson(_game)
	var sight := frame().lesson.get_node("%Sight") as Control
	sight.grab_focus()
	var before := _model().hand_degrees
	await student.press_key(KEY_UP)
	assert_lt(_model().hand_degrees, before)
	await student.press_key(KEY_ENTER)
	assert_not_null(_model().shot)


func test_a_gamepad_fires() -> void:
	await open_lesson(_game)
	(frame().lesson.get_node("%Sight") as Control).grab_focus()
	await student.press_pad(JOY_BUTTON_A)
	assert_not_null(_model().shot)


func test_a_helper_that_finds_no_way_says_so() -> void:
	await open_lesson(_game)
	await click_button("Bounce")
	await student.settle()
	assert_reads("The helper finds no way with one or two bounces.")


func test_at_first_the_barrel_swings_until_somebody_does_anything() -> void:
	OpeningMotion.is_allowed = true
	await open_lesson(_game)
	OpeningMotion.is_allowed = false
	var swing := Callable(frame().lesson, &"_swing")
	swing.call(1.0, AimingGameModel.START_DEGREES)
	assert_eq(_model().hand_degrees, AimingGameModel.START_DEGREES + 25.0)
	await student.press_key(KEY_H)
	var stopped := _model().hand_degrees
	await get_tree().process_frame
	assert_eq(_model().hand_degrees, stopped)


func test_a_level_is_a_link() -> void:
	await open_lesson(_game)
	await click_button("4")
	assert_eq(frame().link.text(), "aiming_game?level=4")
	assert_eq(frame().link.open("level=6&leads=true"), "")
	assert_eq(_model().level_number, 6)
	assert_true(_model().leads)
	assert_string_contains(frame().link.open("level=0"), "level must be within 1..7, not 0.")


func test_undo_goes_back_to_the_level_before() -> void:
	await open_lesson(_game)
	await click_button("3")
	await student.press(&"lab_undo")
	assert_eq(_model().level_number, 1)


func test_its_card_on_the_start_screen_opens_it() -> void:
	await open_start_screen()
	var card: Button = null
	for button: Node in screen().find_children("*", "LessonCard", true, false):
		if (button as LessonCard).lesson.id == &"aiming_game":
			card = button as LessonCard
	assert_not_null(card)
	card.pressed.emit()
	await student.settle()
	assert_eq(frame().lesson_info.id, &"aiming_game")


func _model() -> AimingGameModel:
	return frame().lesson.get("_model")


# The barrel is turned by a drag on the empty board.
func _point_at(point: Vec2) -> void:
	var lesson := frame().lesson
	var transform := lesson.board.get_global_transform()
	var from := transform * lesson.board.to_screen(Vec2.new(200, 150))
	await student.drag(from, transform * lesson.board.to_screen(point))


func _touch(button: Control) -> void:
	var touch := InputEventScreenTouch.new()
	touch.position = button.get_global_rect().get_center()
	for is_down: bool in [true, false]:
		touch.pressed = is_down
		Input.parse_input_event(touch.duplicate() as InputEvent)
		await student.settle()


func _let_fly() -> void:
	for moment: int in roundi(_LONGEST * 60.0):
		if _model().shot:
			_model().advance(1.0 / 60.0)
