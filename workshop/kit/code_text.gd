@tool
class_name WorkshopCode
extends RefCounted
## The text of a student's file: what can be told of it without running it.


## A word, number, string or sign of a text.
class Token:
	extends RefCounted
	## The characters, for a string with its quotes.
	var text: String
	## The line in which it begins, from 1.
	var line: int
	## The place in the text where it begins, from 0.
	var at: int

	## A token of these characters.
	func _init(its_text: String, its_line: int, its_place: int) -> void:
		text = its_text
		line = its_line
		at = its_place

	## Whether it is a name or a keyword.
	func is_name() -> bool:
		return text.is_valid_ascii_identifier()


## More bytes than this are not looked at.
const LARGEST := 100_000

const _TOKEN := (
	r"(?s)(?<string>[&^r]?\"\"\"(?:\\.|[^\\])*?\"\"\"|[&^r]?'''(?:\\.|[^\\])*?'''"
	+ r"|[&^r]?\"(?:\\.|[^\"\\\n])*\"|[&^r]?'(?:\\.|[^'\\\n])*')"
	+ r"|(?<comment>#[^\n]*)|(?<name>[A-Za-z_]\w*)|(?<number>\d[\w.]*)|(?<sign>\S)"
)
## Words of the language behind which a value begins.
const KEYWORDS: PackedStringArray = [
	"if",
	"elif",
	"else",
	"for",
	"while",
	"match",
	"return",
	"var",
	"const",
	"in",
	"and",
	"or",
	"not"
]

static var _token := RegEx.create_from_string(_TOKEN)

## The text with tabs, line feeds, and no mark at its start.
var text := ""
## "" or one sentence why the bytes are no text, translated.
var problem := ""


## The text in these bytes.
func _init(bytes: PackedByteArray) -> void:
	problem = _problem_of(bytes)
	if not problem:
		text = bytes.get_string_from_utf8().replace("\r\n", "\n").replace("\r", "\n")
		text = text.trim_prefix("\ufeff")


## Its tokens in order, without comments.
func tokens() -> Array[Token]:
	var found: Array[Token] = []
	var line := 1
	var counted := 0
	for hit in _token.search_all(text):
		line += text.substr(counted, hit.get_start() - counted).count("\n")
		counted = hit.get_start()
		if not hit.get_string("comment"):
			found.append(Token.new(hit.get_string(), line, hit.get_start()))
	return found


## The names of the functions that it declares.
func functions() -> PackedStringArray:
	var found: PackedStringArray = []
	for hit in RegEx.create_from_string(r"(?m)^\s*(?:static\s+)?func\s+(\w+)").search_all(text):
		found.append(hit.get_string(1))
	return found


## The line in which a function is declared, from 1; 0 where it is not.
func line_of(function: String) -> int:
	var pattern := r"(?m)^\s*(?:static\s+)?func\s+%s\b" % function
	var hit := RegEx.create_from_string(pattern).search(text)
	return text.substr(0, hit.get_start()).count("\n") + 1 + _breaks_in(hit) if hit else 0


## The body of a function as its tokens, each name but keywords as one and the same: what stays when
## names, blanks and comments do not count.
func shape_of(function: String) -> PackedStringArray:
	var shape: PackedStringArray = []
	for token in body_of(function):
		shape.append("n" if token.is_name() and not token.text in KEYWORDS else token.text)
	return shape


## The tokens in the brackets of a function.
func parameters_of(function: String) -> Array[Token]:
	var brackets := WorkshopCode.new([])
	var hit := RegEx.create_from_string(r"\bfunc\s+%s\s*\(([^)]*)\)" % function).search(text)
	brackets.text = hit.get_string(1) if hit else ""
	return brackets.tokens()


## The tokens in the body of a function.
func body_of(function: String) -> Array[Token]:
	var body := WorkshopCode.new([])
	var lines := text.split("\n")
	var at := line_of(function)
	if at > 0:
		body.text = "\n".join(_lines_of_body(lines, at - 1))
	return body.tokens()


## The names of the functions that the body of a function calls.
func calls_in(function: String) -> PackedStringArray:
	var found: PackedStringArray = []
	var body := body_of(function)
	for index in body.size() - 1:
		if body[index].is_name() and body[index + 1].text == "(":
			found.append(body[index].text)
	return found


static func _breaks_in(hit: RegExMatch) -> int:
	return hit.get_string().count("\n")


# The lines behind the head of the function that begins in line `at`, and what follows the colon.
static func _lines_of_body(lines: PackedStringArray, at: int) -> PackedStringArray:
	var body: PackedStringArray = []
	var indent := _indent_of(lines[at])
	var depth := 0
	var is_in_head := true
	for number in range(at, lines.size()):
		var line := lines[number]
		if is_in_head:
			depth += line.count("(") - line.count(")")
			if depth <= 0:
				is_in_head = false
				body.append(line.substr(line.rfind("):") + 2) if line.contains("):") else "")
		elif line.strip_edges() and _indent_of(line) <= indent:
			break
		else:
			body.append(line)
	return body


static func _indent_of(line: String) -> int:
	return line.length() - line.lstrip(" \t").length()


static func _problem_of(bytes: PackedByteArray) -> String:
	if bytes.size() > LARGEST:
		return LabText.translate("The file is too large: 100 000 bytes are the most.")
	if bytes.has(0) or (bytes and bytes.get_string_from_utf8().is_empty()):
		return LabText.translate("The file holds no text: save it as text in UTF-8.")
	return ""
