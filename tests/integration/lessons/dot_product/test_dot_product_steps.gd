extends DotProductTest
## The five steps of the lesson on the dot product: what each of them shows.

## Which arrows can be seen at each step, by the names of their nodes, and how many formula lines.
const _ARROWS: Array[Array] = [
	[],
	["Unit"],
	["TailDrop", "HeadDrop", "Unit"],
	["TailDrop", "HeadDrop", "Projection", "Unit"],
	["TailDrop", "HeadDrop", "Rejection", "Projection", "Unit"],
]
const _LINES: Array[int] = [1, 3, 5, 6, 7]
const _WORDS: Array[String] = [
	"head minus tail", "Divide b by its length", "scalar projection", "vector projection p", "rest"
]


func test_the_lesson_opens_at_the_last_step() -> void:
	assert_reads("Step 5 of 5")
	assert_eq(_visible_arrows(), _ARROWS[4])


func test_each_step_shows_its_sentence_its_arrows_and_its_lines() -> void:
	await _go_to_first()
	for step: int in 5:
		assert_reads("Step %d of 5" % (step + 1))
		assert_reads(_WORDS[step])
		assert_eq(_visible_arrows(), _ARROWS[step], "step %d" % (step + 1))
		assert_eq(formula_lines().size(), _LINES[step], "step %d" % (step + 1))
		await student.press(&"lab_next_step")


func test_the_lines_of_the_last_step_hold_the_numbers_of_the_lecture() -> void:
	assert_eq(
		formula_lines(),
		PackedStringArray(
			[
				"a = ( 7 , 1 )     b = ( 8 , -6 )",
				"|b| = √(8² + (−6)²) = 10",
				"b\u0302 = b / |b| = (0.8, −0.6)",
				"a · b = 7·8 + 1·(−6) = 50",
				"a · b\u0302 = 50 / 10 = 5",
				"p = 5 b\u0302 = (4, −3)",
				"a − p = (3, 4)     (a − p) · b = 0",
			]
		)
	)


func test_the_right_angle_is_marked_with_the_rest() -> void:
	var mark := frame().lesson.get_node("%RightAngle") as AngleArc
	assert_true(mark.visible)
	await click_button("Step back")
	assert_false(mark.visible)


func test_the_keys_step_forward_and_back_and_stop_at_both_ends() -> void:
	await student.press(&"lab_next_step")
	assert_reads("Step 5 of 5")
	await student.press(&"lab_previous_step")
	assert_reads("Step 4 of 5")
	await student.press(&"lab_next_step")
	assert_reads("Step 5 of 5")


func test_the_gamepad_steps_too() -> void:
	await student.press_pad(JOY_BUTTON_BACK)
	assert_reads("Step 4 of 5")
	await student.press_pad(JOY_BUTTON_X)
	assert_reads("Step 5 of 5")


func test_the_buttons_step_and_are_off_at_the_ends() -> void:
	assert_true(Screen.button(screen(), "Step forward").disabled)
	await _go_to_first()
	assert_true(Screen.button(screen(), "Step back").disabled)
	await click_button("Step forward")
	assert_reads("Step 2 of 5")


func test_a_step_is_kept_when_a_vector_is_dragged() -> void:
	await student.press(&"lab_previous_step")
	await drag(Vec2.new(7, 1), Vec2.new(3, -4))
	assert_reads("Step 4 of 5")
	assert_eq(_visible_arrows(), _ARROWS[3])


func _go_to_first() -> void:
	for step: int in 4:
		await student.press(&"lab_previous_step")


func _visible_arrows() -> Array:
	var found := []
	for node: Node in frame().lesson.get_node("%Drawing").get_children():
		if node is Arrow and (node as Arrow).is_visible_in_tree():
			found.append(str(node.name))
	return found
