extends SceneTree
## Ten minutes of the lesson on angled lines with fifty balls, at eight times the speed: the lesson
## itself in its frame, playing as it does for a student. Nothing may be lost or left over.
##
## Run with: godot --headless --path . -s benchmarks/angled_lines_soak.gd
## [br][br]
## Every way of moving has its share of the time. Ends with exit code 1 where a number is not
## finite, a node has come to be that stays, or a ball was lost by a way that must not lose any:
## position reset does not see a ball that flies over a line within one frame, and shows that.

const MINUTES := 10.0
const SPEED := 8.0
const FIFTY_BALLS := "lab_preset_8"
# Seconds of the lesson until all is made that stays: the past that a step back needs is full.
const WARM_UP := 20.0


func _init() -> void:
	_run.call_deferred()


func _run() -> void:
	var frame := (
		(load("res://scenes/shell/lesson_frame.tscn") as PackedScene).instantiate() as LessonFrame
	)
	frame.lesson_info = LessonIndex.find("angled_lines")
	root.add_child(frame)
	var is_clean := true
	for method: int in SteppingMethods.Method.size():
		if not await _plays_cleanly(frame.lesson, method as SteppingMethods.Method):
			is_clean = false
	frame.free()
	quit(0 if is_clean else 1)


func _plays_cleanly(lesson: Lesson, method: SteppingMethods.Method) -> bool:
	var model: AngledLinesModel = lesson.get("_model")
	var transport := lesson.services[&"transport"] as Transport
	(lesson.services[&"options"] as LessonOptions).preset_picked.emit(FIFTY_BALLS)
	Refusal.push(model.set_method(method))
	Engine.time_scale = SPEED
	transport.is_playing = true
	await _play_until(model, model.elapsed_seconds() + WARM_UP)
	var objects := Performance.get_monitor(Performance.OBJECT_COUNT)
	var nodes := Performance.get_monitor(Performance.OBJECT_NODE_COUNT)
	var begun := model.elapsed_seconds()
	var clock := Time.get_ticks_msec()
	var wanted := MINUTES * 60.0 / SteppingMethods.Method.size()
	await _play_until(model, begun + wanted)
	var speed := wanted * 1000.0 / (Time.get_ticks_msec() - clock)
	var more_objects := Performance.get_monitor(Performance.OBJECT_COUNT) - objects
	var more_nodes := Performance.get_monitor(Performance.OBJECT_NODE_COUNT) - nodes
	transport.is_playing = false
	Engine.time_scale = 1.0
	var not_finite := 0
	for ball: Ball in model.world.balls:
		not_finite += int(not (ball.position.is_finite() and ball.velocity.is_finite()))
	var texts := [
		SteppingMethods.Method.keys()[method],
		wanted,
		speed,
		model.world.bounces,
		model.world.losses,
		not_finite,
		more_objects,
		more_nodes,
	]
	print(
		(
			"%s: %d s at %.1f x, %d bounces, %d lost, %d not finite, %d objects and %d nodes more"
			% texts
		)
	)
	var may_lose := method == SteppingMethods.Method.POSITION_RESET
	return (model.world.losses == 0 or may_lose) and not_finite == 0 and more_nodes <= 0


func _play_until(model: AngledLinesModel, seconds: float) -> void:
	while model.elapsed_seconds() < seconds:
		await process_frame
