extends SceneTree
## How long it takes from a save of the student's file to the changed picture in the lesson, and how
## evenly the lab draws while his code loops for ever in its child. It opens the window as the lab
## does.
## Run with: ./lab bench workshop (without a display it brings one of its own)
## [br][br]
## It draws 60 frames a second, as a screen asks for: without a limit, a processor that draws leaves
## the child no time. A busy machine makes all of it slower, so its load is printed, too (Linux
## only).

const SAVES := 9
const SECONDS := 10.0
## More than the watcher waits from one look to the next.
const PAUSE := 0.35
const FOLDER := "user://bench_workshop"
const HAND_INS := "res://tests/data/hand_ins"
## Lesson, exercise, a wrong hand-in and a right one. The last exercise judges the most.
const EXERCISES: Array[Array] = [
	[&"dot_product", 3, "dot_minus", "right_plain"],
	[&"angled_lines", 10, "step_flies_through", "right_step"],
]
## Each of them holds the child for two seconds and a half.
const LOOPING: PackedStringArray = ["normalized", "normal", "dot", "scalar_projection", "reflect"]
## Frames a second.
const RATE := 60
## A frame that took so many seconds has missed its turn, and the picture stood.
const MISSED := 1.5 / RATE

var _watcher: WorkshopWatcher


func _init() -> void:
	_run.call_deferred()


func _run() -> void:
	DisplayServer.window_set_vsync_mode(DisplayServer.VSYNC_DISABLED)
	Engine.max_fps = RATE
	KeptChoices.file = FOLDER + "_choices.cfg"
	OpeningMotion.is_allowed = false
	_empty_folder()
	_watcher = WorkshopLabWatcher.of(self)
	_watcher.folder = FOLDER
	print("\nWindow %d x %d, %s" % [root.size.x, root.size.y, _renderer()])
	_print_load()
	await _print_times()
	await _print_frames()
	_print_load()
	current_scene.free()
	_watcher.free()
	_empty_folder()
	DirAccess.remove_absolute(FOLDER)
	DirAccess.remove_absolute(KeptChoices.file)
	quit()


func _print_times() -> void:
	print("\nMilliseconds from the save to the picture, medians of %d saves\n" % SAVES)
	print("| exercise | saved | noticed | child starts | judged | answer, drawn | all | worst |")
	print("|---|---|---|---|---|---|---|---|")
	for row in EXERCISES:
		var lesson: StringName = row[0]
		var exercise: int = row[1]
		var wrong: String = row[2]
		var right: String = row[3]
		_save(right)
		await _open(lesson)
		var starts := await _time_of_start()
		var parts_of_wrong: Array[PackedFloat64Array] = []
		var parts_of_right: Array[PackedFloat64Array] = []
		for save: int in SAVES:
			parts_of_wrong.append(await _parts_of_save(exercise, wrong))
			parts_of_right.append(await _parts_of_save(exercise, right))
		_print_row(exercise, wrong, parts_of_wrong, starts)
		_print_row(exercise, right, parts_of_right, starts)


func _print_row(
	exercise: int, hand_in: String, all: Array[PackedFloat64Array], starts: float
) -> void:
	var medians: PackedFloat64Array = []
	for part: int in 4:
		var values: PackedFloat64Array = []
		for parts in all:
			values.append(parts[part])
		medians.append(_median(values))
	var all_of_worst := 0.0
	for parts in all:
		all_of_worst = maxf(all_of_worst, parts[-1])
	var judged := medians[1] - medians[0] - starts
	var numbers := [exercise, hand_in, medians[0], starts, judged, medians[2], medians[3]]
	print("| %d | %s | %.0f | %.0f | %.0f | %.0f | %.0f | %.0f |" % (numbers + [all_of_worst]))


# Until it is noticed, until it is judged, from there to the picture, and all of it.
func _parts_of_save(exercise: int, hand_in: String) -> PackedFloat64Array:
	# So that a save comes at any moment between two looks.
	await create_timer(PAUSE + randf() * WorkshopWatcher.LOOK_EVERY).timeout
	var before := _watcher.report
	var begun := Time.get_ticks_usec()
	_save(hand_in)
	await _watcher.began
	var noticed := Time.get_ticks_usec()
	while _watcher.report == before or not _watcher.report.is_complete:
		await process_frame
	var judged := Time.get_ticks_usec()
	assert(_watcher.report.is_right(exercise) == hand_in.begins_with("right"), hand_in)
	while not _is_current():
		await process_frame
	await RenderingServer.frame_post_draw
	var drawn := Time.get_ticks_usec()
	return PackedFloat64Array(
		[
			(noticed - begun) / 1000.0,
			(judged - begun) / 1000.0,
			(drawn - judged) / 1000.0,
			(drawn - begun) / 1000.0
		]
	)


# Whether the board shows the answer of the file as it is now.
func _is_current() -> bool:
	for answers: OwnAnswer in current_scene.find_children("*", "OwnAnswer", true, false):
		return answers.is_current("dot")
	for flight: OwnFlight in current_scene.find_children("*", "OwnFlight", true, false):
		return flight.is_flying()
	return false


# A child that is to judge nothing: it starts, compiles, and says so.
func _time_of_start() -> float:
	var told := WorkshopReport.new()
	told.leave_open()
	var times: PackedFloat64Array = []
	for start: int in SAVES:
		var begun := Time.get_ticks_usec()
		var child := WorkshopChild.new("judge", FOLDER, told)
		while child.said().is_empty():
			await process_frame
		times.append((Time.get_ticks_usec() - begun) / 1000.0)
		child.stop()
	return _median(times)


func _print_frames() -> void:
	print("\nMilliseconds of the frames in %s s, in lesson 9 with a ball that flies\n" % SECONDS)
	print("| the student's code | frames | median | 99 of 100 | worst | missed |")
	print("|---|---|---|---|---|---|")
	await _open(&"angled_lines")
	for loops: bool in [false, true, false, true]:
		_save("right_plain")
		if loops:
			_save_loops()
		await create_timer(1.0).timeout
		await _print_frame_row("loops for ever" if loops else "is right")


func _print_frame_row(name: String) -> void:
	var options := (current_scene as LessonFrame).lesson.services[&"options"] as LessonOptions
	options.preset_picked.emit("lab_preset_0")
	var transport := (current_scene as LessonFrame).lesson.services[&"transport"] as Transport
	transport.is_playing = true
	var times: PackedFloat64Array = []
	var missed := 0
	var begun := Time.get_ticks_usec()
	var before := begun
	while before - begun < SECONDS * 1e6:
		await process_frame
		var now := Time.get_ticks_usec()
		times.append((now - before) / 1000.0)
		missed += int(now - before > MISSED * 1e6)
		before = now
	transport.is_playing = false
	times.sort()
	print(
		(
			"| %s | %d | %.1f | %.1f | %.1f | %d |"
			% [
				name,
				times.size(),
				_median(times),
				times[int(times.size() * 0.99)],
				times[-1],
				missed
			]
		)
	)


func _open(lesson: StringName) -> void:
	Navigation.open_lesson(self, LessonIndex.find(lesson))
	while not _watcher.report or not _watcher.report.is_complete:
		await process_frame
	await create_timer(PAUSE).timeout


func _save(hand_in: String) -> void:
	for file in DirAccess.get_files_at(HAND_INS.path_join(hand_in)):
		DirAccess.copy_absolute(HAND_INS.path_join(hand_in).path_join(file), FOLDER.path_join(file))


# The child that is ended goes on with the next method, which loops as well.
func _save_loops() -> void:
	var lines := WorkshopFiles.starter("my_vec2.gd").split("\n")
	for at in lines.size():
		for method in LOOPING:
			if lines[at].begins_with("func %s(" % method):
				lines[at] += "\n\twhile true:\n\t\tpass"
	FileAccess.open(FOLDER.path_join("my_vec2.gd"), FileAccess.WRITE).store_string("\n".join(lines))


func _empty_folder() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)
	for file in DirAccess.get_files_at(FOLDER):
		DirAccess.remove_absolute(FOLDER.path_join(file))


func _print_load() -> void:
	var averages := FileAccess.open("/proc/loadavg", FileAccess.READ)
	if averages:
		print(
			"Load of the machine's %d cores: %s" % [OS.get_processor_count(), averages.get_line()]
		)


func _renderer() -> String:
	return RenderingServer.get_video_adapter_name()


static func _median(values: PackedFloat64Array) -> float:
	var sorted := values.duplicate()
	sorted.sort()
	return sorted[sorted.size() >> 1]
