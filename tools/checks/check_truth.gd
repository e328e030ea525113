extends SceneTree
## Looks at a lesson in many states and prints each false line once a kind, with the link that opens
## it; ends with exit code 1 if there is one.
## Usage: tools/commands/true.sh, which says what can be asked for.

# As a student has it on a laptop.
const _WINDOW := Vector2i(1280, 720)

var _states := 2000
var _seed := 1
var _ids: Array[StringName] = []


func _init() -> void:
	OpeningMotion.is_allowed = false
	for argument in OS.get_cmdline_user_args():
		if argument.begins_with("--states="):
			_states = argument.trim_prefix("--states=").to_int()
		elif argument.begins_with("--seed="):
			_seed = argument.trim_prefix("--seed=").to_int()
		else:
			_ids.append(StringName(argument))
	var found := 0
	# The engine sets a small size in the first frame.
	await process_frame
	root.size = _WINDOW
	for id in _ids:
		found += await _look_at(id)
	quit(mini(found, 1))


func _look_at(id: StringName) -> int:
	var frame_scene := load("res://scenes/shell/lesson_frame.tscn") as PackedScene
	var frame := frame_scene.instantiate() as LessonFrame
	frame.lesson_info = LessonIndex.find(id)
	root.add_child(frame)
	current_scene = frame
	await process_frame
	if not frame.lesson:
		print("%s: it could not be opened" % id)
		frame.free()
		return 1
	var begun := Time.get_ticks_msec()
	var errors := LessonFrame.ErrorCatcher.new()
	OS.add_logger(errors)
	# The first one says enough.
	Engine.print_error_messages = false
	var truth := LessonTruth.new(frame)
	# Whoever waits for a silent program ends it.
	truth.step_seen.connect(
		func(step: int) -> void: print("%s: step %d has been looked at" % [id, step])
	)
	await truth.look_at(_states, _seed)
	OS.remove_logger(errors)
	Engine.print_error_messages = true
	var seconds := (Time.get_ticks_msec() - begun) / 1000.0
	print(
		(
			"%s: %d kinds of false lines in %d formulas (%.1f s)"
			% [id, truth.findings.size(), truth.read_count, seconds]
		)
	)
	for finding in truth.findings:
		print("  " + finding.text())
	frame.free()
	if errors.first:
		print("  an error: " + errors.first)
		return truth.findings.size() + 1
	return truth.findings.size()
