extends LessonTest
## Drives the lesson that proves the projection: steps, turning, dragging, typing.

## Frames after which something that runs by itself counts as stuck.
const _PATIENCE := 3000


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"projection_proof"))
	await go_to_step()
	await _finish_turning()


func after_each() -> void:
	Engine.time_scale = 1.0
	await super()


func test_it_starts_with_the_proof_complete() -> void:
	_assert_vectors([7, 1], [8, -6])
	assert_eq(_turned(), Vec2.new(5, 5).to_vector2())
	assert_reads("a′.x = 5.000000000000001")
	assert_reads("equal to the last bit")


func test_stepping_back_to_the_first_step_turns_the_drawing_back() -> void:
	await _go_to_first_step()
	assert_eq(_turned(), Vector2(7, 1))
	assert_reads("Wanted: p")
	assert_does_not_read("equal to the last bit")


func test_the_second_step_turns_the_drawing() -> void:
	await _go_to_first_step()
	Engine.time_scale = 5.0
	await go_to_step(ProjectionProofTexts.Step.TURN)
	var shares: Array[float] = []
	for wait: int in _PATIENCE:
		shares.append(_share())
		if _share() == 1.0:
			break
		await get_tree().process_frame
	assert_gt(shares.size(), 2, "it takes more than a frame")
	assert_eq(_turned(), Vector2(5, 5))


func test_every_step_shows_its_line_with_the_numbers_put_in() -> void:
	await _go_to_first_step()
	var lines: PackedStringArray = [
		"β = atan2(−6, 8) = −36.87°",
		"a′ = (5, 5)     b′ = (10, 0)",
		"signed length of p = a′.x = 5",
		"a′.x = 7·cos(−β) − 1·sin(−β)",
		"sin β = by / |b| = (−6) / 10 = −0.6",
		"a · b̂ = (7·8 + 1·(−6)) / 10 = 5",
		"a′.x − a · b̂ = 0",
	]
	for line: String in lines:
		assert_has(formula_lines(), line)
		await go_to_step(frame().lesson.step + 1)
		await _finish_turning()


func test_the_graph_turns_the_drawing_and_step_back_is_exact() -> void:
	var plot := frame().lesson.get_node("%Plot") as Control
	await student.click_at(plot.get_global_rect().get_center())
	assert_between(_share(), 0.4, 0.6)
	var before := _share()
	await click_button("One frame on")
	assert_gt(_share(), before)
	await click_button("One frame back")
	assert_almost_eq(_share(), before, 1e-12)


func test_play_turns_from_the_start_and_stops_at_the_end() -> void:
	await click_button("Play or pause")
	assert_lt(_share(), 1.0)
	Engine.time_scale = 20.0
	for wait: int in _PATIENCE:
		if _share() == 1.0:
			break
		await get_tree().process_frame
	assert_eq(_turned(), Vector2(5, 5))
	assert_false((frame().lesson.services[&"transport"] as Transport).is_playing)


func test_heads_can_be_dragged_at_the_first_and_at_the_last_step() -> void:
	await drag(Vec2.new(7, 1), Vec2.new(3.2, 3.9))
	_assert_vectors([3, 4], [8, -6])
	await _go_to_first_step()
	await drag(Vec2.new(8, -6), Vec2.new(6.1, 7.8))
	_assert_vectors([3, 4], [6, 8])


func test_what_is_seen_turned_can_be_dragged_turned() -> void:
	await drag(Vec2.new(10, 0), Vec2.new(5.1, 1.2))
	assert_vec2(_vector("b"), Vec2.new(4, -3), 1e-9)
	await drag(Vec2.new(5, 5), Vec2.new(10.1, 0.1))
	assert_vec2(_vector("a"), Vec2.new(8, -6), 1e-9)


func test_a_head_behind_the_graph_can_be_taken() -> void:
	var typed: Dictionary[String, String] = {
		"x of a": "3", "y of a": "-5", "x of b": "-6", "y of b": "2"
	}
	for title: String in typed:
		await student.enter(Screen.named(screen(), title) as LineEdit, typed[title])
	await _finish_turning()
	var head := frame().lesson.get_node("%HeadTurnedA") as Control
	var plot := frame().lesson.get_node("%Plot") as Control
	assert_true(plot.get_global_rect().intersects(head.get_global_rect()), "it is behind it")
	await drag(Vec2.new(-4.4272, 3.7947), Vec2.new(-4.4272, 0.0))
	assert_almost_eq(_vector("a").cross(_vector("b")), 0.0, 1e-3)


func test_arrow_keys_nudge_the_head_that_has_the_focus() -> void:
	Screen.named(screen(), "Head of b").grab_focus()
	await student.press(&"ui_left")
	_assert_vectors([7, 1], [7, -6])


func test_clicks_set_a_and_b() -> void:
	await student.click_at(place_of(Vec2.new(-3, -4)))
	await student.click_at(place_of(Vec2.new(-4, -3)), MOUSE_BUTTON_RIGHT)
	_assert_vectors([-3, -4], [-4, -3])


func test_a_typed_number_moves_the_vector_and_undo_brings_it_back() -> void:
	await student.enter(Screen.named(screen(), "x of b") as LineEdit, "-8")
	_assert_vectors([7, 1], [-8, -6])
	await click_button("Undo")
	_assert_vectors([7, 1], [8, -6])


func test_reset_brings_the_lecture_back_and_can_be_undone() -> void:
	await click_button("Obtuse")
	_assert_vectors([-5, 2], [8, -6])
	await student.press(&"lab_reset")
	_assert_vectors([7, 1], [8, -6])
	await student.press(&"lab_undo")
	_assert_vectors([-5, 2], [8, -6])


func test_sides_that_differ_show_their_difference_in_units_in_the_last_place() -> void:
	await click_button("One bit")
	assert_reads("1 unit in the last place apart")
	assert_has(formula_lines(), "a′.x − a · b̂ = 0 (rounding: 4.4e−16)")


func test_neighbours_at_a_power_of_2_are_one_unit_apart() -> void:
	await drag(Vec2.new(8, -6), Vec2.new(0, 5))
	await student.enter(Screen.named(screen(), "x of a") as LineEdit, "-5")
	await student.enter(Screen.named(screen(), "y of a") as LineEdit, "2")
	assert_reads("a′.x = 1.9999999999999998\na · b\u0302 = 2\n1 unit in the last place apart")


func test_a_zero_b_is_explained_and_loses_nothing() -> void:
	await click_button("Zero")
	assert_reads("b is zero: no direction, no shadow")
	await click_button("Lecture")
	assert_reads("equal to the last bit")


func test_without_a_direction_nothing_is_drawn_or_compared() -> void:
	await click_button("Zero")
	assert_false((frame().lesson.services[&"readout"] as Control).is_visible_in_tree())
	for step: int in ProjectionProofTexts.Step.size():
		await go_to_step(step)
		for part: String in ["%XOfA", "%XOfB", "%TurnedP", "%Plot"]:
			assert_false((frame().lesson.get_node(part) as CanvasItem).visible, part)


func test_near_a_right_angle_only_rounding_is_said_to_be_rounding() -> void:
	var typed: Dictionary[String, String] = {
		"x of a": "1", "y of a": "3", "x of b": "-3", "y of b": "1"
	}
	for title: String in typed:
		await student.enter(Screen.named(screen(), title) as LineEdit, typed[title])
	assert_reads("Both mean 0: only rounding is left")
	await student.enter(Screen.named(screen(), "x of a") as LineEdit, "1.000000001")
	assert_does_not_read("Both mean 0")
	assert_reads("1.074e9 units in the last place apart")


func test_the_shadow_is_not_asked_for_where_another_choice_is_as_long() -> void:
	await student.enter(Screen.named(screen(), "y of b") as LineEdit, "0")
	await go_to_step(ProjectionProofTexts.Step.TURN)
	await student.press(&"lab_next_step")
	assert_eq(frame().lesson.step, ProjectionProofTexts.Step.READ_OFF)


func test_the_turn_is_asked_for_before_it_is_shown() -> void:
	await _go_to_first_step()
	await student.press(&"lab_next_step")
	assert_true((frame().lesson.get_node("%Guess") as CanvasItem).visible)
	await drag(Vec2.new(4.9, 0.7), Vec2.new(5, 5))
	await student.press(&"lab_next_step")
	assert_reads("Exactly.")
	await _finish_turning()
	await student.press(&"lab_next_step")
	await click_button("the x of a")
	assert_reads("No, the x of a′")


func test_while_it_plays_at_the_first_step_the_text_says_so() -> void:
	await _go_to_first_step()
	await click_button("Play or pause")
	await student.settle()
	assert_reads("Both turn by −β")


func test_the_question_names_a_mistake_and_shows_its_numbers_on_the_board() -> void:
	var question := frame().lesson.services[&"question"] as Question
	question.folded = false
	await student.settle()
	question.rng.seed = 191
	# Behind those of the lecture.
	for number: int in 2:
		await click_button("New numbers")
	var answer := Screen.named(question, "a′.x =") as LineEdit
	await student.enter(answer, "%s" % _vector_in_prompt(question, 0).length())
	assert_reads("That is |a|")
	await student.enter(
		answer,
		"%s" % _vector_in_prompt(question, 0).scalar_projection(_vector_in_prompt(question, 1))
	)
	assert_reads("Right:")
	await student.click(question.get_node("%Show") as Control)
	assert_vec2(_vector("a"), _vector_in_prompt(question, 0), 0.0)


func _go_to_first_step() -> void:
	for step: int in ProjectionProofTexts.Step.size():
		await student.press(&"lab_previous_step")
	await _finish_turning()


func _finish_turning() -> void:
	Engine.time_scale = 20.0
	for wait: int in _PATIENCE:
		if not frame().lesson.is_processing():
			break
		await get_tree().process_frame
	Engine.time_scale = 1.0


func _vector(letter: String) -> Vec2:
	var held: PackedFloat64Array = frame().lesson.state()[letter]
	return Vec2.new(held[0], held[1])


func _assert_vectors(a: PackedFloat64Array, b: PackedFloat64Array) -> void:
	var got_a: PackedFloat64Array = frame().lesson.state()["a"]
	var got_b: PackedFloat64Array = frame().lesson.state()["b"]
	assert_eq(got_a, a, "a")
	assert_eq(got_b, b, "b")


# Where the head of a is drawn now, rounded to what the eye sees.
func _turned() -> Vector2:
	var handle := frame().lesson.get_node("%HeadTurnedA") as Control
	if not handle.visible:
		handle = frame().lesson.get_node("%HeadA") as Control
	var lesson := frame().lesson
	var pixel := handle.position + handle.size / 2.0
	return lesson.board.to_plane(pixel).to_vector2().snapped(Vector2(0.01, 0.01))


# How far the graph says that the turn has got.
func _share() -> float:
	var model: ProjectionProofModel = frame().lesson.get("_model")
	return model.turned_share


# The first or second pair of numbers in the question.
func _vector_in_prompt(question: FoldableContainer, index: int) -> Vec2:
	var prompt := (question.get_node("%Prompt") as Label).text.replace(NumberText.MINUS, "-")
	var pair := RegEx.create_from_string("\\((-?\\d+), (-?\\d+)\\)").search_all(prompt)[index]
	return Vec2.new(pair.get_string(1).to_float(), pair.get_string(2).to_float())
