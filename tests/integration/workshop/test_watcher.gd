extends LabTest
## The lab's side of the workshop: each save is judged by a child of its own, nothing waits for it,
## and nothing of it is left.

const _FOLDER := "user://workshop_test"
const _RIGHT := "\treturn x * other.x + y * other.y"
const _WRONG := "\treturn x * other.x - y * other.y"
const _LOOP := "\twhile true:\n\t\tpass\n\treturn 0.0"
const _OPEN := "\treturn 0.0"
const _SAVES := 6
const _QUESTIONS := 3000
const _FRAMES := 30
# Calls of the engine that come back only when another process or thread has done something.
const _WAITING: PackedStringArray = [
	"OS.execute(", "OS.delay_", ".wait()", "wait_to_finish(", "read_string_from_stdin(", "get_line("
]
## Frames in which a verdict must have come.
const _PATIENCE := 30_000

var _watcher: WorkshopWatcher


func before_each() -> void:
	DirAccess.make_dir_recursive_absolute(_FOLDER)
	_save(_OPEN)
	_watcher = WorkshopWatcher.new()
	_watcher.folder = _FOLDER
	add_child(_watcher)


func after_each() -> void:
	_watcher.free()
	for file in DirAccess.get_files_at(_FOLDER):
		DirAccess.remove_absolute(_FOLDER.path_join(file))


func test_each_save_is_followed_by_its_verdict() -> void:
	await _verdict()
	for save in _SAVES:
		var is_right := save % 2 == 1
		_save(_RIGHT if is_right else _WRONG)
		var verdict := await _verdict()
		assert_eq(verdict.is_right(), is_right, "save %d: %s" % [save, verdict.sentence])


func test_starters_are_open_without_a_child() -> void:
	await _verdict()
	assert_eq(_watcher.child_id(), -1)
	for exercise: int in 12:
		assert_eq(_watcher.report.verdict(exercise).kind, WorkshopVerdict.Kind.OPEN)
	_save(_WRONG)
	await _verdict()
	assert_gt(_watcher.child_id(), 0)


func test_a_loop_stops_neither_the_lab_nor_the_other_exercises() -> void:
	await _verdict()
	_save(_LOOP)
	await _verdict()
	var verdict := _watcher.report.verdict(3)
	assert_eq(verdict.kind, WorkshopVerdict.Kind.ENDLESS)
	assert_eq(verdict.probe, "(7, 1) · (8, -6)")
	for exercise: int in [2, 4, 9, 11]:
		assert_eq(_watcher.report.verdict(exercise).kind, WorkshopVerdict.Kind.OPEN)


func test_no_child_is_left_when_the_watcher_goes_while_his_code_hangs() -> void:
	await _verdict()
	_save(_LOOP)
	_watcher.check_now()
	await get_tree().process_frame
	var child := _watcher.child_id()
	assert_true(OS.is_process_running(child))
	remove_child(_watcher)
	OS.delay_msec(300)
	# The engine does not know a child any more that it has ended: so the system is asked.
	assert_ne(OS.execute("kill", ["-0", str(child)]), 0)


# No signal reaches a process that stands still, but the one that ends it.
func test_a_child_that_stands_still_does_not_hold_up_the_lab() -> void:
	_save(_WRONG)
	await _verdict()
	assert_eq(OS.execute("kill", ["-STOP", str(_watcher.child_id())]), 0)
	watch_signals(_watcher)
	# More than its pipe takes.
	for question: int in _QUESTIONS:
		_watcher.ask("dot", PackedFloat64Array([question, 2.0, 3.0, 4.0]))
	for frame in _FRAMES:
		await get_tree().process_frame
	assert_signal_not_emitted(_watcher, "answered")
	assert_true(OS.is_process_running(_watcher.child_id()))
	_save(_RIGHT)
	assert_true((await _verdict()).is_right(), "the next save has a child of its own")


func test_nothing_that_the_lab_calls_waits() -> void:
	var scripts := SourceCode.files_below("res://scenes/workshop", ["gd"])
	for script: String in ["child.gd", "watcher.gd", "files.gd", "report.gd"]:
		scripts.append("res://workshop/kit/" + script)
	for path in scripts:
		var code := FileAccess.get_file_as_string(path)
		assert_ne(code, "", path)
		for waiting in _WAITING:
			assert_false(code.contains(waiting), "%s calls %s" % [path, waiting])


func test_the_student_s_method_answers_for_other_numbers() -> void:
	_save(_WRONG)
	await _verdict()
	var question := _watcher.ask("dot", PackedFloat64Array([0.1, 2.0, 3.0, 4.0]))
	var told: Array = await _watcher.answered
	# It must not be freed while it tells.
	await get_tree().process_frame
	var number: int = told[0]
	var numbers: PackedFloat64Array = told[1]
	assert_eq(number, question)
	assert_eq(numbers, PackedFloat64Array([0.1 * 3.0 - 2.0 * 4.0]))


func test_the_files_of_the_student_stay_as_they_are() -> void:
	var own := "# mine\n"
	FileAccess.open(_FOLDER.path_join("my_line.gd"), FileAccess.WRITE).store_string(own)
	WorkshopFiles.put_starters(_FOLDER)
	assert_eq(FileAccess.get_file_as_string(_FOLDER.path_join("my_line.gd")), own)
	for file in WorkshopFiles.starters():
		assert_true(FileAccess.file_exists(_FOLDER.path_join(file)), file)
	assert_eq(WorkshopFiles.put_starters(_FOLDER), PackedStringArray())


func _save(body: String) -> void:
	var text := WorkshopFiles.starter("my_vec2.gd")
	text = text.replace(
		"(other: MyVec2) -> float:\n\treturn 0.0", "(other: MyVec2) -> float:\n" + body
	)
	FileAccess.open(_FOLDER.path_join("my_vec2.gd"), FileAccess.WRITE).store_string(text)


# The verdict on the dot product as the file is now.
func _verdict() -> WorkshopVerdict:
	_watcher.check_now()
	_watcher.report = null
	for frame in _PATIENCE:
		await get_tree().process_frame
		OS.delay_msec(2)
		if _watcher.report and _watcher.report.is_complete:
			return _watcher.report.verdict(3)
	return WorkshopVerdict.new()
