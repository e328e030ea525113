class_name WorkshopCodeLayout
extends RefCounted
## How the tokens of a student's text belong together: brackets, statements, heads of loops and of
## functions, operands. It knows no more of the language than the guards need.


## The head of a function or of a lambda.
class Head:
	extends RefCounted
	## The token `func`.
	var begin: int
	## Its name, "" for a lambda.
	var name: String
	## The bracket before its parameters.
	var bracket: int
	## What it gives back, as it is written; "" where it does not say so.
	var type: String
	## The colon behind it.
	var colon: int


## The tokens in their order.
var tokens: Array[WorkshopCode.Token] = []
## For each bracket its counterpart; -1 for all that is none, and for one that is not closed.
var partners: PackedInt32Array = []
## The functions and lambdas.
var heads: Array[Head] = []

var _text: String


## The layout of [param text], which is indented with tabs.
func _init(text: String) -> void:
	_text = text
	var code := WorkshopCode.new([])
	code.text = text
	tokens = code.tokens()
	_pair_brackets()
	for index in tokens.size():
		if is_word(index, "func"):
			var head := _head_at(index)
			if head:
				heads.append(head)


## The characters of a token; "" outside of the text.
func text_at(index: int) -> String:
	return tokens[index].text if index >= 0 and index < tokens.size() else ""


## Whether a token is this word, and no member of that name.
func is_word(index: int, word: String) -> bool:
	return text_at(index) == word and text_at(index - 1) != "."


## Whether a token is the first one in its line, and the line does not go on from the one above.
func begins_line(index: int) -> bool:
	if index <= 0:
		return index == 0
	return tokens[index].line > tokens[index - 1].line and text_at(index - 1) != "\\"


## Whether a token begins a statement.
func begins_statement(index: int) -> bool:
	if text_at(index - 1) != ":":
		return begins_line(index) or text_at(index - 1) == ";"
	# A type stands behind a colon, too, and a value in braces.
	if bracket_around(index) >= 0:
		return heads.any(func(head: Head) -> bool: return head.colon == index - 1)
	return not text_at(index - 3) in ["var", "const", "for"]


## The innermost bracket that is open at a token; -1 for none.
func bracket_around(index: int) -> int:
	var before := index - 1
	while before >= 0:
		if partners[before] > index:
			return before
		before -= 1
	return -1


## The first token of the line in which the statement begins that a token is in.
func statement_start(index: int) -> int:
	var start := index
	while start > 0 and not (begins_line(start) and bracket_around(start) < 0):
		start -= 1
	return start


## Where the line of a token begins in the text.
func line_start(index: int) -> int:
	return _text.rfind("\n", tokens[index].at) + 1 if tokens[index].at > 0 else 0


## The blanks before the first token in the line of a token.
func indent_of(index: int) -> String:
	var line := _text.substr(line_start(index), tokens[index].at - line_start(index))
	return line.substr(0, line.length() - line.lstrip(" \t").length())


## Where a token ends in the text.
func end_of(index: int) -> int:
	return tokens[index].at + tokens[index].text.length()


## The first colon after a token that is in no bracket opened since; -1 for none.
func colon_after(index: int) -> int:
	return find_outside(index, ":")


## The first token with these characters after another one that is in no bracket opened since; -1
## for none in the same statement.
func find_outside(index: int, wanted: String) -> int:
	var next := index + 1
	while next < tokens.size() and not begins_line(next):
		if text_at(next) == wanted:
			return next
		if text_at(next) in [")", "]", "}"]:
			return -1
		next = partners[next] + 1 if partners[next] > next else next + 1
	return -1


## The token behind the last one of the statement in which a token is, seen from there on.
func statement_end(index: int) -> int:
	var next := index
	while next < tokens.size():
		if next > index and begins_line(next):
			return next
		if text_at(next) in [";", ")", "]", "}", ","]:
			return next
		next = partners[next] + 1 if partners[next] > next else next + 1
	return tokens.size()


## Whether a value ends with a token, so that a sign behind it stands between two values.
func ends_value(index: int) -> bool:
	var word := text_at(index)
	if not word:
		return false
	if word in [")", "]", "}"] or word[-1] in ['"', "'"] or word[0].is_valid_int():
		return true
	return tokens[index].is_name() and not word in WorkshopCode.KEYWORDS


## The first token of the names, calls and indices that end with a token: `a` in `a.b(c)[d]`.
func chain_start(index: int) -> int:
	var start := index
	while true:
		if text_at(start) in [")", "]", "}"]:
			var opened := partners[start]
			if opened < 0 or not ends_value(opened - 1) or text_at(start) == "}":
				return maxi(opened, 0)
			start = opened - 1
		elif text_at(start - 1) == "." and ends_value(start - 2):
			start -= 2
		else:
			return start
	return start


## The last token of the names, calls and indices that go on behind a token.
func chain_end(index: int) -> int:
	var end := index
	while true:
		if text_at(end) in ["(", "[", "{"] and partners[end] > end:
			end = partners[end]
		if text_at(end + 1) == "." and end + 2 < tokens.size():
			end += 2
		elif text_at(end + 1) in ["(", "["] and not begins_line(end + 1):
			end += 1
		else:
			return end
	return end


## The last token of the operand that begins with a token: signs, a chain, and powers of it.
func operand_end(index: int) -> int:
	var start := index
	while text_at(start) in ["-", "+", "~"]:
		start += 1
	if text_at(start) == ".":
		start += 1
	var end := chain_end(start)
	if text_at(end + 1) == "*" and text_at(end + 2) == "*":
		return operand_end(end + 3)
	return end


## Whether a token is followed by a sign that assigns, such as `=` or `+=`.
func is_assigned(index: int) -> bool:
	var sign_at := index + 1
	while text_at(sign_at) in ["+", "-", "*", "/", "%", "&", "|", "^", "<", ">"]:
		sign_at += 1
	return text_at(sign_at) == "=" and text_at(sign_at + 1) != "=" and sign_at - index <= 3


## The parts of a call between its commas, each as its first and its last token. [param bracket] is
## the one that opens it.
func arguments_of(bracket: int) -> Array[Vector2i]:
	var found: Array[Vector2i] = []
	var first := bracket + 1
	var next := first
	while next <= partners[bracket]:
		if next == partners[bracket] or text_at(next) == ",":
			if next > first:
				found.append(Vector2i(first, next - 1))
			first = next + 1
		next = partners[next] + 1 if partners[next] > next else next + 1
	return found


func _pair_brackets() -> void:
	partners.resize(tokens.size())
	partners.fill(-1)
	var opened: PackedInt32Array = []
	for index in tokens.size():
		if text_at(index) in ["(", "[", "{"]:
			opened.append(index)
		elif text_at(index) in [")", "]", "}"] and opened:
			partners[index] = opened[-1]
			partners[opened[-1]] = index
			opened.remove_at(opened.size() - 1)


func _head_at(index: int) -> Head:
	var head := Head.new()
	head.begin = index
	head.bracket = index + 1 if text_at(index + 1) == "(" else index + 2
	if text_at(head.bracket) != "(" or partners[head.bracket] < 0:
		return null
	var closed := partners[head.bracket]
	head.colon = closed + 1
	if text_at(closed + 1) == "-" and text_at(closed + 2) == ">":
		head.colon = find_outside(closed + 2, ":")
		if head.colon < 0:
			return null
		var begin := tokens[closed + 3].at
		head.type = _text.substr(begin, tokens[head.colon].at - begin).strip_edges()
	if text_at(head.colon) != ":":
		return null
	var before := index - 1
	if text_at(before) == "static":
		before -= 1
	if begins_line(before + 1) or text_at(before) == ")":
		head.name = text_at(index + 1)
	return head
