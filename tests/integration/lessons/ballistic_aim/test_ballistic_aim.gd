extends LessonTest
## Drives the lesson on aiming under gravity: steps, dragging, typing, the arcs, the bug gallery,
## the flight of the shot.

const _STEPS := BallisticAimModel.Step


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"ballistic_aim"))
	await go_to_step(_STEPS.ARCS)


func after_each() -> void:
	Engine.time_scale = 1.0
	await super()


func test_it_starts_with_two_arcs() -> void:
	assert_numbers("target", [200, 0])
	assert_has(formula_lines(), "D₁ = (200, 0) − (0, 300·1² / 2) = (200, −150)")
	assert_has(formula_lines(), "|D₁| = s t₁ = 250·1 = 250     d₁ = D₁ / |D₁| = (0.8, −0.6)")
	assert_reads("2 aims hit")


func test_the_times_come_from_a_quadratic_equation() -> void:
	await go_to_step(_STEPS.TIMES)
	assert_eq(formula_lines()[-2], "t₁ = |P| √(2 / (b + √w)) = 200 √(2 / (62500 + 17500)) = 1")
	assert_eq(formula_lines()[-1], "t₂ = √(2 (b + √w)) / g = √(2·(62500 + 17500)) / 300 = 1.333")


func test_the_least_speed_and_its_direction() -> void:
	await go_to_step(_STEPS.LEAST)
	assert_eq(formula_lines()[-2], "s₀² = g (|P| − P.y) = 300·(200 − 0) = 60000")
	assert_eq(formula_lines()[-1], "s₀ = 244.9")
	for part: String in ["Envelope", "Least", "FromP", "FromUp"]:
		assert_true(_is_drawn(part), part)


func test_the_other_arc_can_be_picked() -> void:
	await pick("Which aim is flown", "high arc")
	assert_has(formula_lines(), "|D₂| = s t₂ = 250·1.333 = 333.3     d₂ = D₂ / |D₂| = (0.6, −0.8)")
	await student.press(&"lab_undo")
	assert_eq(_model().arc, 0)


func test_the_target_can_be_dragged_across_the_edge() -> void:
	await drag(Vec2.new(200, 0), Vec2.new(160, -60))
	assert_numbers("target", [160, -60])
	assert_reads("out of reach: s must be at least 263.2")
	assert_does_not_read("2 aims hit")
	assert_false(_is_drawn("Arc1"))
	await student.press(&"lab_undo")
	assert_reads("2 aims hit")


func test_speed_and_gravity_can_be_dragged() -> void:
	await drag(Vec2.new(100, -75), Vec2.new(120, -90))
	assert_eq(_model().speed, 300.0)
	await drag(Vec2.new(0, 150), Vec2.new(0, 100))
	assert_eq(_model().gravity, 200.0)
	await drag(Vec2.new(0, 100), Vec2.new(0, -40))
	assert_eq(_model().gravity, 0.0, "it never points up")
	assert_reads("one aim hits")


func test_numbers_can_be_typed_and_wrong_ones_are_refused() -> void:
	await enter("speed of the bullet", "240")
	assert_reads("out of reach: s must be at least 244.9")
	await enter("gravity", "0")
	assert_reads("one aim hits")
	await enter("gravity", "-10")
	assert_reads("g must be within 0..100000, not −10")
	assert_eq(_model().gravity, 0.0)


func test_a_falling_target_is_aimed_at_straight() -> void:
	await click_button("Falling target")
	assert_has(formula_lines(), "D₁ = (160, −120)")
	assert_eq(formula_lines()[-1], "|D₁| = s t₁ = 400·0.5 = 200     d₁ = D₁ / |D₁| = (0.8, −0.6)")
	await _pick_mistake("Aimed at the present place")
	assert_reads("the mistake misses by")


func test_a_moving_target_has_a_velocity_to_drag() -> void:
	assert_false(_is_drawn("Velocity"))
	await click_button("The target moves")
	assert_true(_is_drawn("Velocity"))
	await drag(Vec2.new(170, 0), Vec2.new(200, 30))
	assert_numbers("velocity", [0, 60])
	assert_reads("2 aims hit")


func test_four_aims_hit_a_target_that_moves_fast() -> void:
	await click_button("Four aims")
	assert_reads("4 aims hit")
	assert_has(formula_lines(), "t₁ = 0.3592     t₂ = 0.8     t₃ = 1.5     t₄ = 3.341")
	for arc: int in 4:
		assert_true(_is_drawn("Arc%d" % (arc + 1)))


func test_each_mistake_is_named_and_misses() -> void:
	await _pick_mistake("Sign of g")
	assert_eq(formula_lines()[-1], "mistake: d = (0.8, 0.6)")
	assert_reads("the mistake misses by 146 px")
	assert_true(_is_drawn("WrongPath"))
	await _pick_mistake("One half forgotten")
	assert_reads("the mistake says t = 0.5, not 1, and finds no aim")
	assert_false(_is_drawn("WrongPath"))
	await _pick_mistake("Reach not tested")
	assert_reads("the mistake changes nothing here")
	await click_button("Out of reach")
	assert_reads("NaN, the bullet is lost")


func test_a_mistake_is_shown_where_a_single_aim_is() -> void:
	await go_to_step(_STEPS.DROP)
	await _pick_mistake("Gravity left out")
	assert_eq(frame().lesson.step, _STEPS.ARCS)


func test_the_shot_is_fired_and_misses_by_rounding_alone() -> void:
	await go_to_step(_STEPS.FIRE)
	assert_reads("; ε × condition 2.7e−13 px")
	assert_lt(_model().miss().distance, 1e-12)
	await click_button("Play or pause")
	var transport := frame().lesson.services[&"transport"] as Transport
	Engine.time_scale = 20.0
	for wait: int in 3000:
		if not transport.is_playing:
			break
		await get_tree().process_frame
	assert_almost_eq(_model().time, 1.0, 1e-12)
	assert_almost_eq(_bullet(), Vector2(200, 0), Vector2(1e-4, 1e-4))


func test_a_frame_back_takes_the_bullet_back() -> void:
	for press: int in 3:
		await click_button("One frame on")
	assert_almost_eq(_bullet(), Vector2(0.04, -0.03) * 250 + Vector2(0, 0.375), Vector2(1e-3, 1e-3))
	for press: int in 3:
		await click_button("One frame back")
	assert_almost_eq(_model().time, 0.0, 1e-12)


func test_before_the_arcs_the_bullet_is_shot_straight_and_comes_too_low() -> void:
	await go_to_step(_STEPS.STRAIGHT)
	for press: int in 6:
		await click_button("One frame on")
	assert_almost_eq(_bullet(), Vector2(25, 1.5), Vector2(1e-3, 1e-3))
	assert_reads("comes too low")


func test_it_asks_how_many_aims_hit_and_where_to_aim() -> void:
	await go_to_step(_STEPS.DROP)
	await student.press(&"lab_next_step")
	await click_button("in one")
	assert_reads("No, in two")
	await student.press(&"lab_next_step")
	assert_true(_is_drawn("Guess"))
	assert_false(_is_drawn("Arc1"))
	await drag(Vec2.new(200, 0), Vec2.new(200, -130))
	await student.press(&"lab_next_step")
	assert_reads("Your guess was 20 off.")
	assert_true(_is_drawn("Arc1"))


func test_the_readout_has_the_careful_time_beside_that_of_the_slide() -> void:
	var readout := frame().lesson.services[&"readout"] as Readout
	assert_eq(readout.cell(1, 1).text, "1")
	assert_eq(readout.cell(2, 0).text, "by tangents")
	await click_button("Straight up")
	assert_eq(readout.cell(2, 1).text, "divides by 0")
	await click_button("Moving target")
	assert_eq(readout.cell(2, 1).text, "only at rest")


func test_it_moves_by_itself_at_first() -> void:
	screen().free()
	OpeningMotion.is_allowed = true
	await open_lesson(LessonIndex.find(&"ballistic_aim"))
	OpeningMotion.is_allowed = false
	var swing := Callable(frame().lesson, &"_swing")
	var first := Vec2.new(200, 0)
	swing.call(2.5, first)
	assert_numbers("target", [200, -100])
	swing.call(5.0, first)
	assert_numbers("target", [200, 0])


func test_it_has_links() -> void:
	await click_button("Four aims")
	assert_string_contains(frame().link.text(), "target=0,-120")
	assert_eq(frame().link.open("target=80,-60&speed=200&gravity=250&arc=1"), "")
	assert_reads("one aim hits")
	assert_string_contains(frame().link.open("speed=0"), "s must be within 1..100000")


func _model() -> BallisticAimModel:
	return frame().lesson.get(&"_model")


func _bullet() -> Vector2:
	return (frame().lesson.get_node("%Bullet") as BallView).center


func _is_drawn(part: String) -> bool:
	return (frame().lesson.get_node("%" + part) as CanvasItem).is_visible_in_tree()


func _pick_mistake(title: String) -> void:
	await pick("Known mistakes", title)
