extends RefCounted
## Begins a lesson as a copy of the smallest one: its folder, its test and its line in the index.

const _OLD := "smallest_lesson"
const _FOLDER := "scenes/lessons/%s"
const _TEST := "tests/integration/lessons/%s/test_%s.gd"
const _INDEX := "scenes/lessons/lesson_index.gd"
# Godot believes a uid before a path, so a copy must not have the uids of the scene and its script.
const _UIDS := '(?m)^(\\[gd_scene .*|\\[ext_resource type="Script") uid="[^"]*"(\\]| path=".*/%s)'
# What only the smallest lesson says of itself, and what its copy says instead; `%s` is the title.
const _TEXTS: Dictionary[String, String] = {
	'title = "The smallest lesson"': 'title = "%s"',
	": `./lab new_lesson` begins a lesson of your own as a copy": "",
	"## The smallest complete lesson: a vector": "## %s: a vector",
	"## `./lab new_lesson` begins a lesson of your own as a copy of this one.\n": "",
	"## The smallest lesson, with which others begin.": "## The lesson “%s”.",
}

## The id of the new lesson, such as `my_lesson`.
var id: String
## Its folder, such as `l13_my_lesson`: it is the last lesson of the index.
var folder: String


func _init(new_id: String) -> void:
	id = new_id
	folder = "l%02d_%s" % [LessonIndex.FOLDERS.size() + 1, id]


## "" if a new lesson can have this id; else one sentence with the id and what is allowed.
func problem() -> String:
	if not RegEx.create_from_string("^[a-z]+(_[a-z]+)*$").search(id):
		return "an id is small letters with _ between words, such as my_lesson, not '%s'" % id
	if LessonIndex.find(id):
		return "there is a lesson '%s' already" % id
	return ""


## The files of the new lesson, and the index with its line: texts by their paths in the project.
## The id must have no [method problem].
func files() -> Dictionary[String, String]:
	var found: Dictionary[String, String] = {}
	for file: String in ["lesson.tres", _OLD + ".gd", _OLD + ".tscn"]:
		var copied := (_FOLDER % folder).path_join(file.replace(_OLD, id))
		found[copied] = _renamed((_FOLDER % _OLD).path_join(file))
	found[_TEST % [id, id]] = _renamed(_TEST % [_OLD, _OLD])
	var last_line := '\t"%s",\n' % LessonIndex.FOLDERS[-1]
	var index := FileAccess.get_file_as_string("res://" + _INDEX)
	found[_INDEX] = index.replace(last_line, last_line + '\t"%s",\n' % folder)
	return found


## What the lesson is called until somebody finds a better title, such as `My lesson`.
func title() -> String:
	var words := id.replace("_", " ")
	return words[0].to_upper() + words.substr(1)


func _renamed(path: String) -> String:
	var text := FileAccess.get_file_as_string("res://" + path)
	text = RegEx.create_from_string(_UIDS % _OLD).sub(text, "$1$2", true)
	for old: String in _TEXTS:
		text = text.replace(old, _TEXTS[old].replace("%s", title()))
	text = text.replace(_FOLDER % _OLD, _FOLDER % folder)
	return text.replace(_OLD, id).replace(_OLD.to_pascal_case(), id.to_pascal_case())
