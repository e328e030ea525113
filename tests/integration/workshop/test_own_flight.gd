extends DeskTest
## The student's own `step` flies a ball among the lines of the lesson, beside the lab's.

const _FRAMES := 20
# Frames in which the lab's ball has bounced in the first scene.
const _MANY_FRAMES := 90
# The right hand-in takes its lines as endless. So it is right for the lines of the lesson, too.
const _TEST := "if t <= 1.0 and t < first:"
const _TEST_OF_ENDS := """var along: MyVec2 = line.end.minus(line.start)
				var at := ball.position.plus(motion.scaled(t)).minus(line.start)
				var share := at.dot(along) / along.dot(along)
				if t <= 1.0 and t < first and share >= 0.0 and share <= 1.0:"""


func test_a_right_step_flies_as_the_lab_does() -> void:
	await _fly("right_step")
	await _save_bounce(_TEST, _TEST_OF_ENDS)
	for frame_number in _MANY_FRAMES:
		await student.press(&"lab_next_frame")
		await wait_for(_flight().is_current)
		assert_vec2(_place(), _place_of_lab(), 1e-3)
	assert_gt(_place().distance_to(_start()), 1.0)


func test_one_that_flies_through_the_lines_leaves_the_lab_s_ball() -> void:
	await _fly("step_flies_through")
	await student.press(&"lab_pause")
	for frame_number in _MANY_FRAMES:
		await get_tree().process_frame
		OS.delay_msec(16)
	await student.press(&"lab_pause")
	await wait_for(_flight().is_current)
	assert_gt(_place().distance_to(_place_of_lab()), 10.0)


func test_a_frame_back_takes_it_back() -> void:
	await _fly("right_step")
	await student.press(&"lab_next_frame")
	await wait_for(_flight().is_current)
	var before := _flight().ball()
	await student.press(&"lab_next_frame")
	await wait_for(_flight().is_current)
	assert_ne(_flight().ball(), before)
	await student.press(&"lab_previous_frame")
	assert_eq(_flight().ball(), before)


func test_it_starts_anew_when_the_lesson_does() -> void:
	await _fly("right_step")
	var start := _flight().ball()
	for frame_number in _FRAMES:
		await student.press(&"lab_next_frame")
	await wait_for(_flight().is_current)
	assert_ne(_flight().ball(), start)
	await student.press(&"lab_reset")
	assert_eq(_flight().ball(), start)


func test_it_waits_while_the_lesson_asks_where_the_ball_touches() -> void:
	await _fly("right_step")
	await student.press(&"lab_next_frame")
	await wait_for(_flight().is_current)
	await student.press(&"lab_next_step")
	assert_true((frame().lesson.get_node("%Guess") as Guess).visible)
	assert_false(_flight().visible)
	await student.press(&"lab_next_step")
	assert_true(_flight().visible)


func test_undo_and_links_know_nothing_of_it() -> void:
	await _fly("right_step")
	await student.press(&"lab_next_frame")
	await wait_for(_flight().is_current)
	await student.press(&"lab_undo")
	assert_true(Screen.button(screen(), "Undo").disabled)
	assert_vec2(_place(), _place_of_lab(), 1e-3)


func test_nothing_flies_while_the_method_is_open_or_knows_no_such_lines() -> void:
	await _fly("right_plain")
	assert_false(_flight().is_flying())
	await save_hand_in("right_step")
	assert_true(_flight().is_flying())
	await student.press(&"lab_next_bounciness")
	assert_false(_flight().is_flying(), "its bounciness is 1")


func test_one_that_hangs_stops_neither_the_lesson_nor_its_frames() -> void:
	await _fly("right_step")
	# It hangs only where there are as many lines as in the lesson.
	await _save_bounce("var left", "while lines.size() > 2:\n\t\tpass\n\tvar left")
	assert_true(_flight().is_flying(), watcher.report.verdict(10).sentence)
	var place := _place_of_lab()
	for frame_number in _FRAMES:
		await student.press(&"lab_next_frame")
	assert_gt(_place_of_lab().distance_to(place), 1.0)
	assert_false(_flight().is_current(), "the worker still hangs")
	assert_true(OS.is_process_running(watcher.child_id()))


func _fly(hand_in: String) -> void:
	await save_hand_in(hand_in)
	await open_with_desk(&"angled_lines")


func _save_bounce(code: String, other: String) -> void:
	var text := FileAccess.get_file_as_string(HAND_INS.path_join("right_step/my_bounce.gd"))
	assert_string_contains(text, code)
	var before := watcher.report
	save_file("my_bounce.gd", text.replace(code, other))
	await wait_for_verdict(before)


func _flight() -> OwnFlight:
	return screen().find_children("*", "OwnFlight", true, false)[0] as OwnFlight


func _place() -> Vec2:
	return Vec2.new(_flight().ball()[0], _flight().ball()[1])


func _place_of_lab() -> Vec2:
	return (frame().lesson.get_node("%Velocity") as DraggableVector).tail_point()


func _start() -> Vec2:
	var starts: Array[PackedFloat64Array] = frame().lesson.link_state()["starts"]
	return Vec2.new(starts[0][0], starts[0][1])
