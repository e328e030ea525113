extends SceneTree
## Looks at lessons in windows of many sizes and prints, for each size, the smallest target, the
## smallest text, and what overlaps, is cut off or moves; ends with exit code 1 if there is
## anything. A lesson with exercises is open as for a student with a wrong answer, and with a right
## one. Usage: tools/commands/layout.sh, which says what can be asked for.

const SIZES: Array[Vector2i] = [
	Vector2i(390, 844),
	Vector2i(844, 390),
	Vector2i(720, 1280),
	Vector2i(800, 600),
	Vector2i(1280, 720),
	Vector2i(1920, 1080),
	Vector2i(3840, 2160),
]

const _HAND_INS := "res://tests/data/hand_ins"
# Where the lab looks for the student's files.
const _DESK := "user://desk_in_checks"
## Hand-ins which together have all exercises right.
const RIGHT: PackedStringArray = ["right_step", "right_plain", "right_segment", "right_aim"]
## For each lesson with exercises a hand-in with something wrong, which is told with its numbers.
const WRONG: Dictionary[String, String] = {
	"normals": "normal_not_unit",
	"dot_product": "dot_unknown",
	"line_distance": "distance_from_start",
	"point_of_impact": "reset_up",
	"reflection": "reflect_tangent",
	"angled_lines": "step_rest_lost",
	"line_ends": "segment_at_new",
	"lead_target": "lead_one_step",
	"ballistic_aim": "arc_straight",
	"bank_shot": "bank_plain_mirror",
}

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
	WorkshopLabWatcher.of(self).free()
	_clear_desk()
	DirAccess.remove_absolute(_DESK)
	quit(mini(found, 1))


func _look_at(size: Vector2i) -> int:
	root.size = size
	var survey := LayoutSurvey.new()
	for id in _ids:
		var hand_in: String = WRONG.get(id, "")
		var frame := await _open(id, [hand_in] if hand_in else [])
		await survey.look_at(frame, id, _states)
		_leave(frame)
		if hand_in:
			frame = await _open(id, RIGHT)
			await survey.look_at(frame, id + ", all right", 0, false)
			_leave(frame)
	print("%dx%d, text %s:" % [size.x, size.y, _text])
	print("  smallest target %.1f px: %s" % [survey.smallest_target, survey.smallest_target_name])
	print("  smallest text %.1f px: %s" % [survey.smallest_text, survey.smallest_text_name])
	for problem in survey.problems:
		print("  %s (%s)" % [problem, survey.problems[problem]])
	return survey.problems.size()


# As a student has it who has written what is in these hand-ins.
func _open(id: String, hand_ins: PackedStringArray) -> LessonFrame:
	_clear_desk()
	for hand_in in hand_ins:
		for file in DirAccess.get_files_at(_HAND_INS.path_join(hand_in)):
			var from := _HAND_INS.path_join(hand_in).path_join(file)
			DirAccess.copy_absolute(from, _DESK.path_join(file))
	var watcher := WorkshopLabWatcher.of(self)
	watcher.folder = _DESK
	watcher.report = null
	watcher.check_now()
	Navigation.open_lesson(self, LessonIndex.find(id))
	while not current_scene or hand_ins and not (watcher.report and watcher.report.is_complete):
		await process_frame
		OS.delay_msec(2)
	return current_scene as LessonFrame


# The next time it is as at its start.
func _leave(frame: LessonFrame) -> void:
	frame.free()
	LessonBoards.forget_all()


func _clear_desk() -> void:
	DirAccess.make_dir_recursive_absolute(_DESK)
	for file in DirAccess.get_files_at(_DESK):
		DirAccess.remove_absolute(_DESK.path_join(file))
