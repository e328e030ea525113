extends LessonTest
## Drives the lesson on balls that push each other: dragging, typing, keys, what is asked, the
## flight forwards and back, the bug gallery.

const _START: Array[float] = [-6, -2, 6, 0, 1]


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"newton_balls"))


func after_each() -> void:
	Engine.time_scale = 1.0
	await super()


func test_the_steps_lead_to_the_numbers_of_the_course() -> void:
	assert_eq(formula_lines().size(), 3)
	await go_to_step(NewtonBallsModel.Step.CENTER)
	assert_reads("V = (2, 0), before and after")
	await go_to_step(NewtonBallsModel.Step.IMPULSE)
	assert_has(formula_lines(), "J = (1 + C) μ w = (1 + 1)·0.6667·6 = 8")
	await go_to_step(NewtonBallsModel.Step.AFTER)
	assert_has(formula_lines(), "v₁′ = v₁ − (J / m₁) n = (6, 0) − 8·(1, 0) = (−2, 0)")
	assert_has(formula_lines(), "v₂′ = v₂ + (J / m₂) n = (0, 0) + 4·(1, 0) = (4, 0)")
	await go_to_step(NewtonBallsModel.Step.MOMENTUM)
	assert_reads("t = 0.00 s   P = (6, 0)   E = 18")
	await click_button("C = 0.5")
	await go_to_step(NewtonBallsModel.Step.ENERGY)
	assert_reads("E: 9 of 18 is lost")


func test_what_is_asked_before_it_is_shown() -> void:
	await student.press(&"lab_next_step")
	await student.press(&"lab_next_step")
	assert_reads("What does the centre of mass do when the balls bounce?")
	await click_button("it moves on as before")
	await student.press(&"lab_next_step")
	await student.press(&"lab_next_step")
	await student.press(&"lab_next_step")
	assert_reads("Where does the arrow of v₁′ end")
	var guess := frame().lesson.get_node("%Guess") as Handle
	await student.drag(place_of(guess.at()), place_of(guess.at().minus(Vec2.new(8.0, 0.0))))
	await student.press(&"lab_next_step")
	assert_reads("Your guess was")
	await student.press(&"lab_next_step")
	await student.press(&"lab_next_step")
	assert_reads("Is the kinetic energy kept, too?")
	await click_button("some of it is lost")
	assert_reads("No,")


func test_balls_velocities_masses_and_c_can_be_dragged() -> void:
	await drag(Vec2.new(0, -2), Vec2.new(-2, -3))
	assert_eq(_balls()[0], _pack([-6, -2, 4, -1, 1]))
	# By its disc, off the middle.
	await drag(Vec2.new(-6.6, -1.7), Vec2.new(-7.6, -0.7))
	assert_eq(_balls()[0], _pack([-7, -1, 4, -1, 1]))
	var mass := frame().lesson.get_node("%Mass1") as Handle
	await drag(mass.at(), mass.at().minus(Vec2.new(0.0, 1.0)))
	assert_eq(_balls()[0][4], 4.0)
	var bounciness := frame().lesson.get_node("%Bounciness") as Handle
	await drag(bounciness.at(), Vec2.new(0.0, bounciness.at().y))
	assert_eq(_model().bounciness, 0.5)
	await click_button("Undo")
	assert_eq(_model().bounciness, 1.0)


func test_numbers_can_be_typed_and_wrong_ones_are_refused() -> void:
	await enter("mass of ball 2", "3")
	assert_eq(_balls()[1][4], 3.0)
	await enter("mass of ball 2", "0")
	assert_reads("m of ball 2 must be within 0.01..100, not 0.")
	await enter("y of the velocity of ball 1", "-1")
	assert_eq(_balls()[0], _pack([-6, -2, 6, -1, 1]))
	await enter("bounciness C", "2")
	assert_reads("C must be within 0..1, not 2.")


func test_keys_switch_newton_and_c_and_n_is_the_next_step() -> void:
	await student.press(&"lab_newton")
	assert_false(_model().has_newton)
	assert_reads("Newton is off")
	await student.press(&"lab_next_bounciness")
	assert_eq(_model().bounciness, 0.5)
	await student.press_key(KEY_N)
	assert_eq(frame().lesson.step, NewtonBallsModel.Step.NORMAL)
	await student.press(&"lab_undo")
	await student.press(&"lab_undo")
	assert_true(_model().has_newton)


func test_newton_off_flies_and_is_compared() -> void:
	await student.press(&"lab_newton")
	await go_to_step(NewtonBallsModel.Step.MOMENTUM)
	assert_reads("the mistake makes P = (−6, 0)")
	await play_to_end()
	assert_reads("P = (−6, 0)   E = 18")


func test_frames_go_on_and_back_to_the_same_bits_at_c_0() -> void:
	await click_button("C = 0")
	for frames: int in 50:
		await student.press(&"lab_next_frame")
	var before := _flying()
	for frames: int in 10:
		await student.press(&"lab_next_frame")
	assert_almost_eq(_flying()[1][2], 2.0, 1e-12, "they move on together")
	for frames: int in 10:
		await student.press(&"lab_previous_frame")
	assert_eq(_flying(), before)
	for frames: int in 60:
		await student.press(&"lab_previous_frame")
	assert_eq(_flying()[0], _pack(_START))
	assert_eq(_balls()[0], _pack(_START), "the start is as it was")


func test_grabbing_a_flying_ball_takes_all_as_the_new_start() -> void:
	for frames: int in 30:
		await student.press(&"lab_next_frame")
	assert_almost_eq(_flying()[0][0], -3.0, 1e-9)
	await drag(Vec2.new(3, -1.1), Vec2.new(5, -1.1))
	assert_almost_eq(_balls()[0][0], -3.0, 1e-9)
	assert_eq(_balls()[1][0], 4.0)
	await student.press(&"lab_undo")
	assert_eq(_balls()[0][0], -6.0)


func test_seen_from_the_centre_of_mass_it_stands_still() -> void:
	await go_to_step(NewtonBallsModel.Step.FRAME)
	var center := frame().lesson.get_node("%Center") as TargetMark
	var first := center.at()
	for frames: int in 40:
		await student.press(&"lab_next_frame")
	assert_vec2(center.at(), first, 1e-12)
	assert_false((frame().lesson.get_node("%Ball1") as CanvasItem).visible)


func test_every_preset_flies_for_some_seconds() -> void:
	for preset: String in NewtonBallsPresets.all():
		await click_button(preset)
		await go_to_step(NewtonBallsModel.Step.MOMENTUM)
		var run: BallRun = frame().lesson.get(&"_run")
		run.go_to(3.0)
		assert_eq(run.refusal, "", preset)
		assert_not_null(run.meeting, preset)


func test_each_mistake_shows_and_can_be_undone() -> void:
	var infos := NewtonBallsMistakes.infos()
	for item: int in infos.size():
		await pick_mistake_at(item + 1)
		assert_gt(frame().lesson.step, NewtonBallsModel.Step.AFTER)
		assert_eq(_model().mistake, infos[item].number)
		assert_reads("the mistake makes P = ")
		var wrong: Array[CanvasItem] = [
			frame().lesson.get_node("%Wrong1"), frame().lesson.get_node("%Wrong2")
		]
		assert_true(wrong[0].visible or wrong[1].visible, infos[item].title)
	await click_button("Undo")
	assert_eq(_model().mistake, NewtonBallsMistakes.OWN_SHARE)


func test_a_question_names_the_mistake_and_shows_its_numbers() -> void:
	var question := frame().lesson.services[&"question"] as FoldableContainer
	question.folded = false
	await student.settle()
	await student.enter(Screen.named(question, "v₁′ =") as LineEdit, "-6")
	await student.enter(Screen.named(question, "v₂′ =") as LineEdit, "0")
	assert_reads("Each ball bounces as off a wall.")
	await student.enter(Screen.named(question, "v₁′ =") as LineEdit, "-2")
	await student.enter(Screen.named(question, "v₂′ =") as LineEdit, "4")
	assert_reads("Right: (−2, 4).")
	await click_button("Show on board")
	assert_eq(_balls()[0].slice(2), _pack([6, 0, 1]))


func test_the_readout_tells_the_error_of_both_velocities() -> void:
	await click_button("Oblique")
	await go_to_step(NewtonBallsModel.Step.AFTER)
	var readout := frame().lesson.services[&"readout"] as Readout
	assert_eq(readout.cell(1, 0).text, "v₁′")
	assert_eq(readout.cell(1, 1).text, "(1.8, −2.4)")
	assert_lt(SeenLesson.first_number(readout.cell(1, 2).text), 1e-14)


func test_balls_that_part_are_told_and_nothing_is_asked() -> void:
	await enter("x of the velocity of ball 1", "-6")
	assert_reads("Within 60 s no two balls meet.")
	for presses: int in NewtonBallsModel.Step.ENERGY:
		await student.press(&"lab_next_step")
	assert_eq(frame().lesson.step, NewtonBallsModel.Step.ENERGY)
	assert_reads("within 60 s no two balls meet")


func _model() -> NewtonBallsModel:
	return frame().lesson.get(&"_model")


func _balls() -> Array[PackedFloat64Array]:
	return _model().balls


func _flying() -> Array[PackedFloat64Array]:
	var run: BallRun = frame().lesson.get(&"_run")
	var found: Array[PackedFloat64Array] = []
	for ball in run.balls():
		found.append(NewtonBallsModel.list_of(ball))
	return found


func _pack(packed: Array[float]) -> PackedFloat64Array:
	return PackedFloat64Array(packed)
