extends "signal_asserts.gd"
## Asserts about errors and warnings of the engine. One that is asserted no longer fails its test.

const GutTrackedMessage := preload("tracked_message.gd")


func assert_push_error(part: Variant, text: Variant = "") -> void:
	_gut_expect_text("push_error", part, text)


func assert_push_error_count(count: Variant, text: Variant = "") -> void:
	_gut_expect_count("push_error", count, text)


func assert_push_warning(part: Variant, text: Variant = "") -> void:
	_gut_expect_text("push_warning", part, text)


func assert_push_warning_count(count: Variant, text: Variant = "") -> void:
	_gut_expect_count("push_warning", count, text)


func assert_engine_error(part: Variant, text: Variant = "") -> void:
	_gut_expect_text("engine", part, text)


func assert_engine_error_count(count: Variant, text: Variant = "") -> void:
	_gut_expect_count("engine", count, text)


func _gut_expect_text(type: String, part: Variant, text: Variant) -> void:
	var said := "expected %s with '%s': %s" % [type, part, text]
	for message: GutTrackedMessage in gut.error_tracker.get_errors_for_test():
		if message.type_name() == type and not message.handled and message.contains_text(str(part)):
			message.handled = true
			pass_test(said)
			return
	fail_test(said)


func _gut_expect_count(type: String, count: Variant, text: Variant) -> void:
	var found := 0
	for message: GutTrackedMessage in gut.error_tracker.get_errors_for_test():
		if message.type_name() == type:
			found += 1
			message.handled = message.handled or found <= count
	_gut_check(found == count, "expected %d times %s, got %d: %s" % [count, type, found, text])
