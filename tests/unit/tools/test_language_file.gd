extends LabTest
## Languages in gettext's form: written, read, cut down for a pack.

const CollectTexts := preload("res://tools/texts/collect_texts.gd")
const LanguageFile := preload("res://tools/texts/language_file.gd")
const LeanExport := preload("res://tools/export/lean_export.gd")

const _FILE := "user://language_file_in_test.po"


func after_each() -> void:
	DirAccess.remove_absolute(_FILE)


func test_what_is_written_is_read_again() -> void:
	FileAccess.open(_FILE, FileAccess.WRITE).store_string(_language().text())
	var read := LanguageFile.new(_FILE)
	assert_eq(read.title, "A title")
	assert_eq(read.language, "eo")
	assert_eq(read.translations, _language().translations)
	assert_eq(read.places, _language().places)


func test_a_text_broken_into_lines_is_read_as_one() -> void:
	var text := _language().text().replace('"Undo"', '""\n"Un"\n"do"')
	FileAccess.open(_FILE, FileAccess.WRITE).store_string(text)
	assert_has(LanguageFile.new(_FILE).translations, "Undo")


func test_the_engine_has_what_is_written() -> void:
	FileAccess.open(_FILE, FileAccess.WRITE).store_string(_language().text())
	var read: Translation = ResourceLoader.load(_FILE, "", ResourceLoader.CACHE_MODE_IGNORE)
	for language: Translation in [read, _language().translation()]:
		assert_eq(language.locale, "eo")
		for message: String in ["Undo", 'a “b”\n"c" \\ d', "ĉu"]:
			assert_eq(str(language.get_message(message)), _language().translations[message])


func test_a_pack_has_the_texts_of_its_own_files_only() -> void:
	var language := LeanExport.language_of(["res://scenes/b.gd"], _language())
	assert_eq(language.get_message_list(), PackedStringArray(["Undo"]))


func test_an_update_keeps_what_is_shown_drops_the_rest_and_adds_what_is_new() -> void:
	var found: Dictionary[String, PackedStringArray] = {
		"New": PackedStringArray(["scenes/c.gd"]), "Undo": PackedStringArray(["scenes/c.gd"])
	}
	var updated := CollectTexts.updated(_language(), found)
	assert_eq(updated.translations, {"New": "", "Undo": "Malfari"} as Dictionary[String, String])
	assert_eq(updated.places, found)


func _language() -> LanguageFile:
	var language := LanguageFile.new()
	language.title = "A title"
	language.language = "eo"
	language.translations = {
		"Undo": "Malfari", 'a “b”\n"c" \\ d': 'ŭ "x"\n', "ĉu": "ĉu ne", "Not yet": ""
	}
	for message: String in language.translations:
		language.places[message] = PackedStringArray(["scenes/a.gd"])
	language.places["Undo"].append("scenes/b.gd")
	return language
