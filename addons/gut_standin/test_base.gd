extends Node
## What every kind of assert stands on. Names that are not for tests begin with `_gut_`, so that a
## test may use every other.

const GutTestRunner := preload("gut_main.gd")
const GUT_NUMBERS: PackedInt32Array = [TYPE_INT, TYPE_FLOAT]
const GUT_TEXTS: PackedInt32Array = [TYPE_STRING, TYPE_STRING_NAME]

## The runner.
var gut: GutTestRunner


func pass_test(text: Variant) -> void:
	gut.add_pass(str(text))


func fail_test(text: Variant) -> void:
	var run := ""
	if gut.parameter_handler != null:
		run = "params[%d] " % (gut.parameter_handler.count - 1)
	gut.add_fail(run + str(text))


func pending(text: Variant = "") -> void:
	gut.add_pending(str(text))


func _gut_check(ok: Variant, text: String) -> void:
	if is_same(ok, true):
		pass_test(text)
	else:
		fail_test(text)


## False, and a failed assert, when two values of different types are compared.
func _gut_have_comparable_types(got: Variant, want: Variant, text: Variant) -> bool:
	var got_type := typeof(got)
	var want_type := typeof(want)
	if got_type == want_type or got == null or want == null:
		return true
	if got_type in GUT_NUMBERS and want_type in GUT_NUMBERS:
		gut.logger.warn("Float/Int comparison: %s, %s" % [_gut_text_of(got), _gut_text_of(want)])
		return true
	if got_type in GUT_TEXTS and want_type in GUT_TEXTS:
		return true
	fail_test("Cannot compare %s to %s.  %s" % [_gut_text_of(got), _gut_text_of(want), text])
	return false


func _gut_text_of(value: Variant) -> String:
	if value is String or value is StringName:
		return '"%s"' % value
	return var_to_str(value) if value is float else "%s" % [value]
