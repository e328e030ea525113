extends SceneTree
## How many frames a second the lesson on angled lines draws while its balls fly, and the game in
## some of its levels, and what a frame costs: opens the window as the lab does, and once more
## without what [SoftwareDrawing] saves.
##
## Run with: ./lab bench frame_rate (without a display it brings one of its own)
## [br][br]
## V-sync is off, so that a screen's own rate is no limit. Each situation is played three times; the
## processor's time, of all threads of this process, hardly depends on who else uses the machine
## (Linux only).

const RUNS := 3
const SECONDS := 4.0
const WARM_UP := 30
const FRAME := 1.0 / 60.0

## The lesson's presets with 1, 10 and 50 balls.
const PRESETS: Dictionary[int, int] = {1: 0, 10: 7, 50: 8}

## Levels of the game by what is seen: nothing moves; a target; a target and a plan; a bullet, too.
const LEVELS: Dictionary[String, Dictionary] = {
	"1, at rest": {level = 1},
	"2, the target moves": {level = 2},
	"7, with helpers": {level = 7, aims = true, leads = true, bounces = true},
	"3, a bullet flies": {level = 3, angle = -45.0},
}

var _frame: LessonFrame
var _lesson: Lesson


func _init() -> void:
	_run.call_deferred()


func _run() -> void:
	DisplayServer.window_set_vsync_mode(DisplayServer.VSYNC_DISABLED)
	# The barrel of the game would swing.
	OpeningMotion.is_allowed = false
	print("\nWindow %d x %d, %s" % [root.size.x, root.size.y, _renderer()])
	print("%d runs of %s s each; milliseconds per frame are averages" % [RUNS, SECONDS])
	await _print_table("As the lab draws it here")
	if SoftwareDrawing.is_on:
		SoftwareDrawing.is_on = false
		await _print_table("As it is drawn on a graphics card")
	quit()


func _open_lesson(info: LessonInfo) -> void:
	if _frame:
		_frame.free()
	_frame = (load("res://scenes/shell/lesson_frame.tscn") as PackedScene).instantiate()
	_frame.lesson_info = info
	root.add_child(_frame)
	_lesson = _frame.lesson


func _print_table(title: String) -> void:
	_open_lesson(LessonIndex.find("angled_lines"))
	print("\n%s\n" % title)
	print(
		"| balls | frames a second, best | worst | processor ms, best run | script, ms of 1/60 s |"
	)
	print("|---|---|---|---|---|")
	for count: int in PRESETS:
		await _print_row(count)
	await _print_game()


# A bullet that is gone is fired again.
func _print_game() -> void:
	_open_lesson(LessonIndex.game())
	print("\n| level | frames a second, best | worst | processor ms, best run |")
	print("|---|---|---|---|")
	var model: AimingGameModel = _lesson.get(&"_model")
	var first := _lesson.link_state()
	for title in LEVELS:
		var fires := title.ends_with("flies")
		var fire := func() -> void:
			if fires:
				model.fire()
		process_frame.connect(fire)
		var rates: PackedFloat64Array = []
		var costs: PackedFloat64Array = []
		for run: int in RUNS:
			_lesson.show_link(first.merged(LEVELS[title], true))
			for frame: int in WARM_UP:
				await process_frame
			await _measure(rates, costs)
		process_frame.disconnect(fire)
		rates.sort()
		costs.sort()
		print("| %s | %.0f | %.0f | %.1f |" % [title, rates[-1], rates[0], costs[0]])


func _print_row(count: int) -> void:
	var rates: PackedFloat64Array = []
	var costs: PackedFloat64Array = []
	for run: int in RUNS:
		var options := _lesson.services[&"options"] as LessonOptions
		options.preset_picked.emit("lab_preset_%d" % PRESETS[count])
		(_lesson.services[&"transport"] as Transport).is_playing = true
		for frame: int in WARM_UP:
			await process_frame
		await _measure(rates, costs)
	rates.sort()
	costs.sort()
	var script := (_lesson.get_node(^"%Player") as AngledLinesPlayer).meter.milliseconds
	var share := script / FRAME / 10.0
	print(
		(
			"| %d | %.0f | %.0f | %.1f | %.2f = %.1f %% |"
			% [count, rates[-1], rates[0], costs[0], script, share]
		)
	)


func _measure(rates: PackedFloat64Array, costs: PackedFloat64Array) -> void:
	var start := Time.get_ticks_usec()
	var processor := _processor_milliseconds()
	var frames := 0
	while Time.get_ticks_usec() - start < SECONDS * 1e6:
		await process_frame
		frames += 1
	rates.append(frames * 1e6 / (Time.get_ticks_usec() - start))
	costs.append((_processor_milliseconds() - processor) / frames)


func _renderer() -> String:
	return RenderingServer.get_video_adapter_name()


# The kernel counts nanoseconds for each thread.
func _processor_milliseconds() -> float:
	var sum := 0.0
	for thread: String in DirAccess.get_directories_at("/proc/self/task"):
		var file := FileAccess.open("/proc/self/task/%s/schedstat" % thread, FileAccess.READ)
		if file:
			sum += file.get_line().get_slice(" ", 0).to_float() / 1e6
	return sum
