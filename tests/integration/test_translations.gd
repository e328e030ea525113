extends ScreenTest
## Every text goes through Godot's translation, and one file holds them all.

const CollectTexts := preload("res://tools/texts/collect_texts.gd")
## A language that is not the one of the machine that runs the tests.
const _LOCALE := "eo"
const _OPEN := "‹"
const _CLOSE := "›"
## Words that are the same in every language, besides what is printed on keys: symbols of the
## formulas, code, and the name of a language.
const _SYMBOLS := "px py nx ny bx by ac cos sin atan log POI old new now gap"
const _CODE := "English GDScript Vec Vector copy position value normal bounce reflect slide"
## Actions of the engine that a help line names, besides the lab's own.
const _ENGINE_ACTIONS: Array[StringName] = [&"ui_focus_next", &"ui_home", &"ui_end", &"ui_accept"]

var _old_locale := ""
var _language: Translation


func after_each() -> void:
	if _language:
		TranslationServer.remove_translation(_language)
		TranslationServer.set_locale(_old_locale)
		_language = null
	await super.after_each()


func test_the_template_holds_every_text_and_nothing_else() -> void:
	var text := FileAccess.get_file_as_string(CollectTexts.FILE)
	var hint := "run: godot --headless --path . -s tools/texts/collect_texts.gd"
	assert_true(text == CollectTexts.template(), hint)


func test_no_text_of_the_start_screen_is_left_in_english() -> void:
	_speak_another_language()
	await open_start_screen()
	screen().call(&"open_requested", "no_such_lesson")
	_assert_nothing_in_english("start screen")


func test_no_text_of_a_lesson_is_left_in_english() -> void:
	_speak_another_language()
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		for control: Control in Screen.controls(screen()):
			if control is FoldableContainer:
				(control as FoldableContainer).folded = false
		await student.settle()
		_assert_nothing_in_english(lesson.id)
		for step: int in 8:
			await student.press(&"lab_previous_step")
			_assert_nothing_in_english("%s, a step back" % lesson.id)
		screen().free()


func test_no_situation_of_a_lesson_brings_english_back() -> void:
	_speak_another_language()
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		for button: Button in _buttons_of_situations():
			await student.click(button)
			_assert_nothing_in_english("%s after %s" % [lesson.id, button.text])
		screen().free()


func test_a_file_in_gettexts_form_is_read_as_a_language() -> void:
	var path := "user://eo.po"
	var content := CollectTexts.template().replace(
		'msgid "Undo"\nmsgstr ""', 'msgid "Undo"\nmsgstr "Malfari"'
	)
	FileAccess.open(path, FileAccess.WRITE).store_string(content)
	var language := load(path) as Translation
	DirAccess.remove_absolute(path)
	assert_eq(str(language.get_message("Undo")), "Malfari")


# Finds them all before the first click, which may change what is in the panel.
func _buttons_of_situations() -> Array[Button]:
	var found: Array[Button] = []
	for control: Control in Screen.controls(frame().get_node("%Services")):
		var is_button := control is Button and control is not OptionButton
		if is_button and control.get_parent() is HFlowContainer:
			found.append(control as Button)
	return found


# A language in which every known text is in brackets.
func _speak_another_language() -> void:
	_old_locale = TranslationServer.get_locale()
	_language = Translation.new()
	_language.locale = _LOCALE
	for message: String in CollectTexts.messages():
		_language.add_message(message, _OPEN + message + _CLOSE)
	TranslationServer.add_translation(_language)
	TranslationServer.set_locale(_LOCALE)


func _assert_nothing_in_english(place: String) -> void:
	var left: Array[String] = []
	for text: String in _shown_texts():
		if _untranslated_words(text) and not text in left:
			left.append(text)
	assert_eq(left, [] as Array[String], place)


func _shown_texts() -> PackedStringArray:
	var found: PackedStringArray = []
	for control: Control in Screen.controls(screen()):
		if control.get_parent() is LessonCode:
			continue
		if control is Formula:
			found.append_array(Screen.lines(control as Formula))
		elif not control.get_parent().get_parent() is Formula:
			found.append(Screen.text_of(control))
		found.append(control.accessibility_name)
		found.append(_tooltip_of(control))
	for node: Node in screen().find_children("*", "Node2D", true, false):
		if node is Arrow and (node as Arrow).is_visible_in_tree():
			found.append(node.atr((node as Arrow).label))
	return found + _items_of_lists()


func _items_of_lists() -> PackedStringArray:
	var found: PackedStringArray = []
	for control: Control in Screen.controls(screen()):
		if control is OptionButton:
			var list := control as OptionButton
			for item: int in list.item_count:
				found.append(list.atr(list.get_item_text(item)))
	return found


func _tooltip_of(control: Control) -> String:
	var is_always := control.tooltip_auto_translate_mode == Node.AUTO_TRANSLATE_MODE_ALWAYS
	return tr(control.tooltip_text) if is_always else control.atr(control.tooltip_text)


func _untranslated_words(text: String) -> PackedStringArray:
	var inner := RegEx.create_from_string("%s[^%s%s]*%s" % [_OPEN, _OPEN, _CLOSE, _CLOSE])
	while inner.search(text):
		text = inner.sub(text, "", true)
	var found: PackedStringArray = []
	var known := (_SYMBOLS + " " + _CODE).split(" ") + _words_on_keys()
	for word: RegExMatch in RegEx.create_from_string("\\p{L}{2,}").search_all(text):
		if not word.get_string() in known:
			found.append(word.get_string())
	return found


func _words_on_keys() -> PackedStringArray:
	var found: PackedStringArray = ["Esc"]
	for action: StringName in InputMap.get_actions():
		if not action.begins_with("lab_") and not action in _ENGINE_ACTIONS:
			continue
		for event: InputEvent in InputMap.action_get_events(action):
			found.append_array(event.as_text().replace("+", " ").split(" "))
	return found
