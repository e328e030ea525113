extends RefCounted
## A test and what became of it.

var name := ""
var takes_parameters := false
var was_run := false
var seconds := 0.0
var pass_texts := PackedStringArray()
var fail_texts := PackedStringArray()
var pending_texts := PackedStringArray()


func is_failing() -> bool:
	return not fail_texts.is_empty()


func is_pending() -> bool:
	return not is_failing() and not pending_texts.is_empty()


func is_passing() -> bool:
	return not is_failing() and not is_pending() and not pass_texts.is_empty()


func assert_count() -> int:
	return pass_texts.size() + fail_texts.size()


## As GUT names it in its results.
func status() -> String:
	if is_failing():
		return "fail"
	if is_pending():
		return "pending"
	return "pass" if is_passing() else "no asserts"
