extends ScreenTest
## The student chooses a language, in the menu, on the start screen or by a key; it is kept.

const _LESSON := &"dot_product"


func before_each() -> void:
	super()
	TranslationServer.set_locale("en")


func after_each() -> void:
	await super()
	TranslationServer.set_locale("en")


func test_a_key_changes_the_language_of_the_lesson_and_keeps_board_and_step() -> void:
	await open_start_screen()
	Navigation.open_lesson(get_tree(), LessonIndex.find(_LESSON))
	await student.settle()
	await go_to_step(2)
	await student.press(&"lab_language")
	await student.settle()
	assert_reads("Stap 3 van")
	assert_eq(frame().lesson.step, 2)
	await student.press(&"lab_language")
	await student.settle()
	assert_reads("Step 3 of")


func test_a_button_of_the_start_screen_changes_the_language() -> void:
	await open_start_screen()
	await click_button("Nederlands")
	await student.settle()
	assert_reads("Vectoren en botsingen die je kunt aanraken")
	assert_not_null(Screen.button(screen(), "English"))


func test_the_choice_is_kept() -> void:
	await open_start_screen()
	await click_button("Nederlands")
	screen().free()
	TranslationServer.set_locale("en")
	await open_lesson(LessonIndex.find(_LESSON))
	assert_reads("Stap 1 van")
