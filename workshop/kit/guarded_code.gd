class_name WorkshopGuardedCode
extends RefCounted
## A student's text with guards in it, see [WorkshopGuard]: each loop asks whether it may make
## another turn, each function whether it may begin, each divisor whether it is a whole 0, each
## value whether it is null before something of it is used. The student never sees this text; the
## lines in all that is told are those of his own.

# Functions of the language that give whole numbers.
const _WHOLE := (
	"int len floori ceili roundi absi maxi mini clampi signi posmod wrapi size typeof find count "
	+ "length step_decimals"
)
# Functions of the language of which only the value itself tells what it is.
const _ANY := (
	"abs max min clamp sign floor ceil round snapped wrap lerp back front pop_back pop_front get "
	+ "get_or_add reduce"
)
const _PRINTING := "print prints printt printerr push_error push_warning"
const _BUILT_IN := "void float int bool String StringName Array Dictionary Variant"

## The text with the guards.
var text := ""
## ONE sentence, translated, on what cannot be guarded; "" where all is.
var problem := ""
## The line of that, from 1.
var problem_line := 0

var _layout: WorkshopCodeLayout
var _plain: String
# What each function of the student's gives back; "?" where two of one name differ.
var _types: Dictionary[String, String] = {}
# In the text by their places: whole pieces, and what stands in place of a token.
var _pieces: Dictionary[int, String] = {}
var _replaced: Dictionary[int, String] = {}
var _wraps: Array[Wrap] = []
# For each line of the text that of the student's own.
var _lines: PackedInt32Array = [1]


## What stands around a part of the text.
class Wrap:
	extends RefCounted
	## Where the part begins.
	var from: int
	## Where it ends.
	var to: int
	## What stands before it.
	var before: String
	## What stands behind it.
	var behind: String


## Guards [param plain_text]. [param types] is what the functions of all files give back, from
## [method types_in].
func _init(plain_text: String, types: Dictionary[String, String]) -> void:
	_plain = WorkshopTogether.with_tabs(plain_text)
	_types = types
	_layout = WorkshopCodeLayout.new(_plain)
	_guard_functions()
	# An operand is looked at after all that is in it.
	for index in range(_layout.tokens.size() - 1, -1, -1):
		_guard_token(index)
	text = _written(0, _plain.length(), true)


## What the functions in a text give back, by their names: "" where they do not say so.
static func types_in(its_text: String) -> Dictionary[String, String]:
	var types: Dictionary[String, String] = {}
	for head in WorkshopCodeLayout.new(WorkshopTogether.with_tabs(its_text)).heads:
		if head.name:
			var is_other: bool = types.get(head.name, head.type) != head.type
			types[head.name] = "?" if is_other else head.type
	return types


## The line of the student's own text for a line of [member text], both from 1.
func line_of(guarded_line: int) -> int:
	if guarded_line < 1 or guarded_line > _lines.size():
		return guarded_line
	return _lines[guarded_line - 1]


func _guard_token(index: int) -> void:
	var line := _layout.tokens[index].line
	if _layout.is_word(index, "while"):
		_guard_while(index, line)
	elif _layout.is_word(index, "for"):
		_guard_for(index, line)
	elif _layout.text_at(index) in ["/", "%"] and _layout.ends_value(index - 1):
		_guard_division(index, line)
	elif _layout.text_at(index) == ".":
		_guard_member(index, line)
	elif _layout.text_at(index + 1) == "(" and _layout.partners[index + 1] > index:
		_guard_call(index, line)
	elif _layout.tokens[index].is_name() and _layout.begins_statement(index):
		_guard_growth(index, line)


func _guard_while(index: int, line: int) -> void:
	var colon := _layout.colon_after(index)
	if colon > index + 1:
		var before := "WorkshopGuard.turn(%d) and (" % line
		_wrap(index + 1, colon - 1, before, ")")


func _guard_for(index: int, line: int) -> void:
	var within := _layout.find_outside(index, "in")
	var colon := _layout.colon_after(within) if within > 0 else -1
	if colon < 0 or colon + 1 >= _layout.tokens.size():
		return
	var first := colon + 1
	var guard := "if not WorkshopGuard.turn(%d): break" % line
	if _layout.begins_line(first):
		_put_line(first, guard)
	elif _layout.begins_line(index):
		_break_line(first, _layout.indent_of(index) + "\t", guard)
	else:
		_refuse(LabText.translate("Write this loop on lines of its own."), line)


func _guard_functions() -> void:
	for head in _layout.heads:
		var first := head.colon + 1
		if first >= _layout.tokens.size():
			continue
		var line := _layout.tokens[head.begin].line
		var call_name := "guarded_call_%d" % head.begin
		var enter := "var %s := WorkshopGuard.enter(%d)" % [call_name, line]
		var leave := "if WorkshopGuard.over: " + _leaving(head)
		if _layout.begins_line(first):
			_put_line(first, enter)
			_put_line(first, leave)
		elif head.name:
			var indent := _layout.indent_of(_layout.statement_start(head.begin)) + "\t"
			_break_line(first, indent, enter + "\n" + indent + leave)
		elif head.type in ["", "void"]:
			_put(_layout.tokens[first].at, enter + "; if not WorkshopGuard.over: ")
		else:
			_refuse(LabText.translate("Write this function on lines of its own."), line)


# Whatever its type is: a variable of that type begins as something that can be given back.
static func _leaving(head: WorkshopCodeLayout.Head) -> String:
	if head.type in ["", "void"]:
		return "return"
	var nothing := "guarded_nothing_%d" % head.begin
	return "var %s: %s; return %s" % [nothing, head.type, nothing]


func _guard_division(index: int, line: int) -> void:
	var is_assigning := _layout.text_at(index + 1) == "="
	var first := index + 2 if is_assigning else index + 1
	var last := _layout.statement_end(first) - 1 if is_assigning else _layout.operand_end(first)
	if last < first or last >= _layout.tokens.size() or _is_harmless(index, first, last):
		return
	if _layout.text_at(last) == ")" and _layout.ends_value(_layout.partners[last] - 1):
		if _layout.chain_start(last) == first:
			_guard_called_divisor(first, last, line)
			return
	var divisor := _written(_layout.tokens[first].at, _layout.end_of(last))
	_wrap(first, last, "((", ") - WorkshopGuard.shift(%s, %d))" % [divisor, line])


# A number that is not 0, and what no text may be filled with.
func _is_harmless(index: int, first: int, last: int) -> bool:
	var word := _layout.text_at(first)
	if first == last and word[0].is_valid_int():
		var digits := word.to_lower().trim_prefix("0x").trim_prefix("0b").replace("_", "")
		return word.contains(".") or digits.strip_edges().lstrip("0") != ""
	if _layout.text_at(index) == "/":
		return word == "."
	var dividend := _layout.text_at(index - 1)
	return word in ["[", "str"] or dividend[-1] in ['"', "'"] or _is_text(dividend)


func _is_text(word: String) -> bool:
	var pattern := r"\b%s[ \t]*(:[ \t]*String\b|:?=[ \t]*[\"'])" % word
	return word.is_valid_ascii_identifier() and RegEx.create_from_string(pattern).search(_plain)


func _guard_called_divisor(first: int, last: int, line: int) -> void:
	match _type_of_call(last):
		"int":
			_wrap(first, last, "WorkshopGuard.whole_divisor(", ", %d)" % line)
		"", "Variant", "?":
			_wrap(first, last, "WorkshopGuard.any_divisor(", ", %d)" % line)


# What the call that ends with a token gives; "float" for what needs no guard.
func _type_of_call(last: int) -> String:
	var called := _layout.text_at(_layout.partners[last] - 1)
	if _types.has(called):
		return _types[called]
	if called in _WHOLE.split(" "):
		return "int"
	return "" if called in _ANY.split(" ") else "float"


func _guard_member(index: int, line: int) -> void:
	var last := index - 1
	if not _layout.ends_value(last) or not _layout.tokens[index + 1].is_name():
		return
	var start := _layout.chain_start(last)
	var is_called := _layout.text_at(index + 2) == "("
	var asked := '&"%s", %s, %d' % [_layout.text_at(index + 1), is_called, line]
	if _is_plain(start, last):
		var base := _plain.substr(
			_layout.tokens[start].at, _layout.end_of(last) - _layout.tokens[start].at
		)
		var question := "WorkshopGuard.has(%s, %s)" % [base, asked]
		if _is_target(start, index + 1):
			_put(_layout.tokens[start].at, question + "; ")
		else:
			_wrap(start, last, "(", " if %s else %s)" % [question, base])
	elif _layout.text_at(last) == ")" and _layout.ends_value(_layout.partners[last] - 1):
		_guard_given(start, last, asked)


func _guard_given(start: int, last: int, asked: String) -> void:
	var type := _type_of_call(last)
	if _layout.text_at(_layout.partners[last] - 1) == "new" or type in _BUILT_IN.split(" "):
		return
	if type.contains("[") or type == "?" or type.begins_with("Packed"):
		return
	var cast := " as " + type if type else ""
	_wrap(start, last, "(WorkshopGuard.given(", ", %s)%s)" % [asked, cast])


# Whether it can be read twice: names of variables, their members, and plain indices.
func _is_plain(start: int, last: int) -> bool:
	var root := _layout.text_at(start)
	if root.to_upper()[0] == root[0] and root[0] != "_":
		return false
	if root == "super" or _layout.text_at(_layout.statement_start(start)) == "const":
		return false
	if start == last and root == "self":
		return false
	for index in range(start, last + 1):
		var is_part := _layout.text_at(index) in [".", "[", "]", "+", "-"]
		if not is_part and not _layout.tokens[index].is_name():
			if not _layout.text_at(index).is_valid_int():
				return false
	return true


# Whether a value is assigned to the chain with this first token and this member.
func _is_target(start: int, member: int) -> bool:
	return _layout.begins_statement(start) and _layout.is_assigned(_layout.chain_end(member))


func _guard_call(index: int, line: int) -> void:
	var called := _layout.text_at(index)
	var arguments := _layout.arguments_of(index + 1)
	if _layout.text_at(index - 1) == ".":
		if called == "resize":
			_wrap_each(arguments, "WorkshopGuard.extent(", ", %d)" % line)
		elif called == "append_array":
			_wrap_each(arguments, "WorkshopGuard.added(", ", %d)" % line)
		return
	if _types.has(called) or _layout.text_at(index - 1) == "func":
		return
	if called in _PRINTING.split(" "):
		_replaced[_layout.tokens[index].at] = "WorkshopGuard.say"
	elif called == "assert" and arguments:
		_replaced[_layout.tokens[index].at] = "WorkshopGuard.claim"
		var missing := ', ""' if arguments.size() == 1 else ""
		_put(_layout.end_of(arguments[-1].y), "%s, %d" % [missing, line])
	elif called == "posmod" and arguments.size() == 2:
		_replaced[_layout.tokens[index].at] = "WorkshopGuard.rest"
		_put(_layout.end_of(arguments[1].y), ", %d" % line)
	elif called == "range":
		var is_counted := _layout.text_at(index - 1) == "in" and _is_in_head(index)
		var before := "WorkshopGuard.limit(" if is_counted else "WorkshopGuard.extent("
		_wrap_each(arguments, before, ")" if is_counted else ", %d)" % line)


# Whether what stands here is what a loop goes through.
func _is_in_head(index: int) -> bool:
	var start := index
	while start > 0 and not _layout.begins_statement(start):
		start -= 1
	return _layout.text_at(start) == "for" or _layout.text_at(start - 3) == "for"


# A text or a list that a loop makes longer and longer.
func _guard_growth(index: int, line: int) -> void:
	if _layout.bracket_around(index) >= 0 or not _layout.is_assigned(index):
		return
	if not _is_in_loop(index):
		return
	var end := _layout.statement_end(index)
	for inner in range(index, end):
		if _layout.text_at(inner) == "func":
			return
	var guard := "; WorkshopGuard.look(%s, %d)" % [_layout.text_at(index), line]
	_put(_layout.end_of(end - 1), guard)


func _is_in_loop(index: int) -> bool:
	var first := _layout.statement_start(index)
	var indent := _layout.indent_of(first).length()
	for before in range(first, -1, -1):
		var is_outer := before == first
		if _layout.begins_line(before) and _layout.indent_of(before).length() < indent:
			indent = _layout.indent_of(before).length()
			is_outer = true
		if is_outer and _layout.text_at(before) in ["for", "while"]:
			return true
	return false


func _refuse(sentence: String, line: int) -> void:
	problem = sentence
	problem_line = line


func _wrap_each(arguments: Array[Vector2i], before: String, behind: String) -> void:
	for argument in arguments:
		_wrap(argument.x, argument.y, before, behind)


func _wrap(first: int, last: int, before: String, behind: String) -> void:
	var around := Wrap.new()
	around.from = _layout.tokens[first].at
	around.to = _layout.end_of(last)
	around.before = before
	around.behind = behind
	_wraps.append(around)


func _put(place: int, piece: String) -> void:
	_pieces[place] = _pieces.get(place, "") + piece


# A line of its own before the one that a token begins.
func _put_line(first: int, guard: String) -> void:
	_put(_layout.line_start(first), _layout.indent_of(first) + guard + "\n")


# What begins here goes on in a line of its own, with a guard before it.
func _break_line(first: int, indent: String, guard: String) -> void:
	_put(_layout.tokens[first].at, "\n%s%s\n%s" % [indent, guard, indent])


# A part of the text with all guards that are in it. [param counts_lines]: it is the whole of it.
func _written(from: int, to: int, counts_lines: bool = false) -> String:
	var before: Dictionary[int, String] = {}
	var behind: Dictionary[int, String] = {}
	for around in _wraps_within(from, to):
		before[around.from] = before.get(around.from, "") + around.before
		behind[around.to] = around.behind + behind.get(around.to, "")
	var places := _places_within(from, to, [before, behind, _pieces, _replaced])
	var written := ""
	for index in places.size():
		var place := places[index]
		var guards: String = behind.get(place, "")
		# A piece stands before or behind what is read twice.
		if counts_lines or (place > from and place < to):
			guards += _pieces.get(place, "")
		guards += before.get(place, "")
		var end := places[index + 1] if index + 1 < places.size() else place
		var own := _plain_or_replaced(place, end)
		written += guards + own
		if counts_lines:
			_count_lines(guards, own)
	return written


# The outer ones first.
func _wraps_within(from: int, to: int) -> Array[Wrap]:
	var inside: Array[Wrap] = []
	for around in _wraps:
		if around.from >= from and around.to <= to:
			inside.append(around)
	inside.sort_custom(
		func(one: Wrap, other: Wrap) -> bool: return one.to - one.from > other.to - other.from
	)
	return inside


static func _places_within(from: int, to: int, all: Array[Dictionary]) -> PackedInt32Array:
	var places: Dictionary[int, bool] = {from: true, to: true}
	for known in all:
		for place: int in known:
			if place > from and place < to:
				places[place] = true
	var sorted := PackedInt32Array(places.keys())
	sorted.sort()
	return sorted


func _plain_or_replaced(from: int, to: int) -> String:
	var plain := _plain.substr(from, to - from)
	if not _replaced.has(from) or from == to:
		return plain
	var word := RegEx.create_from_string(r"^\w+").search(plain).get_string()
	return _replaced[from] + plain.substr(word.length())


# A guard has no line in the student's text: it belongs to the one where it stands.
func _count_lines(guards: String, own: String) -> void:
	for i in guards.count("\n"):
		_lines.append(_lines[-1])
	for i in own.count("\n"):
		_lines.append(_lines[-1] + 1)
