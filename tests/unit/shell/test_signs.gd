extends LabTest
## All texts of the lab can be written without the system's fonts: a browser provides none.

# Nothing is drawn for it: it keeps a line together.
const _JOINER := 0x2060
const _ESCAPED := "\\\\u([0-9a-f]{4})"


func test_every_character_is_in_the_engines_font_or_among_the_signs() -> void:
	Signs.add_to_font()
	var lent: Dictionary[String, String] = {}
	var seen: Dictionary[String, bool] = {}
	for file: String in _written():
		for character in _text(file):
			seen[character] = true
			if not _has(character):
				lent[character] = file
	assert_eq(lent, {} as Dictionary[String, String])
	for sign_of_ours: String in ["✓", "✗", "←", "↓"]:
		assert_true(seen.has(sign_of_ours), sign_of_ours + " was read")


func test_the_signs_are_needed_and_others_would_be_found() -> void:
	ThemeDB.fallback_font.fallbacks = []
	assert_false(_has("✓"))
	Signs.add_to_font()
	assert_true(_has("✓"))
	assert_false(_has("☃"))


func _has(character: String) -> bool:
	var code := character.unicode_at(0)
	if code < 32 or code == _JOINER or ThemeDB.fallback_font.has_char(code):
		return true
	return ThemeDB.fallback_font.fallbacks.any(func(font: Font) -> bool: return font.has_char(code))


func _written() -> PackedStringArray:
	return (
		SourceCode.files_below("res://scenes", ["gd", "tscn", "tres"])
		+ SourceCode.files_below("res://scripts", ["gd"])
	)


func _text(file: String) -> String:
	var text := FileAccess.get_file_as_string(file)
	if file.ends_with(".gd"):
		text = SourceCode.without_comments(text)
	for hit in RegEx.create_from_string(_ESCAPED).search_all(text):
		text += String.chr(hit.get_string(1).hex_to_int())
	return text
