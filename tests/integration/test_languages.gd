extends LabTest
## Every language is complete: each text has its translation, with the same places for values, and
## is no copy of the English.

const CollectTexts := preload("res://tools/texts/collect_texts.gd")
const LanguageFile := preload("res://tools/texts/language_file.gd")

## What stands for a value: it comes in the same order in both.
const _VALUE := "%[sd%]|%\\.\\d+f|\\{\\w+\\}"
## Texts of at most so many letters stand where there is little room: on buttons, in tables, on
## boards.
const _SHORT := 14
## They may be longer by so many letters, longer ones by this share.
const _MORE_LETTERS := 10
const _MORE := 1.5

## Texts that may be equal in a language, besides what holds nothing but code and symbols.
const SAME: Dictionary[String, PackedStringArray] = {
	"nl":
	[
		"old",
		"frame",
		"Frame %s:",
		"In pixels",
		"ax",
		"ay",
		"bx = 8",
		"by = −6",
		"gap 70",
		"gap %s",
		"gap =",
		"new",
		"reset",
		"POI",
		"23.5 px",
		"0 px",
		"123 px",
		"%s px/s",
		"atan2(x, y)",
		"Over 180°",
		"half",
		"old = POI",
		"old 50",
		"old %s",
		"new −30",
		"new %s",
		"open",
		"frame {frame}     {distance} − {frame}·{speed_value} = {flown}",
		"cos α = a · b / (|a| |b|)",
		"10 px",
		"38 px",
		"72 px",
		"500 px",
		"%s ns",
		"%s px",
		"v in",
		"Vector2",
		"Godot",
		"%s µs",
		"overlap: t = 0",
		"Overlap",
		"%s ms",
		"%s px/s, %s s",
		"%s Hz",
		"RigidBody2D",
		"RigidBody2D, CCD ray",
		"Vec2 Lab",
		"Stop",
		"Check",
		"Slow motion",
	]
}


func test_every_text_has_its_translation(path: String = use_parameters(_languages())) -> void:
	var language := LanguageFile.new(path)
	assert_eq(language.translations.keys(), CollectTexts.messages().keys(), _hint())
	for message: String in language.translations:
		assert_ne(language.translations[message], "", "“%s” in %s" % [message, path.get_file()])


func test_values_stand_in_the_same_order(path: String = use_parameters(_languages())) -> void:
	var language := LanguageFile.new(path)
	for message: String in language.translations:
		var translation := language.translations[message]
		assert_eq(_values_in(translation), _values_in(message), message)
		assert_eq(translation.count("\n"), message.count("\n"), message)


func test_no_translation_is_a_copy(path: String = use_parameters(_languages())) -> void:
	var language := LanguageFile.new(path)
	var copies: PackedStringArray = []
	for message: String in language.translations:
		if language.translations[message] == message:
			copies.append(message)
	var allowed := SAME[language.language]
	assert_eq(_without(copies, allowed), PackedStringArray(), "copied")
	assert_eq(_without(allowed, copies), PackedStringArray(), "allowed for nothing")


func test_no_translation_is_too_long(path: String = use_parameters(_languages())) -> void:
	var language := LanguageFile.new(path)
	for message: String in language.translations:
		var most := message.length() * _MORE
		if message.length() <= _SHORT:
			most = message.length() + _MORE_LETTERS
		assert_lte(language.translations[message].length(), int(most), message)


func test_the_lab_speaks_every_language_in_the_folder() -> void:
	for path: String in _languages():
		assert_has(LabText.languages(), LanguageFile.new(path).language)


func _languages() -> Array:
	return Array(CollectTexts.languages())


func _hint() -> String:
	return "run: godot --headless --path . -s tools/texts/collect_texts.gd"


func _values_in(text: String) -> PackedStringArray:
	var found: PackedStringArray = []
	for hit: RegExMatch in RegEx.create_from_string(_VALUE).search_all(text):
		found.append(hit.get_string())
	return found


func _without(texts: PackedStringArray, others: PackedStringArray) -> PackedStringArray:
	var left: PackedStringArray = []
	for text: String in texts:
		if not text in others:
			left.append(text)
	return left
