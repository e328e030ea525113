extends LessonTest
## Drives the lesson on the moment to fire: steps, dragging, typing, the timeline, the bug gallery,
## the flight of the shot.

const _STEPS := TimedShotModel.Step


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"timed_shot"))
	await go_to_step(_STEPS.WAIT)


func after_each() -> void:
	Engine.time_scale = 1.0
	await super()


func test_it_fires_the_flight_before_the_target_is_there() -> void:
	assert_eq(formula_lines()[-2], "hit = (X − T) · V / (V · V) = 30000 / 10000 = 3")
	assert_eq(formula_lines()[-1], "fire = hit − f = 3 − 1 = 2")
	assert_reads("fire after 2 s")


func test_the_crossing_comes_from_the_normal() -> void:
	await go_to_step(_STEPS.CROSS)
	assert_has(formula_lines(), "f = P · n / (W · n) = (−20000) / (−20000) = 1")
	assert_eq(formula_lines()[-1], "X = S + f W = (0, 100) + 1 (0, −200) = (0, −100)")
	assert_true(_is_drawn("Cross"))


func test_the_window_is_colored_on_the_timeline() -> void:
	await go_to_step(_STEPS.WINDOW)
	assert_eq(formula_lines()[-1], "half = R |W − V| / |W · n| = 10·223.6 / 20000 = 0.1118")
	assert_reads("hits from 1.888 s to 2.112 s")
	assert_reads("your shot at 1 s misses by 89.4 px")


func test_the_student_s_moment_is_dragged_on_the_timeline() -> void:
	await go_to_step(_STEPS.WINDOW)
	await _drag_ring(1.0, 2.1)
	assert_almost_eq(_model().own_fire, 2.1, 1e-12)
	assert_reads("your shot at 2.1 s hits")
	await student.press(&"lab_undo")
	assert_eq(_model().own_fire, 1.0)
	_timeline().grab_focus()
	await student.press(&"ui_right")
	assert_almost_eq(_model().own_fire, 1.1, 1e-12)


func test_everything_can_be_dragged() -> void:
	await drag(Vec2.new(-300, -100), Vec2.new(-200, -100))
	assert_reads("fire after 1 s")
	await drag(Vec2.new(-150, -100), Vec2.new(-175, -100))
	assert_numbers("velocity", [50, 0])
	await drag(Vec2.new(0, 0), Vec2.new(0, -100))
	assert_numbers("bullet", [0, -400])
	await drag(Vec2.new(0, 100), Vec2.new(50, 100))
	assert_numbers("muzzle", [50, 100])
	await student.press(&"lab_undo")
	assert_numbers("muzzle", [0, 100])
	await drag(Vec2.new(0, -100), Vec2.new(0, 100))
	assert_reads("The bullet needs a speed of 1 px/s or more, not 0.")


func test_numbers_can_be_typed_and_wrong_ones_are_refused() -> void:
	await enter("x of V", "50")
	assert_reads("fire after 5 s")
	await enter("y of W", "0")
	assert_reads("The bullet needs a speed of 1 px/s or more, not 0.")
	assert_numbers("bullet", [0, -200])


func test_a_target_on_a_circle() -> void:
	await click_button("Circle")
	assert_reads("fire after 0.5 s")
	assert_eq(formula_lines()[-1], "fire = hit − f = 1 − 0.5 = 0.5")
	assert_false(_is_drawn("Velocity"))
	await drag(Vec2.new(0, -50), Vec2.new(20, -50))
	assert_numbers("centre", [20, -50])
	await enter("turn in one second", "-90")
	assert_reads("fire after")


func test_a_barrel_that_turns() -> void:
	await pick("How target and barrel move", "barrel that turns")
	assert_eq(_model().kind, TimedShotModel.Kind.TURNING)
	await click_button("Turning barrel")
	assert_reads("Fire when the barrel points to where they meet")
	assert_string_contains(formula_lines()[-1], "from S to X: ")
	var angles := formula_lines()[-1].split(": ")
	assert_eq(angles[1].get_slice(" ", 0), angles[2], "the barrel points there then")


func test_each_mistake_is_shown_at_its_step() -> void:
	await pick("Known mistakes", "Fired when it is in front")
	assert_reads("fired after 3 s it misses by 89.4 px")
	assert_true(_is_drawn("WrongWay"))
	await pick("Known mistakes", "Flight added")
	assert_string_contains(formula_lines()[-1], "mistake: 3 + 1 = 4")
	await pick("Known mistakes", "Window without the bullet")
	assert_eq(frame().lesson.step, _STEPS.WINDOW)
	assert_reads("the mistake says ± 0.1 s")
	assert_false(_is_drawn("WrongWay"))


func test_what_never_hits_says_why() -> void:
	await click_button("Too late")
	assert_reads("too late: the target has passed before a bullet comes")
	assert_eq(formula_lines()[-1], "no moment")
	await click_button("Parallel")
	assert_reads("both ways are parallel: they meet never, or always")
	assert_false(_is_drawn("Waiting"))


func test_the_shot_is_fired_and_misses_by_rounding_alone() -> void:
	await go_to_step(_STEPS.FIRE)
	assert_reads("; ε × condition ")
	assert_lt(_model().miss().distance, 1e-12)
	await click_button("Play or pause")
	var transport := frame().lesson.services[&"transport"] as Transport
	Engine.time_scale = 20.0
	for wait: int in 3000:
		if not transport.is_playing:
			break
		await get_tree().process_frame
	assert_almost_eq(_model().time, 3.0, 1e-12)
	assert_almost_eq(_place_of("Bullet"), Vector2(0, -100), Vector2(1e-4, 1e-4))
	assert_almost_eq(_place_of("Target"), Vector2(0, -100), Vector2(1e-4, 1e-4))


func test_the_student_s_own_shot_flies_before_the_answer() -> void:
	await go_to_step(_STEPS.WATCH)
	await _drag_ring(1.0, 0.0)
	for press: int in 6:
		await click_button("One frame on")
	assert_almost_eq(_place_of("Bullet"), Vector2(0, 80), Vector2(1e-3, 1e-3))
	for press: int in 6:
		await click_button("One frame back")
	assert_almost_eq(_model().time, 0.0, 1e-12)


func test_it_asks_where_the_target_is_and_how_long_the_window_is() -> void:
	await go_to_step(_STEPS.CROSS)
	await student.press(&"lab_next_step")
	assert_true(_is_drawn("Guess"))
	await drag(Vec2.new(-300, -100), Vec2.new(-120, -100))
	await student.press(&"lab_next_step")
	assert_reads("Your guess was 20 off.")
	await student.press(&"lab_next_step")
	await click_button("as long as that")
	assert_reads("No, longer than that")


func test_the_readout_has_both_times_with_their_errors() -> void:
	var readout := frame().lesson.services[&"readout"] as Readout
	assert_eq(readout.cell(1, 1).text, "2")
	assert_eq(readout.cell(1, 2).text, "0")
	assert_eq(readout.cell(2, 1).text, "1")


func test_it_moves_by_itself_at_first() -> void:
	screen().free()
	OpeningMotion.is_allowed = true
	await open_lesson(LessonIndex.find(&"timed_shot"))
	OpeningMotion.is_allowed = false
	var swing := Callable(frame().lesson, &"_swing")
	var first := Vec2.new(-300, -100)
	swing.call(2.5, first)
	assert_numbers("target", [-100, -100])
	swing.call(5.0, first)
	assert_numbers("target", [-300, -100])


func test_it_has_links() -> void:
	await click_button("Aslant")
	assert_string_contains(frame().link.text(), "bullet=-120,-160")
	assert_eq(frame().link.open("muzzle=300,400&target=0,200&bullet=0,-200&velocity=100,0"), "")
	assert_reads("fire after 2 s")
	assert_string_contains(frame().link.open("bullet=0,0"), "speed of 1 px/s or more")


func _model() -> TimedShotModel:
	return frame().lesson.get(&"_model")


func _timeline() -> ShotTimeline:
	return frame().lesson.get_node("%Timeline") as ShotTimeline


func _drag_ring(from: float, to: float) -> void:
	var area := _timeline().get_global_rect()
	var line := Vector2(0.0, area.size.y * 0.52)
	await student.drag(
		area.position + line + Vector2(_timeline().pixel_of(from), 0.0),
		area.position + line + Vector2(_timeline().pixel_of(to), 0.0)
	)


func _place_of(part: String) -> Vector2:
	return frame().lesson.get_node("%" + part).get(&"center")


func _is_drawn(part: String) -> bool:
	return (frame().lesson.get_node("%" + part) as CanvasItem).is_visible_in_tree()
