extends DotProductTest
## Switches, presets, graph and play in the lesson on the dot product.

const _GRAPH := "a · b, right: cos φ"


func before_each() -> void:
	await super()
	await go_to_step(4)


func test_without_normalizing_the_answer_is_ten_times_too_big_and_says_so() -> void:
	await click_button("Normalize")
	assert_reads("Scalar projection 50\nwrong: |b| = 10 times the right one")
	assert_eq(_sign(), "✗")
	assert_reads("The rest a − p is not perpendicular to b")
	assert_has(formula_lines(), "p = 50 b = (400, −300)")
	assert_has(formula_lines(), "|b|² = 10² = 100")


func test_without_normalizing_no_unit_vector_and_no_right_angle_are_shown() -> void:
	await click_button("Normalize")
	for part: String in ["%Unit", "%Rejection", "%RightAngle"]:
		assert_false((frame().lesson.get_node(part) as CanvasItem).visible, part)


func test_normalizing_again_brings_the_right_answer_back() -> void:
	await click_button("Normalize")
	await click_button("Normalize")
	assert_reads("Scalar projection 5\npositive")


func test_swapped_the_lesson_projects_b_on_a() -> void:
	await click_button("b on a")
	assert_has(formula_lines(), "|a| = √(7² + 1²) = 7.071")
	assert_has(formula_lines(), "b · â = 50 / 7.071 = 7.071")
	assert_has(formula_lines(), "p = 7.071 â = (7, 1)")
	assert_has(formula_lines(), "b − p = (1, −7)")
	assert_has(formula_lines(), "(b − p) · a = 0")


func test_swapped_the_lesson_says_that_the_shadow_is_a_by_chance() -> void:
	await go_to_step(3)
	assert_does_not_read("by chance")
	await click_button("b on a")
	assert_reads("Here it is a itself, by chance")


func test_swapped_the_rest_is_labelled_b_minus_p() -> void:
	var rejection := frame().lesson.get_node("%Rejection") as Arrow
	assert_eq(rejection.label, "a − p")
	await click_button("b on a")
	assert_eq(rejection.label, "b − p")


func test_every_preset_sets_both_vectors() -> void:
	var presets: Dictionary[String, PackedFloat64Array] = {
		"Right angle": [4, 3, 6, -8],
		"Obtuse": [-5, 2, 8, -6],
		"Huge": [4e15, 3e15, 6e15, -8e15],
		"Zero": [7, 1, 0, 0],
		"Lecture": [7, 1, 8, -6],
	}
	await drag(Vec2.new(3.5, 0.5), Vec2.new(1.5, 3.5))
	for preset: String in presets:
		await click_button(preset)
		assert_eq(ends("a"), PackedFloat64Array([0, 0]) + presets[preset].slice(0, 2), preset)
		assert_eq(ends("b"), PackedFloat64Array([0, 0]) + presets[preset].slice(2, 4), preset)


func test_the_words_say_what_the_sign_means() -> void:
	var words: Dictionary[String, String] = {
		"Lecture": "positive: the angle is below 90°",
		"Right angle": "zero: the angle is 90°",
		"Obtuse": "negative: the angle is above 90°",
		"Zero": "b is zero: it has no direction",
	}
	for preset: String in words:
		await click_button(preset)
		assert_reads(words[preset])


func test_the_ball_shows_the_sign_as_well_as_its_color() -> void:
	var signs: Dictionary[String, String] = {"Lecture": "+", "Right angle": "0", "Obtuse": "−"}
	for preset: String in signs:
		await click_button(preset)
		assert_eq(_sign(), signs[preset])


func test_a_mistake_that_changes_nothing_is_not_called_wrong() -> void:
	await click_button("Normalize")
	for numbers: PackedStringArray in [["1", "0", "+"], ["-1", "7", "0"]]:
		await student.enter(field("x of b"), numbers[0])
		await student.enter(field("y of b"), numbers[1])
		assert_does_not_read("wrong")
		assert_reads("With these numbers the mistake changes nothing")
		assert_eq(_sign(), numbers[2])
	await student.enter(field("x of b"), "0.5")
	await student.enter(field("y of b"), "0")
	assert_reads("wrong: |b| = 0.5 times the right one")
	await student.enter(field("x of b"), "1.00001")
	assert_reads("wrong: |b| = 1.00001 times the right one")


func test_what_only_rounding_leaves_is_a_right_angle() -> void:
	var numbers: Dictionary[String, String] = {
		"x of a": "3", "y of a": "4", "x of b": "0.8", "y of b": "-0.6"
	}
	for title: String in numbers:
		await student.enter(field(title), numbers[title])
	assert_reads("Scalar projection 0\nzero: the angle is 90°")
	assert_eq(_sign(), "0")
	assert_has(formula_lines(), "a · b̂ = 0 / 1 = 0")


func test_dragging_on_the_graph_turns_a_and_keeps_its_length() -> void:
	await go_to_step(DotProductTexts.Step.ANGLE)
	var graph := Screen.named(screen(), _GRAPH).get_global_rect()
	await student.drag(graph.get_center(), Vector2(graph.end.x - 14.0, graph.get_center().y))
	assert_almost_eq(_a().length(), sqrt(50.0), 1e-12)
	assert_almost_eq(_a().dot(_b()), -sqrt(50.0) * 10.0, 1e-9, "180 degrees")


func test_the_middle_of_the_graph_is_the_angle_zero() -> void:
	await go_to_step(DotProductTexts.Step.ANGLE)
	var graph := Screen.named(screen(), _GRAPH).get_global_rect()
	# Between the margins: the numbers of a · b are at the left, those of cos φ at the right.
	await student.click_at(
		Vector2((graph.position.x + 56.0 + graph.end.x - 36.0) / 2.0, graph.get_center().y)
	)
	assert_almost_eq(_a().cross(_b()), 0.0, 1e-9)
	assert_gt(_a().dot(_b()), 0.0)


func test_play_turns_a_and_taking_hold_of_a_vector_pauses() -> void:
	await click_button("Play or pause")
	assert_ne(_a().y, 1.0)
	assert_almost_eq(_a().length(), sqrt(50.0), 1e-9)
	await drag(Vec2.new(8, -6), Vec2.new(3, -4))
	assert_false(_transport().is_playing)
	assert_b([0, 0, 3, -4])


func test_the_graph_pauses_too() -> void:
	await go_to_step(DotProductTexts.Step.ANGLE)
	await click_button("Play or pause")
	await student.click_at(Screen.named(screen(), _GRAPH).get_global_rect().get_center())
	assert_false(_transport().is_playing)


# A sweep of 30 degrees a second turns a by half a degree in a frame of the course.
func test_one_frame_on_turns_a_by_half_a_degree() -> void:
	var before := _a().angle_degrees()
	await click_button("One frame on")
	assert_almost_eq(_a().angle_degrees() - before, 0.5, 1e-9)


func test_the_panel_does_not_jump_while_a_turns() -> void:
	await student.press(&"lab_pause")
	_transport().set_process(false)
	for step: int in [4, 5, 6]:
		await go_to_step(step)
		var height := _transport().global_position.y
		for frame_number: int in 120:
			_transport().advanced.emit(0.1)
			await get_tree().process_frame
			if _transport().global_position.y != height:
				fail_test("%s at step %d" % [formula_lines(), step + 1])
				return
	pass_test("it stays where it is")


func test_huge_numbers_fit_into_the_panel_at_every_size() -> void:
	await click_button("Huge")
	for size: Vector2i in [Vector2i(1280, 720), Vector2i(800, 600), Vector2i(720, 1280)]:
		await resize(size)
		assert_eq(", ".join(Layout.problems(screen())), "", str(size))


func _sign() -> String:
	return (frame().lesson.get_node("%Verdict/%Sign") as Label).text


func _transport() -> Transport:
	return frame().lesson.services[&"transport"] as Transport


func _a() -> Vec2:
	return Vec2.new(ends("a")[2] - ends("a")[0], ends("a")[3] - ends("a")[1])


func _b() -> Vec2:
	return Vec2.new(ends("b")[2] - ends("b")[0], ends("b")[3] - ends("b")[1])
