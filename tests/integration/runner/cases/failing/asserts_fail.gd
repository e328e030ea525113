extends "res://addons/gut/test.gd"
## Each test here must fail.

signal rang(times: int)


func test_eq() -> void:
	assert_eq(1, 2)


func test_eq_of_different_types() -> void:
	assert_eq(1, "1")


func test_eq_nan() -> void:
	assert_eq(NAN, NAN)


func test_ne() -> void:
	assert_ne(1, 1)


func test_gt() -> void:
	assert_gt(1, 1)


func test_gte() -> void:
	assert_gte(1, 2)


func test_lt() -> void:
	assert_lt(1, 1)


func test_lte() -> void:
	assert_lte(2, 1)


func test_between() -> void:
	assert_between(3, 1, 2)


func test_almost_eq() -> void:
	assert_almost_eq(1.0, 1.5, 0.25)


func test_almost_eq_nan() -> void:
	assert_almost_eq(NAN, 1.0, 0.25)


func test_almost_eq_of_one_component() -> void:
	assert_almost_eq(Vector2(1, 2), Vector2(1, 3), Vector2(0.5, 0.5))


func test_almost_ne() -> void:
	assert_almost_ne(1.0, 1.0, 0.25)


func test_true() -> void:
	assert_true(false)


func test_true_of_a_number() -> void:
	assert_true(1)


func test_false() -> void:
	assert_false(true)


func test_null() -> void:
	assert_null(0)


func test_not_null() -> void:
	assert_not_null(null)


func test_same() -> void:
	assert_same([1], [1])


func test_not_same() -> void:
	var list := [1]
	assert_not_same(list, list)


func test_has() -> void:
	assert_has([1, 2], 3)


func test_does_not_have() -> void:
	assert_does_not_have({"a": 1}, "a")


func test_string_contains() -> void:
	assert_string_contains("abc", "B")


func test_string_contains_nothing() -> void:
	assert_string_contains("abc", "")


func test_string_starts_with() -> void:
	assert_string_starts_with("abc", "b")


func test_string_ends_with() -> void:
	assert_string_ends_with("abc", "b")


func test_is() -> void:
	var node: Node = autofree(Node.new())
	assert_is(node, Node2D)


func test_has_method() -> void:
	assert_has_method(self, "not_there")


func test_freed() -> void:
	assert_freed(self)


func test_not_freed() -> void:
	var gone := Node.new()
	gone.free()
	assert_not_freed(gone)


func test_no_new_orphans() -> void:
	var node := Node.new()
	assert_no_new_orphans()
	node.free()


func test_file_exists() -> void:
	assert_file_exists("res://nowhere")


func test_file_does_not_exist() -> void:
	assert_file_does_not_exist("res://project.godot")


func test_has_signal() -> void:
	assert_has_signal(self, "not_there")


func test_signal_of_what_is_not_watched() -> void:
	rang.emit(1)
	assert_signal_emitted(rang)


func test_signal_emitted() -> void:
	watch_signals(self)
	assert_signal_emitted(rang)


func test_signal_not_emitted() -> void:
	watch_signals(self)
	rang.emit(1)
	assert_signal_not_emitted(rang)


func test_signal_emit_count() -> void:
	watch_signals(self)
	rang.emit(1)
	assert_signal_emit_count(rang, 2)


func test_signal_parameters() -> void:
	watch_signals(self)
	rang.emit(1)
	assert_signal_emitted_with_parameters(rang, [2])


func test_connected() -> void:
	assert_connected(rang, test_eq)


func test_not_connected() -> void:
	rang.connect(_hear)
	assert_not_connected(rang, _hear)
	rang.disconnect(_hear)


func test_push_error_that_does_not_come() -> void:
	assert_push_error("anything")


func test_push_error_with_another_text() -> void:
	push_error("one thing")
	assert_push_error("another")


func test_push_error_count() -> void:
	push_error("one thing")
	assert_push_error_count(2)


func test_push_warning_that_does_not_come() -> void:
	assert_push_warning("anything")


func test_engine_error_that_does_not_come() -> void:
	assert_engine_error("anything")


func test_one_of_several_parameters(number: int = use_parameters([1, 2, 3])) -> void:
	assert_ne(number, 2)


func test_fail() -> void:
	fail_test("on purpose")


func _hear(_times: int) -> void:
	pass
