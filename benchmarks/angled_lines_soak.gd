extends SceneTree
## Ten minutes of the lesson on angled lines with fifty balls, at eight times the speed: the lesson
## itself in its frame, playing as it does for a student. Nothing may be lost or left over.
##
## Run with: godot --headless --path . -s benchmarks/angled_lines_soak.gd
## [br][br]
## Every way of moving has its share of the time. Ends with exit code 1 where a ball was lost, a
## number is not finite, or objects or nodes have come to be that stay.

const MINUTES := 10.0
const SPEED := 8.0
const FIFTY_BALLS := "8"
# The board is settled, and what is made once has been made.
const WARM_UP := 120


func _init() -> void:
	_run.call_deferred()


func _run() -> void:
	var frame := (
		(load("res://scenes/shell/lesson_frame.tscn") as PackedScene).instantiate() as LessonFrame
	)
	frame.lesson_info = LessonIndex.find("angled_lines")
	root.add_child(frame)
	var is_clean := true
	for method: int in SteppedWorld.Method.size():
		if not await _plays_cleanly(frame.lesson, method as SteppedWorld.Method):
			is_clean = false
	frame.free()
	quit(0 if is_clean else 1)


func _plays_cleanly(lesson: Lesson, method: SteppedWorld.Method) -> bool:
	var model: AngledLinesModel = lesson.get("_model")
	var transport := lesson.services[&"transport"] as Transport
	(lesson.services[&"options"] as LessonOptions).preset_picked.emit(FIFTY_BALLS)
	model.set_method(method)
	Engine.time_scale = SPEED
	transport.is_playing = true
	await _pass_frames(WARM_UP)
	var objects := Performance.get_monitor(Performance.OBJECT_COUNT)
	var nodes := Performance.get_monitor(Performance.OBJECT_NODE_COUNT)
	var begun := model.elapsed_seconds()
	var clock := Time.get_ticks_msec()
	var wanted := MINUTES * 60.0 / SteppedWorld.Method.size()
	while model.elapsed_seconds() - begun < wanted:
		await process_frame
	var speed := wanted * 1000.0 / (Time.get_ticks_msec() - clock)
	transport.is_playing = false
	Engine.time_scale = 1.0
	await _pass_frames(WARM_UP)
	var more_objects := Performance.get_monitor(Performance.OBJECT_COUNT) - objects
	var more_nodes := Performance.get_monitor(Performance.OBJECT_NODE_COUNT) - nodes
	var not_finite := 0
	for ball: Ball in model.world.balls:
		not_finite += int(not (ball.position.is_finite() and ball.velocity.is_finite()))
	var texts := [
		SteppedWorld.Method.keys()[method],
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
	return model.world.losses == 0 and not_finite == 0 and more_nodes == 0


func _pass_frames(count: int) -> void:
	for index: int in count:
		await process_frame
