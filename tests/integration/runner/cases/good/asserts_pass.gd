extends "res://addons/gut/test.gd"
## Every assert that the project's tests use, each used rightly.

signal rang(times: int)

var _before_all_ran := false


func before_all() -> void:
	_before_all_ran = true
	assert_true(_before_all_ran)


func test_equal() -> void:
	assert_eq(3, 3)
	assert_eq("a", &"a")
	assert_eq([1, 2], [1, 2])
	assert_eq({"a": 1}, {"a": 1})
	assert_ne(3, 4)
	assert_ne(NAN, NAN)


func test_order() -> void:
	assert_gt(2, 1)
	assert_gte(2, 2)
	assert_lt(1, 2)
	assert_lte(2, 2)
	assert_between(2, 1, 2)


func test_near() -> void:
	assert_almost_eq(1.0, 1.25, 0.25)
	assert_almost_ne(1.0, 1.5, 0.25)
	assert_almost_eq(Vector2(1, 2), Vector2(1.5, 2), Vector2(0.5, 0))


func test_true_and_null() -> void:
	assert_true(true)
	assert_false(false)
	assert_null(null)
	assert_not_null(0)


func test_same() -> void:
	var list := [1]
	assert_same(list, list)
	assert_not_same(list, [1])


func test_collection() -> void:
	assert_has([1, 2], 2)
	assert_does_not_have({"a": 1}, "b")


func test_text() -> void:
	assert_string_contains("abc", "b")
	assert_string_contains("abc", "B", false)
	assert_string_starts_with("abc", "ab")
	assert_string_ends_with("abc", "bc")


func test_object() -> void:
	var node: Node = add_child_autofree(Node.new())
	assert_is(node, Node)
	assert_has_method(node, "queue_free")
	assert_not_freed(node)
	assert_no_new_orphans()
	var gone := Node.new()
	gone.free()
	assert_freed(gone)
	assert_ne(gone, node)


func test_file() -> void:
	assert_file_exists("res://project.godot")
	assert_file_does_not_exist("res://nowhere")


func test_signal() -> void:
	watch_signals(self)
	assert_signal_not_emitted(rang)
	rang.emit(1)
	rang.emit(2)
	assert_has_signal(self, "rang")
	assert_signal_emitted(rang)
	assert_signal_emitted(self, "rang")
	assert_signal_emit_count(rang, 2)
	assert_signal_emit_count(self, "rang", 2)
	assert_signal_emitted_with_parameters(rang, [2])
	assert_signal_emitted_with_parameters(self, "rang", [1], 0)
	var count: int = get_signal_emit_count(rang)
	assert_eq(count, 2)


func test_connection() -> void:
	var listener := func(_times: int) -> void: pass
	rang.connect(listener)
	assert_connected(rang, listener)
	rang.disconnect(listener)
	assert_not_connected(rang, listener)


func test_expected_messages() -> void:
	push_error("the value is 7, allowed is 0 to 1")
	push_error("again")
	push_warning("mind the gap")
	assert_push_error("allowed is 0 to 1")
	assert_push_error_count(2)
	assert_push_warning("gap")


func test_expected_engine_error() -> void:
	var nothing: Node = null
	_ask_name(nothing)
	assert_engine_error("name")


func test_waiting() -> void:
	await wait_process_frames(2)
	await wait_physics_frames(2)
	await wait_seconds(0.01)
	var became_true: bool = await wait_until(func() -> bool: return true, 1.0)
	assert_true(became_true)
	var never_true: bool = await wait_until(func() -> bool: return false, 0.05)
	assert_false(never_true)
	get_tree().create_timer(0.05).timeout.connect(rang.emit.bind(3))
	var has_come: bool = await wait_for_signal(rang, 5.0)
	assert_true(has_come)


func test_parameters(number: int = use_parameters([1, 2, 3])) -> void:
	assert_between(number, 1, 3)


func test_pass() -> void:
	pass_test("nothing to compare")


func _ask_name(node: Node) -> void:
	print(node.name)


class TestInside:
	extends "res://addons/gut/test.gd"

	func test_inner_classes_run() -> void:
		assert_true(true)
