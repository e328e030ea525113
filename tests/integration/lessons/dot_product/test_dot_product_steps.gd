extends DotProductTest
## The steps of the lesson on the dot product: what each of them shows, and nothing before it.

## Which arrows can be seen at each step, by the names of their nodes, and how many formula lines.
const _ARROWS: Array[Array] = [
	[],
	["Unit"],
	["TailDrop", "HeadDrop", "Unit"],
	["TailDrop", "HeadDrop", "Projection", "Unit"],
	["TailDrop", "HeadDrop", "Rejection", "Projection", "Unit"],
	["TailDrop", "HeadDrop", "Projection"],
	["OtherDrop", "TailDrop", "HeadDrop", "Projection", "OtherProjection", "Unit"],
	["TailDrop", "HeadDrop", "Projection", "Unit"],
	["TailDrop", "HeadDrop", "Projection", "Unit"],
]
const _LINES: Array[int] = [2, 4, 6, 7, 9, 8, 7, 8, 7]
const _WORDS: Array[String] = [
	"left for a, right for b",
	"Divide b by its length",
	"scalar projection",
	"vector projection p",
	"rest",
	"see “Proof of the projection”",
	"a · b\u0302 is not b · â",
	"cos φ",
	"atan2",
]
## The first step that shows each of these, by their names in the scene.
const _FIRST_SEEN: Dictionary[String, int] = {
	"%Verdict": 2, "%Angle": 2, "%RightAngle": 4, "%Plot": 7, "%Alpha": 8, "%Beta": 8
}


func test_the_lesson_opens_at_the_first_step() -> void:
	assert_reads("Step 1 of 9")
	assert_eq(_visible_arrows(), _ARROWS[0])
	assert_does_not_read("Scalar projection 5")
	assert_does_not_read("run time")


func test_each_step_shows_its_sentence_its_arrows_and_its_lines() -> void:
	for step: int in 9:
		await go_to_step(step)
		assert_reads("Step %d of 9" % (step + 1))
		assert_reads(_WORDS[step])
		assert_eq(_visible_arrows(), _ARROWS[step], "step %d" % (step + 1))
		assert_eq(formula_lines().size(), _LINES[step], "step %d" % (step + 1))


func test_nothing_is_seen_before_the_step_that_introduces_it() -> void:
	for step: int in 9:
		await go_to_step(step)
		for part: String in _FIRST_SEEN:
			var is_seen := (frame().lesson.get_node(part) as CanvasItem).is_visible_in_tree()
			if step < _FIRST_SEEN[part] or step == _FIRST_SEEN[part]:
				assert_eq(is_seen, step == _FIRST_SEEN[part], "%s at step %d" % [part, step + 1])
		assert_eq(frame().lesson.services[&"readout"].visible, step == 8)


func test_the_lines_up_to_the_rest_hold_the_numbers_of_the_lecture() -> void:
	await go_to_step(4)
	assert_eq(
		formula_lines(),
		PackedStringArray(
			[
				"a = ( 7 , 1 )",
				"b = ( 8 , -6 )",
				"|b| = √(8² + (−6)²) = 10",
				"b\u0302 = b / |b| = (0.8, −0.6)",
				"a · b = 7·8 + 1·(−6) = 50",
				"a · b\u0302 = 50 / 10 = 5",
				"p = 5 b\u0302 = (4, −3)",
				"a − p = (3, 4)",
				"(a − p) · b = 0",
			]
		)
	)


func test_the_lines_on_the_angle_hold_the_numbers_of_the_lecture() -> void:
	await go_to_step(DotProductTexts.Step.ANGLE)
	assert_has(formula_lines(), "a · b\u0302 = |a| cos φ")
	assert_has(formula_lines(), "a · b = |a| |b| cos φ")
	assert_has(formula_lines(), "a · b = 7.071·10·cos 45° = 50")
	assert_has(formula_lines(), "â · b\u0302 = cos φ = 0.7071")
	assert_has(formula_lines(), "−1 ≤ â · b\u0302 ≤ 1")


func test_the_primitive_way_is_computed_in_steps() -> void:
	await go_to_step()
	assert_eq(
		formula_lines().slice(2),
		PackedStringArray(
			[
				"α = atan2(1, 7) = 8.13°",
				"β = atan2(−6, 8) = −36.87°",
				"φ = α − β = 45°",
				"cos φ = cos 45° = 0.7071",
				"|a| cos φ = 7.071·cos 45° = 5",
			]
		)
	)


func test_light_falls_while_the_shadow_is_shown_and_p_is_measured_when_in_doubt() -> void:
	for step in 9:
		await go_to_step(step)
		var is_lit := step in [DotProductTexts.Step.SCALAR, DotProductTexts.Step.PROJECTION]
		var light := frame().lesson.get_node("%Light") as CanvasItem
		assert_eq(light.is_visible_in_tree(), is_lit, "step %d" % (step + 1))
		var ruler := frame().lesson.get_node("%Ruler") as DimensionLine
		assert_eq(ruler.is_visible_in_tree(), step == DotProductTexts.Step.SURE)
	assert_eq((frame().lesson.get_node("%Ruler") as DimensionLine).label, "|p| = 5")


func test_both_shadows_are_seen_at_once() -> void:
	await go_to_step(DotProductTexts.Step.BOTH)
	assert_has(formula_lines(), "a · b\u0302 = 50 / 10 = 5")
	assert_has(formula_lines(), "b · â = 50 / 7.071 = 7.071")
	assert_reads("Here the shadow q is a itself, by chance")
	await click_button("Obtuse")
	assert_reads("a · b\u0302 is not b · â: the same dot product, divided by another length.")
	await click_button("Right angle")
	assert_reads("At a right angle both shadows are zero")
	await student.enter(field("x of a"), "10")
	await student.enter(field("y of a"), "0")
	assert_reads("Both shadows are equally long here, because a and b are.")


func test_the_second_shadow_is_asked_for_before_it_is_shown() -> void:
	await go_to_step(DotProductTexts.Step.SURE)
	await student.press(&"lab_next_step")
	assert_reads("is it longer or shorter than p?")
	await click_button("longer")
	assert_reads("Right: longer")
	assert_eq(frame().lesson.step, DotProductTexts.Step.BOTH)


func test_an_angle_close_to_90_degrees_has_the_digits_that_its_line_needs() -> void:
	await student.enter(field("x of a"), "6.0001")
	await student.enter(field("y of a"), "8")
	await go_to_step(DotProductTexts.Step.ANGLE)
	assert_has(formula_lines(), "a · b = 10.00006·10·cos 89.9995416° = 0.0008")


func test_a_zero_vector_has_no_direction_and_no_lines_that_divide_by_its_length() -> void:
	await go_to_step()
	await click_button("Zero")
	assert_reads("b is zero: it has no direction, and no shadow falls on it.")
	assert_eq(formula_lines().size(), 3)
	assert_eq(_visible_arrows(), [])
	await student.enter(field("x of b"), "8")
	await student.enter(field("x of a"), "0")
	await student.enter(field("y of a"), "0")
	assert_reads("a is zero: it has no direction, and there is no angle.")
	assert_has(formula_lines(), "p = 0 b\u0302 = (0, 0)")


func test_where_nothing_is_left_no_rest_is_shown() -> void:
	await go_to_step(DotProductTexts.Step.REJECTION)
	await student.enter(field("x of a"), "4")
	await student.enter(field("y of a"), "-3")
	assert_reads("Nothing is left of a here: the rest a − p is zero.")
	assert_false((frame().lesson.get_node("%Rejection") as CanvasItem).visible)


func test_the_right_angle_is_marked_with_the_rest() -> void:
	await go_to_step(4)
	var mark := frame().lesson.get_node("%RightAngle") as AngleArc
	assert_true(mark.visible)
	await click_button("Step back")
	assert_false(mark.visible)


func test_the_keys_step_forward_and_back_and_stop_at_both_ends() -> void:
	await student.press(&"lab_previous_step")
	assert_reads("Step 1 of 9")
	await student.press(&"lab_next_step")
	assert_reads("Step 2 of 9")
	await go_to_step()
	await student.press(&"lab_next_step")
	assert_reads("Step 9 of 9")


func test_the_gamepad_steps_too() -> void:
	await student.press_pad(JOY_BUTTON_X)
	assert_reads("Step 2 of 9")
	await student.press_pad(JOY_BUTTON_BACK)
	assert_reads("Step 1 of 9")


func test_the_buttons_step_and_are_off_at_the_ends() -> void:
	assert_true(Screen.button(screen(), "Step back").disabled)
	await click_button("Step forward")
	assert_reads("Step 2 of 9")
	await go_to_step()
	assert_true(Screen.button(screen(), "Step forward").disabled)


func test_a_step_is_kept_when_a_vector_is_dragged() -> void:
	await go_to_step(3)
	await drag(Vec2.new(7, 1), Vec2.new(3, -4))
	assert_reads("Step 4 of 9")
	assert_eq(_visible_arrows(), _ARROWS[3])


func test_whoever_has_only_a_finger_is_told_to_tap() -> void:
	screen().free()
	Input.emulate_touch_from_mouse = true
	await open_lesson(LessonIndex.find(&"dot_product"))
	Input.emulate_touch_from_mouse = false
	assert_reads("or tap where a is to end.")
	assert_does_not_read("right for b")
	await student.touch(place(3.0, 4.0))
	assert_a([0.0, 0.0, 3.0, 4.0])


func _visible_arrows() -> Array:
	var found := []
	for node: Node in frame().lesson.get_node("%Drawing").get_children():
		if node is Arrow and (node as Arrow).is_visible_in_tree():
			found.append(str(node.name))
	return found
