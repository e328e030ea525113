extends "error_asserts.gd"
## The base of all tests, with the part of GUT's GutTest that Vec2 Lab's tests use.

const GutParameterHandler := preload("parameter_handler.gd")


func should_skip_script() -> Variant:
	return false


func before_all() -> void:
	pass


func before_each() -> void:
	pass


func after_each() -> void:
	pass


func after_all() -> void:
	pass


## As the default of a test's parameter: runs the test once for each of the values.
func use_parameters(values: Array) -> Variant:
	if gut.parameter_handler == null:
		gut.parameter_handler = GutParameterHandler.new(values)
	return gut.parameter_handler.next_value()


func autofree(thing: Variant) -> Variant:
	var object: Object = thing
	gut.free_after_test(object)
	return thing


func autoqfree(thing: Variant) -> Variant:
	var node: Node = thing
	gut.queue_free_after_test(node)
	return thing


func add_child_autofree(thing: Variant, legible_name: Variant = false) -> Variant:
	_gut_add(thing, legible_name)
	return autofree(thing)


func add_child_autoqfree(thing: Variant, legible_name: Variant = false) -> Variant:
	_gut_add(thing, legible_name)
	return autoqfree(thing)


func wait_seconds(seconds: Variant, _text: Variant = "") -> void:
	await wait_until(func() -> bool: return false, seconds)


## Returns when that many frames have been drawn in full.
func wait_process_frames(count: Variant, _text: Variant = "") -> void:
	for frame: int in count + 1:
		await get_tree().process_frame


func wait_physics_frames(count: Variant, _text: Variant = "") -> void:
	for frame: int in count + 1:
		await get_tree().physics_frame


func wait_idle_frames(count: Variant, text: Variant = "") -> void:
	await wait_process_frames(count, text)


## True when the signal came in time.
func wait_for_signal(awaited: Signal, most_seconds: Variant, text: Variant = "") -> bool:
	watch_signals(awaited.get_object())
	var before := get_signal_emit_count(awaited)
	var has_come := func() -> bool: return get_signal_emit_count(awaited) > before
	return await wait_until(has_come, most_seconds, text)


## True when the condition came true in time. Time is that of the physics frames, as in GUT.
func wait_until(condition: Variant, most_seconds: Variant, _text: Variant = "") -> bool:
	var is_true: Callable = condition
	var seconds: float = most_seconds
	while not is_true.call():
		if seconds <= 0.0:
			return false
		await get_tree().physics_frame
		seconds -= get_physics_process_delta_time()
	return true


func _gut_add(thing: Variant, legible_name: Variant) -> void:
	var node: Node = thing
	var legible: bool = legible_name
	add_child(node, legible)
