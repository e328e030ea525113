class_name WorkshopTogether
extends RefCounted
## Several files of a student as one text: each becomes a class inside it, under another name,
## because the editor may know the class by its own.

const _HIS_NAMES := r"\bMy(Vec2|Line|Impact|Bounce|Aim)\b"
const _NAMES_INSIDE := r"\bJudged(Vec2|Line|Impact|Bounce|Aim)\b"
const _CLASS_NAME := r"(?m)^class_name[ \t]+\w+"

## The whole text.
var text := ""

# For each file the line of the text before its first one.
var _offsets: Dictionary[String, int] = {}


## Begins with [param outer], which stays outside of the classes.
func _init(outer: String) -> void:
	text = _renamed(outer) + "\n"


## Adds a file as a class.
func add(file: String, its_text: String) -> void:
	var of_class: String = WorkshopFiles.CLASSES[file]
	text += "class %s:\n" % inside(of_class)
	_offsets[file] = text.count("\n")
	var bare := RegEx.create_from_string(_CLASS_NAME).sub(_renamed(its_text), "")
	for line in with_tabs(bare).split("\n"):
		text += ("\t" + line.strip_edges(false, true) if line.strip_edges() else "") + "\n"
	text += "\tpass\n"


## The line in a file for a line of the whole text; that of the outer text stays as it is.
func line_in(file: String, line: int) -> int:
	return line - _offsets.get(file, 0)


## The name of a student's class inside the text.
static func inside(of_class: String) -> String:
	return _renamed(of_class)


## A message of the engine with the student's own names.
static func with_his_names(message: String) -> String:
	return RegEx.create_from_string(_NAMES_INSIDE).sub(message, "My$1", true)


static func _renamed(his_text: String) -> String:
	return RegEx.create_from_string(_HIS_NAMES).sub(his_text, "Judged$1", true)


## Each step of indentation as a tab, for a text that is indented with spaces.
static func with_tabs(his_text: String) -> String:
	var step := 0
	for line in his_text.split("\n"):
		var spaces := line.length() - line.lstrip(" ").length()
		if line.strip_edges() and spaces > 0 and (step == 0 or spaces < step):
			step = spaces
	if step == 0:
		return his_text
	var lines: PackedStringArray = []
	for line in his_text.split("\n"):
		var bare := line.lstrip(" ")
		@warning_ignore("integer_division")
		lines.append("\t".repeat((line.length() - bare.length()) / step) + bare)
	return "\n".join(lines)
