class_name WorkshopSentences
extends RefCounted
## Says in plain words what the engine says of a mistake in a student's code.

const _OPENERS: PackedStringArray = [
	"func", "static", "if", "elif", "else", "for", "while", "match", "class"
]
# How much two names must have in common to be taken for each other.
const _ALIKE := 0.5


## The line in which a colon is missing, from 1; 0 for none. The engine tells it a line late.
static func line_without_colon(text: String) -> int:
	var depth := 0
	var opened := 0
	var number := 0
	for line in text.split("\n"):
		number += 1
		var bare := _without_comment(line).strip_edges()
		if depth == 0:
			opened = number if _first_word(bare) in _OPENERS else 0
		depth = maxi(depth + _opened_in(bare), 0)
		if depth == 0 and opened > 0 and bare:
			if not _has_colon(bare) and not bare.ends_with("\\"):
				return opened
			opened = 0
	return 0


## The first line that is indented with spaces where others have tabs, or the other way round; 0 for
## none. Lines inside brackets do not count.
static func line_with_mixed_indent(text: String) -> int:
	var first := ""
	var depth := 0
	var number := 0
	for line in text.split("\n"):
		number += 1
		var bare := _without_comment(line).strip_edges()
		if depth == 0 and bare and line[0] in [" ", "\t"]:
			first = first if first else line[0]
			if line[0] != first:
				return number
		depth = maxi(depth + _opened_in(bare), 0)
	return 0


## One sentence for a mistake of form that the engine names with [param message]. [param names] are
## the names among which the right one may be.
static func of_form(message: String, names: PackedStringArray) -> String:
	message = message.trim_prefix("Parse Error: ").trim_prefix("Compile Error: ")
	var unknown := _captured(message, '(?:Identifier|type|Function|function) "(\\w+)(?:\\(\\))?"')
	if (
		unknown
		and (
			message.contains("not declared")
			or message.contains("not find")
			or message.contains("ot found")
		)
	):
		return unknown_name(unknown, names)
	if message.contains("Not all code paths return a value"):
		return LabText.translate("Not every way through the method ends with a return.")
	if message.contains('Unexpected "Indent"') or message.contains("Unindent doesn't match"):
		return LabText.translate("This line is not indented as those around it.")
	if message.contains("Expected indented block"):
		return LabText.translate("The lines that belong to the line above must be indented.")
	if message.contains("hides a global script class"):
		return LabText.translate(
			"The class name belongs to another class: leave the name as it was."
		)
	return LabText.translate("Godot says: %s") % message


## One sentence for a name that is not there, with the nearest one that is.
static func unknown_name(unknown: String, names: PackedStringArray) -> String:
	var nearest := nearest_to(unknown, names)
	if nearest:
		return LabText.translate("%s is not there: do you mean %s?") % [unknown, nearest]
	return LabText.translate("%s is not there: look at how it is written.") % unknown


## The name that is most like another one; "" where none is.
static func nearest_to(unknown: String, names: PackedStringArray) -> String:
	var nearest := ""
	var most := _ALIKE
	for candidate in names:
		var alike := candidate.to_lower().similarity(unknown.to_lower())
		if alike > most and candidate != unknown:
			most = alike
			nearest = candidate
	return nearest


## One sentence for what stopped a method while it ran.
static func of_stop(message: String, names: PackedStringArray) -> String:
	if message.begins_with("Division by zero"):
		return LabText.translate(
			"A whole number is divided by 0: test for 0 first, and use floats."
		)
	var unknown := _captured(message, "Nonexistent function '(\\w+)")
	if not unknown:
		unknown = _captured(message, "key '(\\w+)'")
	if message.contains("'Nil'") or message.contains("null instance"):
		return LabText.translate(
			"Something is null here: does the method it calls return anything?"
		)
	if unknown:
		return unknown_name(unknown, names)
	return LabText.translate("Godot stops here: %s") % message


static func _captured(message: String, pattern: String) -> String:
	var hit := RegEx.create_from_string(pattern).search(message)
	return hit.get_string(1) if hit else ""


static func _first_word(bare: String) -> String:
	var hit := RegEx.create_from_string(r"^[a-z]+\b").search(bare)
	if not hit or (hit.get_string() == "static" and not bare.contains("func ")):
		return ""
	return hit.get_string()


static func _without_comment(line: String) -> String:
	var string_or_comment := r"(\"(?:\\.|[^\"\\])*\"|'(?:\\.|[^'\\])*')|#.*"
	return RegEx.create_from_string(string_or_comment).sub(line, '""', true).trim_suffix('""')


static func _opened_in(bare: String) -> int:
	var opened := 0
	for bracket: String in ["(", "[", "{"]:
		opened += bare.count(bracket)
	for bracket: String in [")", "]", "}"]:
		opened -= bare.count(bracket)
	return opened


# Whether a colon stands outside of brackets, which a type such as `x: float` does not.
static func _has_colon(bare: String) -> bool:
	if bare.ends_with(":"):
		return true
	var depth := 0
	for index in bare.length():
		if bare[index] in ["(", "[", "{"]:
			depth += 1
		elif bare[index] in [")", "]", "}"]:
			depth -= 1
		elif bare[index] == ":" and depth <= 0:
			return true
	return false
