class_name WorkshopGuardLimits
extends RefCounted
## What no guard can make safe: code that runs outside of any function, and may call itself there.
## It is refused before it is compiled.

## The line of what is refused; 0 if nothing is.
var line := 0
## One sentence, translated; "" if nothing is refused.
var sentence := ""

var _layout: WorkshopCodeLayout
# The classes in the text.
var _classes: Dictionary[String, bool] = {}


## Looks at the text of one file.
func _init(text: String) -> void:
	_layout = WorkshopCodeLayout.new(WorkshopTogether.with_tabs(text))
	for index in _layout.tokens.size():
		if _layout.text_at(index - 1) in ["class", "class_name"]:
			_classes[_layout.text_at(index)] = true
	for index in _layout.tokens.size():
		if not sentence:
			_look_at(index)


func _look_at(index: int) -> void:
	var word := _layout.text_at(index)
	if word == "static" and _layout.text_at(index + 1) == "var":
		_refuse(index, "static var")
	elif word == "_static_init":
		_refuse(index, word)
	elif word in ["set", "get"] and _layout.text_at(index + 1) in ["(", ":", "="]:
		if _layout.text_at(index - 1) != ".":
			_refuse(index, word)
	elif word == "new" and _is_outside_of_functions(index):
		if _layout.text_at(index - 1) != "." or _classes.has(_layout.text_at(index - 2)):
			_refuse(index, _layout.text_at(index - 2) + ".new")
	elif _is_parameter(index) and _layout.text_at(index + 1) == "(":
		if _layout.ends_value(index) and not word in WorkshopAllowed.FUNCTIONS.split(" "):
			_refuse(index, word)


# In a default value of a function, such as `func f(a = g())`.
func _is_parameter(index: int) -> bool:
	var bracket := _layout.bracket_around(index)
	for head in _layout.heads:
		if head.bracket == bracket and head.name:
			return _layout.text_at(index - 1) != "." or _classes.has(_layout.text_at(index - 2))
	return false


func _is_outside_of_functions(index: int) -> bool:
	var start := _layout.statement_start(index)
	var indent := _layout.indent_of(start).length()
	for before in range(start, -1, -1):
		var is_outer := before == start
		if _layout.begins_line(before) and _layout.indent_of(before).length() < indent:
			indent = _layout.indent_of(before).length()
			is_outer = true
		if (
			is_outer
			and (_layout.text_at(before) == "func" or _layout.text_at(before + 1) == "func")
		):
			return false
	return true


func _refuse(index: int, word: String) -> void:
	line = _layout.tokens[index].line
	sentence = (
		LabText.translate("%s cannot be stopped in the browser: use it in Godot only.") % word
	)
