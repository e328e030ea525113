extends SceneTree
## Looks at lessons in windows of many sizes and prints, for each size, the smallest target, the
## smallest text, and what overlaps, is cut off or moves; ends with exit code 1 if there is
## anything. Usage: tools/commands/layout.sh, which says what can be asked for.

const SIZES: Array[Vector2i] = [
	Vector2i(390, 844),
	Vector2i(844, 390),
	Vector2i(720, 1280),
	Vector2i(800, 600),
	Vector2i(1280, 720),
	Vector2i(1920, 1080),
	Vector2i(3840, 2160),
]

var _states := 12
var _text := 1.0
var _sizes: Array[Vector2i] = SIZES
var _ids: PackedStringArray = []


func _init() -> void:
	OpeningMotion.is_allowed = false
	CallTimer.is_measuring = false
	for argument in OS.get_cmdline_user_args():
		var value := argument.get_slice("=", 1)
		if argument.begins_with("--states="):
			_states = value.to_int()
		elif argument.begins_with("--text="):
			_text = value.to_float()
		elif argument.begins_with("--size="):
			_sizes = [Vector2i(value.get_slice("x", 0).to_int(), value.get_slice("x", 1).to_int())]
		else:
			_ids.append(argument)
	KeptChoices.file = "user://choices_in_checks.cfg"
	KeptChoices.keep("text_size", _text)
	var found := 0
	# The engine sets the window's size in the first frame.
	await process_frame
	for size in _sizes:
		found += await _look_at(size)
	DirAccess.remove_absolute(KeptChoices.file)
	quit(mini(found, 1))


func _look_at(size: Vector2i) -> int:
	root.size = size
	var survey := LayoutSurvey.new()
	for id in _ids:
		var frame_scene := load("res://scenes/shell/lesson_frame.tscn") as PackedScene
		var frame := frame_scene.instantiate() as LessonFrame
		frame.lesson_info = LessonIndex.find(id)
		root.add_child(frame)
		current_scene = frame
		await survey.look_at(frame, id, _states)
		frame.free()
	print("%dx%d, text %s:" % [size.x, size.y, _text])
	print("  smallest target %.1f px: %s" % [survey.smallest_target, survey.smallest_target_name])
	print("  smallest text %.1f px: %s" % [survey.smallest_text, survey.smallest_text_name])
	for problem in survey.problems:
		print("  %s (%s)" % [problem, survey.problems[problem]])
	return survey.problems.size()
