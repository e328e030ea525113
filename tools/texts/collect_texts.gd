extends SceneTree
## Collects every text that the lab shows into assets/translations/lab.pot, in gettext's form, and
## brings the languages beside it up to date: what is still shown keeps its translation, what is new
## has none, what is gone goes.
## Usage: godot --headless --path . -s tools/texts/collect_texts.gd
##
## Taken are, from scripts: literals in tr("...") and in calls whose name ends in "translate", and
## the texts in a declaration whose comment says "source text"; from scenes: the properties named
## below; from lessons: title and summary. Symbols such as "a" or "+" are the same in all languages.
## What a student writes in the workshop, and the starters of it, are no texts of the lab.

const LanguageFile := preload("language_file.gd")

const FILE := "res://assets/translations/lab.pot"

const _FOLDERS: PackedStringArray = ["res://scenes", "res://scripts", "res://workshop"]
const _OF_STUDENT := "^res://workshop/(?:starters/)?(?:test_)?my_"
## And those whose name ends in "_title".
const _SCENE_PROPERTIES: PackedStringArray = [
	"text", "title", "label", "tooltip_text", "placeholder_text", "accessibility_name"
]
const _LITERAL := '"((?:[^"\\\\]|\\\\.)*)"'
const _CALL := "\\b(?:tr|\\w*translate)\\(\\s*" + _LITERAL
const _SOURCE_TEXT := "source text"
# A message has two letters side by side somewhere.
const _WORD := "\\p{L}{2}"
const _TITLE := "Every text that Vec2 Lab shows. Made by tools/texts/collect_texts.gd."


func _init() -> void:
	var found := messages()
	FileAccess.open(FILE, FileAccess.WRITE).store_string(template())
	print("%d texts in %s" % [found.size(), FILE.trim_prefix("res://")])
	for language in languages():
		var file := updated(LanguageFile.new(language), found)
		FileAccess.open(language, FileAccess.WRITE).store_string(file.text())
		var missing := file.translations.values().count("")
		print("%d of them are not in %s" % [missing, language.get_file()])
	quit()


## The template as it has to be now.
static func template() -> String:
	var file := LanguageFile.new()
	file.title = _TITLE
	file.language = "en"
	return updated(file, messages()).text()


## The files of all languages but English.
static func languages() -> PackedStringArray:
	var found: PackedStringArray = []
	for file in DirAccess.get_files_at(FILE.get_base_dir()):
		if file.get_extension() == "po":
			found.append(FILE.get_base_dir().path_join(file))
	return found


## A language with exactly the texts [param found], as [method messages] returns them.
static func updated(
	file: LanguageFile, found: Dictionary[String, PackedStringArray]
) -> LanguageFile:
	var new_file := LanguageFile.new()
	new_file.title = file.title
	new_file.language = file.language
	for message in found:
		new_file.translations[message] = file.translations.get(message, "")
		new_file.places[message] = found[message]
	return new_file


## Every text with the files that show it, in the order in which they are found.
static func messages() -> Dictionary[String, PackedStringArray]:
	var found: Dictionary[String, PackedStringArray] = {}
	for folder in _FOLDERS:
		for path in _files_below(folder):
			for text in _texts_in(path):
				_add(found, text, path.trim_prefix("res://"))
	return found


static func _add(found: Dictionary[String, PackedStringArray], text: String, file: String) -> void:
	if not RegEx.create_from_string(_WORD).search(text):
		return
	var files: PackedStringArray = found.get(text, PackedStringArray())
	if not file in files:
		files.append(file)
	found[text] = files


static func _texts_in(path: String) -> PackedStringArray:
	if RegEx.create_from_string(_OF_STUDENT).search(path):
		return []
	match path.get_extension():
		"gd":
			return _texts_in_script(FileAccess.get_file_as_string(path))
		"tscn":
			return _texts_in_scene((load(path) as PackedScene).get_state())
		"tres":
			var lesson := load(path) as LessonInfo
			if lesson:
				return [lesson.title, lesson.summary]
	return []


static func _texts_in_script(source: String) -> PackedStringArray:
	var found := _literals(source, _CALL)
	var comment := ""
	for line in source.split("\n"):
		if line.begins_with("#"):
			comment += line.trim_prefix("##").trim_prefix("#")
		elif not line:
			comment = ""
		elif comment.contains(_SOURCE_TEXT):
			found.append_array(_literals(line, "&?" + _LITERAL))
	return found


static func _literals(source: String, pattern: String) -> PackedStringArray:
	var found: PackedStringArray = []
	for hit in RegEx.create_from_string(pattern).search_all(source):
		var text: String = str_to_var('"%s"' % hit.get_string(1))
		# A name such as &"lab_back" is no text.
		if not hit.get_string().begins_with("&"):
			found.append(text)
	return found


static func _texts_in_scene(state: SceneState) -> PackedStringArray:
	var found: PackedStringArray = []
	for node in state.get_node_count():
		for property in state.get_node_property_count(node):
			var title := state.get_node_property_name(node, property)
			var is_shown := title in _SCENE_PROPERTIES or title.ends_with("_title")
			if (
				is_shown
				and not (title in [&"text", &"title", &"label"] and _is_not_translated(state, node))
			):
				found.append(str(state.get_node_property_value(node, property)))
	return found


static func _is_not_translated(state: SceneState, node: int) -> bool:
	for property in state.get_node_property_count(node):
		if state.get_node_property_name(node, property) == &"auto_translate_mode":
			var mode: int = state.get_node_property_value(node, property)
			return mode == Node.AUTO_TRANSLATE_MODE_DISABLED
	return false


static func _files_below(folder: String) -> PackedStringArray:
	var found: PackedStringArray = []
	for file in DirAccess.get_files_at(folder):
		found.append(folder.path_join(file))
	for inner in DirAccess.get_directories_at(folder):
		found.append_array(_files_below(folder.path_join(inner)))
	return found
