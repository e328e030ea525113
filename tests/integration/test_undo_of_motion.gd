extends ScreenTest
## What moves by itself is a change, too: undo leads back to where it began, and redo to where it
## had come.

const _FRAMES := 20


func test_undo_and_redo_of_a_run_in_every_lesson() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		if not lesson.needs.has("transport"):
			continue
		await open_lesson(lesson)
		var before := frame().lesson.state()
		await _run()
		var after := frame().lesson.state()
		await student.press(&"lab_undo")
		assert_eq(frame().lesson.state(), before, "undo in %s" % lesson.id)
		if after != before:
			await student.press(&"lab_redo")
			assert_eq(frame().lesson.state(), after, "redo in %s" % lesson.id)
		screen().free()


func test_a_run_after_a_drag_is_a_change_of_its_own() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	await student.click_at(_place(2, 6))
	var dragged := frame().lesson.state()
	await _run()
	assert_ne(frame().lesson.state(), dragged)
	await student.press(&"lab_undo")
	assert_eq(frame().lesson.state(), dragged)


func test_a_run_that_was_paused_and_stepped_is_one_change() -> void:
	await open_lesson(LessonIndex.find(&"angled_lines"))
	var start := frame().lesson.state()
	await _run()
	await student.press(&"lab_next_frame")
	await student.press(&"lab_next_frame")
	await _run()
	var end := frame().lesson.state()
	await student.press(&"lab_undo")
	assert_eq(frame().lesson.state(), start)
	assert_true(Screen.button(screen(), "Undo").disabled)
	await student.press(&"lab_redo")
	assert_eq(frame().lesson.state(), end)


func test_undo_while_time_runs_stops_it_and_takes_the_run_back() -> void:
	await open_lesson(LessonIndex.find(&"angled_lines"))
	await student.press(&"lab_preset_3")
	var picked := frame().lesson.state()
	await student.press(&"lab_pause")
	await _wait()
	await student.press(&"lab_undo")
	assert_eq(frame().lesson.state(), picked)
	await _wait()
	assert_eq(frame().lesson.state(), picked, "time stands still")


func test_a_change_while_time_runs_keeps_the_run_apart() -> void:
	await open_lesson(LessonIndex.find(&"angled_lines"))
	await student.press(&"lab_pause")
	await _wait()
	await student.press(&"lab_preset_3")
	await student.press(&"lab_pause")
	await student.press(&"lab_undo")
	await student.press(&"lab_undo")
	assert_gt(_frames(), 0, "the run is still there")
	await student.press(&"lab_undo")
	assert_eq(_frames(), 0)


func test_a_single_frame_can_be_undone() -> void:
	await open_lesson(LessonIndex.find(&"angled_lines"))
	await student.press(&"lab_next_frame")
	assert_eq(_frames(), 1)
	await click_button("Undo")
	assert_eq(_frames(), 0)
	await click_button("Redo")
	assert_eq(_frames(), 1)


func test_a_jump_on_the_timeline_can_be_undone() -> void:
	await open_lesson(LessonIndex.find(&"angled_lines"))
	var options := frame().lesson.services[&"options"] as LessonOptions
	options.chosen.emit("method", SteppingMethods.Method.EVENT_WORLD)
	var before := frame().lesson.state()
	await student.press(&"lab_next_impact")
	assert_gt(_frames(), 0)
	await student.press(&"lab_undo")
	assert_eq(frame().lesson.state(), before)


func test_lost_balls_that_were_fetched_can_be_lost_again() -> void:
	await open_lesson(LessonIndex.find(&"angled_lines"))
	frame().follow_link("#angled_lines?lines=&balls=900,0,1,0,12")
	var lost := frame().lesson.state()
	await student.press(&"lab_fetch_balls")
	assert_ne(frame().lesson.state(), lost)
	await student.press(&"lab_undo")
	assert_eq(frame().lesson.state(), lost)


func _run() -> void:
	await student.press(&"lab_pause")
	await _wait()
	await student.press(&"lab_pause")


func _wait() -> void:
	for i: int in _FRAMES:
		await student.window.get_tree().process_frame


func _frames() -> int:
	var model: AngledLinesModel = frame().lesson.get(&"_model")
	return model.world.frames


func _place(x: float, y: float) -> Vector2:
	var lesson := frame().lesson
	return lesson.get_global_transform() * lesson.board.to_screen(Vec2.new(x, y))
