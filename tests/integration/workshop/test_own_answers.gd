extends DeskTest
## What the student's method answers is drawn where the lab draws its own, if it is right, and
## elsewhere if it is wrong; for each exercise, in its lesson.

# Each exercise: its lesson, the method, a wrong hand-in, a right one, and the part of the lesson
# that shows the lab's own answer.
const _DRAWN: Array[Array] = [
	[&"normals", "normalized", "normalized_squared", "right_plain", "%UnitV"],
	[&"normals", "normal", "normal_opposite", "right_plain", "%Unit"],
	[&"dot_product", "vector_projection", "vector_swapped", "right_plain", "%Projection"],
	[&"point_of_impact", "time_of_impact", "impact_from_new", "right_plain", "%Impact"],
	[&"point_of_impact", "position_reset", "reset_up", "right_plain", "%Reset"],
	[&"reflection", "reflect", "reflect_slides", "right_plain", "%Leaving"],
	[&"line_ends", "segment_impact", "segment_at_new", "right_segment", "%RoundCaps/%ImpactBall"],
]
# Steps at which the lab's own answer is shown.
const _STEPS: Dictionary[StringName, int] = {
	&"normals": NormalsTexts.Step.UNIT,
	&"dot_product": DotProductTexts.Step.PROJECTION,
	&"point_of_impact": PointOfImpactTexts.Step.IMPACT,
	&"reflection": ReflectionModel.Step.BOUNCE,
	&"line_ends": LineEndsTexts.Step.BOUNCE,
}
# Heads of arrows are known to 32 bits.
const _TOLERANCE := 1e-5


func test_arrows_and_balls_are_where_the_lab_draws_its_own() -> void:
	for row in _DRAWN:
		var lesson: StringName = row[0]
		var method: String = row[1]
		var part: String = row[4]
		await _open_at_step(lesson)
		for is_right: bool in [false, true]:
			var hand_in: String = row[3 if is_right else 2]
			await save_hand_in(hand_in)
			var drawn := await wait_for_answer(method)
			assert_eq(drawn.is_right(), is_right, "%s of %s" % [method, hand_in])
			var far := drawn.mark().to.distance_to(_place_of(frame().lesson.get_node(part)))
			assert_eq(far < _TOLERANCE, is_right, "%s of %s: %s" % [method, hand_in, far])
		await _leave()


func test_arrows_begin_where_the_lab_s_begin() -> void:
	await save_hand_in("right_plain")
	for row: Array in [_DRAWN[0], _DRAWN[1], _DRAWN[2], _DRAWN[5]]:
		var lesson: StringName = row[0]
		var method: String = row[1]
		var part: String = row[4]
		await _open_at_step(lesson)
		var drawn := await wait_for_answer(method)
		var arrow := frame().lesson.get_node(part) as Arrow
		assert_vec2(drawn.mark().from, Vec2.from_vector2(arrow.tail), 1e-6, method)
		assert_eq(drawn.mark().shape, OwnMark.Shape.ARROW)
		await _leave()


func test_numbers_stand_beside_the_shadow() -> void:
	await open_with_desk(&"dot_product")
	await save_hand_in("scalar_twice")
	assert_eq((await wait_for_answer("scalar_projection")).words(), "yours: a·b̂ = 0.5")
	await save_hand_in("right_plain")
	assert_eq((await wait_for_answer("scalar_projection")).words(), "yours: a·b̂ = 5")
	var note := (await wait_for_answer("dot")).mark()
	assert_eq(note.shape, OwnMark.Shape.NOTE)
	assert_vec2(note.to, Vec2.new(4.0, -3.0), 1e-9)


func test_the_distance_is_a_length_from_the_ball_to_the_line() -> void:
	await open_with_desk(&"line_distance")
	await save_hand_in("distance_sign")
	assert_almost_eq(_end_of_distance(await wait_for_answer("distance_to_line")), 200.0, 1e-6)
	await save_hand_in("right_plain")
	assert_almost_eq(_end_of_distance(await wait_for_answer("distance_to_line")), 0.0, 1e-6)


func test_the_ring_is_full_where_the_ball_is_said_to_touch() -> void:
	await open_with_desk(&"line_distance")
	for hand_in: String in ["touching_reversed", "right_plain"]:
		await save_hand_in(hand_in)
		var is_right := hand_in == "right_plain"
		var ring := await wait_for_answer("is_touching")
		assert_eq(ring.mark().is_filled, not is_right)
		assert_eq(ring.words(), "yours: is free" if is_right else "yours: touches")
		await click_button("Too close")
		ring = await wait_for_answer("is_touching")
		assert_eq(ring.mark().is_filled, is_right)
		await click_button("Free")


func test_no_impact_is_told_in_words() -> void:
	await open_with_desk(&"point_of_impact")
	await save_hand_in("right_plain")
	await click_button("Not yet")
	var drawn := await wait_for_answer("time_of_impact")
	assert_eq(drawn.words(), "yours: no impact")
	assert_true(drawn.is_right())
	assert_eq(drawn.mark().shape, OwnMark.Shape.NOTE)


func test_what_needs_no_reset_has_none() -> void:
	await open_with_desk(&"point_of_impact")
	await save_hand_in("right_plain")
	await wait_for_answer("position_reset")
	await click_button("Not yet")
	await wait_for_answer("time_of_impact")
	assert_null(answers().shown("position_reset"))


func test_the_first_of_two_methods_is_drawn_while_the_second_is_open() -> void:
	await open_with_desk(&"dot_product")
	var text := FileAccess.get_file_as_string(HAND_INS.path_join("right_plain/my_vec2.gd"))
	var body := "\treturn onto.normalized().scaled(scalar_projection(onto))"
	assert_string_contains(text, body)
	var before := watcher.report
	save_file("my_vec2.gd", text.replace(body, "\treturn null"))
	await wait_for_verdict(before)
	assert_eq(watcher.report.verdict(4).kind, WorkshopVerdict.Kind.OPEN)
	assert_true((await wait_for_answer("scalar_projection")).is_right())
	assert_null(answers().shown("vector_projection"))


func test_words_cover_no_card() -> void:
	await open_with_desk(&"dot_product")
	await save_hand_in("right_plain")
	await go_to_step()
	var places := OwnPlaces.new(frame().lesson.board)
	var card := (frame().lesson.get_node("%Verdict") as Control).get_rect()
	var extent := Vector2(200.0, 30.0)
	for count in 4:
		var middle := places.take(card.get_center(), 0.0, Vector2.DOWN, extent)
		var taken := Rect2(middle - extent / 2.0, extent)
		assert_false(card.intersects(taken), "place %d" % count)


func _open_at_step(lesson: StringName) -> void:
	await open_with_desk(lesson)
	await go_to_step(_STEPS[lesson])


# Each lesson begins with its own numbers.
func _leave() -> void:
	screen().free()
	LessonBoards.forget_all()
	await student.settle()


# The head of an arrow, or the middle of a ball.
func _place_of(part: Node) -> Vec2:
	var arrow := part as Arrow
	if arrow:
		return Vec2.from_vector2(arrow.head)
	return (part as BallView).at()


func _end_of_distance(drawn: OwnQuestion) -> float:
	var line: PackedFloat64Array = frame().lesson.link_state()["line"]
	var start := Vec2.new(line[0], line[1])
	var segment := LineSegment.new(start, Vec2.new(line[2], line[3]))
	return LineDistance.signed_distance(drawn.mark().to, segment)
