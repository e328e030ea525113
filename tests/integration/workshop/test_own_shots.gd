extends DeskTest
## The student's shots on the boards of the lessons on aiming: right ones end where the lab's own
## do, wrong ones elsewhere.

# Each exercise: its lesson, the method, a hand-in that is wrong on its first board, and the part of
# the lesson that shows where the right answer ends.
const _DRAWN: Array[Array] = [
	[&"lead_target", "lead_time", "lead_one_step", "%Moved"],
	[&"lead_target", "lead", "lead_present", "%Aimed"],
	[&"ballistic_aim", "flat_arc", "arc_straight", "%Target"],
	[&"ballistic_aim", "high_arc", "arc_sign", "%Target"],
	[&"bank_shot", "bank", "bank_middle", "%Target"],
]
# Heads of arrows are known to 32 bits.
const _TOLERANCE := 1e-4


func test_a_right_shot_ends_where_that_of_the_lab_does_and_a_wrong_one_elsewhere() -> void:
	for row in _DRAWN:
		var lesson: StringName = row[0]
		var method: String = row[1]
		var wrong: String = row[2]
		var part: String = row[3]
		await open_with_desk(lesson)
		await go_to_step(LeadTargetModel.Step.AIM if method == "lead" else 3)
		for hand_in: String in [wrong, "right_aim"]:
			var is_right := hand_in == "right_aim"
			await save_hand_in(hand_in)
			var drawn := await wait_for_answer(method)
			assert_eq(drawn.is_right(), is_right, "%s of %s" % [method, hand_in])
			var far := drawn.mark().to.distance_to(_place_of(frame().lesson.get_node(part)))
			assert_eq(far < _TOLERANCE, is_right, "%s of %s: %s" % [method, hand_in, far])
		await _leave()


func test_a_target_with_a_radius_is_not_asked_about() -> void:
	await save_hand_in("right_aim")
	await open_with_desk(&"lead_target")
	assert_eq((await wait_for_answer("lead_time")).words(), "yours: t = 2")
	await click_button("Radius")
	assert_null(answers().shown("lead_time"))
	assert_null(answers().shown("lead"))


func test_where_no_shot_hits_the_words_say_so() -> void:
	await save_hand_in("right_aim")
	await open_with_desk(&"lead_target")
	await click_button("Gets away")
	for method: String in ["lead_time", "lead"]:
		var drawn := await wait_for_answer(method)
		assert_eq(drawn.words(), "yours: no shot hits")
		assert_true(drawn.is_right())
	await _leave()
	await open_with_desk(&"ballistic_aim")
	await click_button("Out of reach")
	for method: String in ["flat_arc", "high_arc"]:
		var drawn := await wait_for_answer(method)
		assert_eq(drawn.words(), "yours: no shot hits")
		assert_eq(drawn.mark().shape, OwnMark.Shape.NOTE)


func test_seen_from_a_shooter_that_moves_the_student_gets_the_relative_velocity() -> void:
	await save_hand_in("right_aim")
	await open_with_desk(&"lead_target")
	await click_button("Moving shooter")
	var drawn := await wait_for_answer("lead")
	assert_true(drawn.is_right())
	# Both move alike: seen from the shooter, the target rests.
	assert_eq(drawn.words(), "yours: d = (1, 0)")
	var time := await wait_for_answer("lead_time")
	assert_eq(time.words(), "yours: t = 1.6")
	assert_eq(time.mark().shape, OwnMark.Shape.NOTE)


func test_arcs_are_drawn_only_at_a_target_that_rests_under_gravity() -> void:
	await save_hand_in("right_aim")
	await open_with_desk(&"ballistic_aim")
	await wait_for_answer("high_arc")
	for preset: String in ["Moving target", "g = 0", "Falling target"]:
		await click_button(preset)
		assert_null(answers().shown("flat_arc"), preset)
		assert_null(answers().shown("high_arc"), preset)


func test_the_high_arc_in_place_of_the_flat_one_is_seen() -> void:
	await open_with_desk(&"ballistic_aim")
	await save_hand_in("arc_high")
	var flat := await wait_for_answer("flat_arc")
	assert_false(flat.is_right())
	assert_eq(flat.words(), "yours: d₁ = (0.6, -0.8)".replace("-", NumberText.MINUS))
	# It is still on its way when that of the lab has hit.
	assert_lt(flat.mark().to.x, 160.0)
	assert_eq(flat.mark().places[0].length(), 0.0)


func test_a_ball_over_two_walls_bounces_off_both() -> void:
	await open_with_desk(&"bank_shot")
	await click_button("Slanted pair")
	await save_hand_in("bank_order")
	assert_null(answers().shown("bank"), "it bounces twice")
	var wrong := await wait_for_answer("bank_twice")
	assert_false(wrong.is_right())
	var target := Vec2.new(190, 60)
	assert_gt(wrong.mark().to.distance_to(target), 10.0)
	await save_hand_in("right_aim")
	var right := await wait_for_answer("bank_twice")
	assert_true(right.is_right())
	assert_eq(right.mark().places.size(), 4, "start, two bounces, and where it arrives")
	assert_vec2(right.mark().to, target, 1e-6)


func test_what_no_exercise_is_about_is_not_asked() -> void:
	await save_hand_in("right_aim")
	await open_with_desk(&"bank_shot")
	await wait_for_answer("bank")
	await click_button("Three bounces")
	assert_null(answers().shown("bank"))
	assert_null(answers().shown("bank_twice"))


func test_on_a_phone_words_stay_on_their_plates_above_the_card() -> void:
	await resize(Vector2i(390, 844))
	await save_hand_in("arc_sign")
	await open_with_desk(&"ballistic_aim")
	await go_to_step(BallisticAimModel.Step.ARCS)
	# Both ways lead below the board.
	assert_eq(frame().link.open("target=150,-40"), "")
	await student.settle()
	for method: String in ["flat_arc", "high_arc"]:
		await wait_for_answer(method)
	var rooms: Dictionary[String, Rect2] = {}
	answers().text_drawn.connect(
		func(text: String, letters: Rect2, _font_size: int) -> void: rooms[text] = letters
	)
	answers().queue_redraw()
	await student.settle()
	assert_eq(rooms.size(), 2)
	var flat := rooms[answers().shown("flat_arc").words()]
	var high := rooms[answers().shown("high_arc").words()]
	assert_true(frame().lesson.board.free_area().encloses(flat.merge(high)))
	assert_false(flat.grow(5.0).intersects(high), str(rooms))


# Each lesson begins with its own numbers.
func _leave() -> void:
	screen().free()
	LessonBoards.forget_all()
	await student.settle()


# The head of an arrow, or the middle of a target.
func _place_of(part: Node) -> Vec2:
	var arrow := part as Arrow
	if arrow:
		return Vec2.from_vector2(arrow.head)
	return (part as TargetMark).at()
