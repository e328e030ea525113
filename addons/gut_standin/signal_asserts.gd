extends "text_and_object_asserts.gd"
## Asserts about signals. GUT takes a signal as `object, "name"` or as `object.name`; so does this.

const GutSignalWatcher := preload("signal_watcher.gd")

var _gut_watcher := GutSignalWatcher.new()


func watch_signals(object: Variant) -> void:
	var watched: Object = object
	_gut_watcher.watch(watched)


func clear_signal_watcher() -> void:
	_gut_watcher.forget_all()


func get_signal_emit_count(p1: Variant, p2: Variant = null) -> int:
	var asked := _gut_signal_and_rest([p1, p2])
	return _gut_watcher.emissions(asked.object, asked.name).size()


func assert_has_signal(object: Variant, signal_name: Variant, text: Variant = "") -> void:
	var asked := _gut_signal_and_rest([object, signal_name])
	_gut_check(asked.object.has_signal(asked.name), "%s expected to be there: %s" % [asked, text])


func assert_connected(emitter: Variant, receiver: Variant, p3: Variant = null) -> void:
	var said := "expected %s to be connected to %s" % [emitter, receiver]
	_gut_check(_gut_is_connected(emitter, receiver, p3), said)


func assert_not_connected(emitter: Variant, receiver: Variant, p3: Variant = null) -> void:
	var said := "expected %s to not be connected to %s" % [emitter, receiver]
	_gut_check(not _gut_is_connected(emitter, receiver, p3), said)


func assert_signal_emitted(p1: Variant, p2: Variant = "", p3: Variant = "") -> void:
	var asked := _gut_signal_and_rest([p1, p2, p3])
	if _gut_is_watched(asked):
		_gut_check(_gut_count(asked) > 0, "%s: expected to be emitted: %s" % [asked, asked.rest[0]])


func assert_signal_not_emitted(p1: Variant, p2: Variant = "", p3: Variant = "") -> void:
	var asked := _gut_signal_and_rest([p1, p2, p3])
	if _gut_is_watched(asked):
		_gut_check(
			_gut_count(asked) == 0, "%s: expected not to be emitted: %s" % [asked, asked.rest[0]]
		)


func assert_signal_emit_count(p1: Variant, p2: Variant, p3: Variant = 0, p4: Variant = "") -> void:
	var asked := _gut_signal_and_rest([p1, p2, p3, p4])
	if _gut_is_watched(asked):
		var wanted: int = asked.rest[0]
		_gut_check(
			_gut_count(asked) == wanted,
			"%s: emitted %d times, expected %d" % [asked, _gut_count(asked), wanted]
		)


func assert_signal_emitted_with_parameters(
	p1: Variant, p2: Variant, p3: Variant = -1, p4: Variant = -1
) -> void:
	var asked := _gut_signal_and_rest([p1, p2, p3, p4])
	if not _gut_is_watched(asked):
		return
	var emissions := _gut_watcher.emissions(asked.object, asked.name)
	var index: int = asked.rest[1]
	if emissions.is_empty():
		fail_test("%s: expected to be emitted" % asked)
		return
	var got: Array = emissions[index]
	_gut_check(got == asked.rest[0], "%s: got %s, expected %s" % [asked, got, asked.rest[0]])


func _gut_is_watched(asked: GutAskedSignal) -> bool:
	if not _gut_watcher.is_watching(asked.object):
		fail_test("%s is not watched; call watch_signals first" % asked.object)
		return false
	if not asked.object.has_signal(asked.name):
		fail_test("%s has no signal '%s'" % [asked.object, asked.name])
		return false
	return true


func _gut_count(asked: GutAskedSignal) -> int:
	return _gut_watcher.emissions(asked.object, asked.name).size()


func _gut_is_connected(emitter: Variant, receiver: Variant, signal_name: Variant) -> bool:
	var asked := _gut_signal_and_rest([emitter, signal_name])
	for connection: Dictionary in asked.object.get_signal_connection_list(asked.name):
		var callable: Callable = connection["callable"]
		if callable == receiver or callable.get_object() == receiver:
			return true
	return false


func _gut_signal_and_rest(arguments: Array) -> GutAskedSignal:
	var asked := GutAskedSignal.new()
	if arguments[0] is Signal:
		var given: Signal = arguments[0]
		asked.object = given.get_object()
		asked.name = given.get_name()
		asked.rest = arguments.slice(1)
	else:
		asked.object = arguments[0]
		asked.name = str(arguments[1])
		asked.rest = arguments.slice(2)
	return asked


class GutAskedSignal:
	var object: Object
	var name := &""
	## The arguments after the signal.
	var rest: Array = []

	func _to_string() -> String:
		return "signal '%s' of %s" % [name, object]
