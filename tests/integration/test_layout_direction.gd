extends ScreenTest
## Formulas and layout run from left to right, also on a system whose language runs the other way.

const _LANGUAGES: PackedStringArray = ["he_IL", "ar_EG", "fa_IR", "en"]

var _language := ""


func before_all() -> void:
	super()
	_language = TranslationServer.get_locale()


func after_all() -> void:
	TranslationServer.set_locale(_language)


func test_formulas_and_panel_run_from_left_to_right_in_every_language() -> void:
	for language: String in _LANGUAGES:
		TranslationServer.set_locale(language)
		await open_lesson(LessonIndex.find(&"dot_product"))
		assert_false(screen().is_layout_rtl(), language)
		var line := frame().lesson.services[&"formula"].get_child(0)
		var places: PackedFloat64Array = []
		for part: Control in line.get_children():
			places.append(part.global_position.x)
		var sorted := places.duplicate()
		sorted.sort()
		assert_gt(places.size(), 5)
		assert_eq(places, sorted, language)
		assert_gt((frame().get_node("%Panel") as Control).global_position.x, 640.0, language)
		screen().free()
