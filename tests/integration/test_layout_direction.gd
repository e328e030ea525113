extends ScreenTest
## Formulas and layout run from left to right, also on a system whose language runs the other way.

const _LANGUAGES: PackedStringArray = ["he_IL", "ar_EG", "fa_IR", "en"]

var _language := ""
var _translation: Translation


func before_all() -> void:
	super()
	_language = TranslationServer.get_locale()


func after_all() -> void:
	TranslationServer.set_locale(_language)


func after_each() -> void:
	if _translation:
		TranslationServer.remove_translation(_translation)
		_translation = null
	await super()


func test_a_language_that_the_lab_does_not_know_is_english() -> void:
	for open: Callable in [open_start_screen, open_lesson.bind(LessonIndex.lessons()[0])]:
		for language: String in _LANGUAGES:
			TranslationServer.set_locale(language)
			await open.call()
			assert_eq(TranslationServer.get_locale(), "en", language)
			screen().free()


func test_in_a_language_from_right_to_left_formulas_still_run_from_left_to_right() -> void:
	_translation = Translation.new()
	_translation.locale = "he"
	_translation.add_message("Undo", "ביטול")
	TranslationServer.add_translation(_translation)
	TranslationServer.set_locale("he_IL")
	await open_lesson(LessonIndex.find(&"dot_product"))
	await go_to_step()
	assert_eq(TranslationServer.get_locale(), "he_IL")
	assert_false(screen().is_layout_rtl())
	for service: StringName in [&"formula", &"readout"]:
		var labels := frame().lesson.services[service].find_children("*", "Label", true, false)
		assert_gt(labels.size(), 8)
		for label: Label in labels:
			assert_eq(label.text_direction, Control.TEXT_DIRECTION_LTR, label.text)


func test_formulas_and_panel_run_from_left_to_right_in_every_language() -> void:
	for language: String in _LANGUAGES:
		TranslationServer.set_locale(language)
		await open_lesson(LessonIndex.find(&"dot_product"))
		assert_false(screen().is_layout_rtl(), language)
		var line := frame().lesson.services[&"formula"].get_child(0)
		var places: PackedFloat64Array = []
		for part: Control in Screen.controls(line).slice(1):
			places.append(part.global_position.x)
		var sorted := places.duplicate()
		sorted.sort()
		assert_gt(places.size(), 5)
		assert_eq(places, sorted, language)
		assert_gt((frame().get_node("%Panel") as Control).global_position.x, 640.0, language)
		screen().free()
