extends LessonTest
## Drives the lesson on bank shots: steps, dragging, typing, the orders of walls, the bug gallery,
## and the shot.

const _SLANTED := "order=21&bounces=2&start=60,60&target=190,60&radius=10"


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"bank_shot"))


func test_the_steps_build_image_and_bounce_with_the_numbers_put_in() -> void:
	assert_eq(formula_lines()[0], "S = ( 100 , 100 )   T = ( 300 , 160 )")
	await go_to_step(BankShotModel.Step.BOUNCE)
	assert_has(formula_lines(), "n̂ = (0, −1)   o = (20, 300) + r n̂ = (20, 280)")
	assert_has(formula_lines(), "T′ = T − (1 + 1/C) d n̂ = (300, 400)")
	assert_has(formula_lines(), "B = S + s (T′ − S) = (220, 280)")
	assert_has(formula_lines(), "(T′ − S) / |T′ − S| = (0.5547, 0.8321)")
	assert_reads("the way is 360.6 px long, as the line to T′")


func test_the_aim_is_asked_before_the_image_and_the_bounce_before_it_is_shown() -> void:
	await student.press(&"lab_next_step")
	await student.press(&"lab_next_step")
	assert_reads("Where on the moved wall do you aim?")
	assert_false(_is_drawn("%Image1"))
	await click_button("halfway between S and T")
	assert_reads("No, where the line to the mirror image of T crosses it")
	await student.press(&"lab_next_step")
	assert_reads("Drag the “?” there.")
	assert_false(_is_drawn("%Bounce1"))
	await drag(Vec2.new(200, 130), Vec2.new(220, 280))
	await student.press(&"lab_next_step")
	assert_reads("Exactly.")
	assert_true(_is_drawn("%Bounce1"))


func test_a_loss_puts_the_image_deeper() -> void:
	await go_to_step(BankShotModel.Step.IMAGE)
	await click_button("C = 0.5")
	assert_has(formula_lines(), "T′ = T − (1 + 1/C) d n̂ = (300, 520)")
	assert_reads("T′ is 1/C times as far behind")


func test_the_image_can_be_dragged_to_change_the_loss() -> void:
	await go_to_step(BankShotModel.Step.IMAGE)
	await click_button("C = 0.5")
	await drag(Vec2.new(300, 520), Vec2.new(300, 400))
	assert_eq(_model().board.bounciness, 1.0)
	await student.press(&"lab_undo")
	assert_eq(_model().board.bounciness, 0.5)


func test_the_moved_wall_can_be_dragged_to_change_the_radius() -> void:
	await go_to_step(BankShotModel.Step.MOVED_WALL)
	await drag(Vec2.new(377, 280), Vec2.new(377, 270))
	assert_eq(_model().board.radius, 30.0)


func test_start_target_and_walls_can_be_dragged() -> void:
	await drag(Vec2.new(100, 100), Vec2.new(80, 120))
	assert_eq(_model().board.start.to_vector2(), Vector2(80, 120))
	await drag(Vec2.new(300, 160), Vec2.new(340, 160))
	assert_eq(_model().board.target.to_vector2(), Vector2(340, 160))
	await drag(Vec2.new(440, 300), Vec2.new(440, 280))
	assert_eq(_model().board.walls[0].end.to_vector2(), Vector2(440, 280))
	for undo: int in 3:
		await student.press(&"lab_undo")
	assert_eq(_model().board.walls[0].end.to_vector2(), Vector2(440, 300))
	assert_eq(_model().board.start.to_vector2(), Vector2(100, 100))


func test_numbers_can_be_typed_and_what_cannot_be_is_told() -> void:
	await student.enter(Screen.named(screen(), "radius of the ball") as LineEdit, "10")
	assert_eq(_model().board.radius, 10.0)
	await student.enter(Screen.named(screen(), "y of the start of wall 1") as LineEdit, "280")
	assert_eq(_model().board.walls[0].start.y, 280.0)
	await student.enter(Screen.named(screen(), "bounciness C, 0.05 to 1") as LineEdit, "0")
	assert_reads("C must be within 0.05..1, not 0.")
	assert_eq(_model().board.bounciness, 1.0)


func test_each_order_of_walls_says_why_it_is_refused() -> void:
	await go_to_step(BankShotModel.Step.ORDERS)
	await click_button("No way")
	assert_reads("Orders of walls that lead to T: 0 of 3.")
	assert_reads("no order of walls leads to T")
	var list := Screen.named(screen(), "Order of walls") as OptionButton
	assert_eq(list.get_item_text(1), "1: it would bounce beside an end of wall 1")
	assert_eq(list.get_item_text(2), "2: S and T are on different sides of wall 2")
	assert_eq(list.get_item_text(3), "3: a wall is in the way")
	await _choose("Order of walls", 1)
	assert_eq(_model().order, "1")
	assert_reads("it would bounce beside an end of wall 1")


func test_the_number_of_bounces_can_be_chosen() -> void:
	await click_button("Three bounces")
	await go_to_step(BankShotModel.Step.BOUNCE)
	assert_has(formula_lines(), "B₂ = (215.1, 224.6)")
	await _choose("Bounces", 0)
	assert_eq(_model().board.bounces, 1)
	await _choose("Bounces", 1)
	assert_eq(_model().board.bounces, 2)


func test_the_shot_flies_to_the_target_and_its_miss_is_rounding() -> void:
	await go_to_step(BankShotModel.Step.FIRE)
	assert_reads("so far rounding alone may move it")
	var answer := _model().answer()
	assert_lt(answer.miss(), answer.bound)
	assert_lt(answer.bound, 1e-11)
	assert_false(_is_drawn("%Flying"))
	_advance(1.0)
	assert_true(_is_drawn("%Flying"))
	assert_almost_eq(_flying(), Vector2(200, 250), Vector2(1e-6, 1e-6))
	_advance(2.0)
	assert_almost_eq(_flying(), Vector2(300, 160), Vector2(1e-6, 1e-6))


func test_play_flies_pauses_and_goes_back_a_frame() -> void:
	await go_to_step(BankShotModel.Step.FIRE)
	await student.press(&"lab_next_frame")
	await student.press(&"lab_next_frame")
	var there := _flying()
	await student.press(&"lab_next_frame")
	assert_ne(_flying(), there)
	await student.press(&"lab_previous_frame")
	assert_almost_eq(_flying(), there, Vector2(1e-6, 1e-6))


func test_nothing_flies_before_the_last_step() -> void:
	assert_false((frame().lesson.services[&"transport"] as Transport).visible)
	await student.press(&"lab_pause")
	assert_false((frame().lesson.services[&"transport"] as Transport).is_playing)


func test_a_mistake_is_drawn_flies_and_prints_its_miss() -> void:
	var misses: Array[String] = ["20.3 px", "29.1 px", "48 px", "30.2 px"]
	for item: int in misses.size():
		await _choose("Known mistakes", item + 1)
		assert_true(frame().lesson.step >= BankShotModel.Step.BOUNCE)
		assert_reads("with the mistake it misses by " + misses[item])
		assert_true(_is_drawn("%WrongPath"))
	await go_to_step(BankShotModel.Step.FIRE)
	_advance(1.5)
	assert_true(_is_drawn("%WrongBall"))


func test_a_right_angle_hides_the_wrong_order() -> void:
	await _choose("Known mistakes", 4)
	await click_button("Right angle")
	assert_reads("the mistake changes nothing here")
	assert_false(_is_drawn("%WrongPath"))


func test_a_ball_that_overlaps_a_wall_is_told() -> void:
	await go_to_step(BankShotModel.Step.BOUNCE)
	await student.enter(Screen.named(screen(), "x of S") as LineEdit, "190")
	assert_reads("at S or T the ball overlaps wall 2: make room")


func test_a_link_holds_the_board() -> void:
	assert_eq(frame().link.open(_SLANTED), "")
	assert_eq(_model().order, "21")
	assert_eq(_model().board.bounces, 2)
	assert_string_contains(frame().link.open("bounces=4"), "bounces must be within 1..3, not 4.")
	assert_string_contains(
		frame().link.open("walls=1,1,1,1"), "A wall must be at least 0.01 px long"
	)


func test_a_question_sets_its_board() -> void:
	var question := frame().lesson.services[&"question"] as Question
	question.folded = false
	await student.settle()
	assert_not_null(Screen.named(question, "x ="))


func _advance(seconds: float) -> void:
	(frame().lesson.services[&"transport"] as Transport).advanced.emit(seconds)


func _flying() -> Vector2:
	return (frame().lesson.get_node("%Flying") as BallView).center


func _choose(title: String, item: int) -> void:
	var list := Screen.named(screen(), title) as OptionButton
	list.select(item)
	list.item_selected.emit(item)
	await student.settle()


func _is_drawn(part: String) -> bool:
	return (frame().lesson.get_node(part) as CanvasItem).visible


func _model() -> BankShotModel:
	return frame().lesson.get("_model")
