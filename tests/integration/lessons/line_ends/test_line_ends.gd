extends LessonTest
## The lesson on line ends, driven as a student does: the same shot in five fields.

const _START := [-6.0, -8.0, 6.0, 16.0, 5.0]
const _SMALL_FIELDS: Array[String] = [
	"InfiniteOneSided", "InfiniteTwoSided", "SegmentOneSided", "SegmentTwoSided"
]


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"line_ends"))
	await go_to_step()


func test_at_the_start_each_field_says_what_happens_in_it() -> void:
	assert_eq(_words("InfiniteOneSided"), "passes through from behind")
	assert_eq(_words("InfiniteTwoSided"), "bounces in the air, t = 0.1975")
	assert_eq(_words("SegmentOneSided"), "finds no hit, cuts through the end")
	assert_eq(_words("SegmentTwoSided"), "finds no hit, cuts through the end")
	assert_eq(_words("RoundCaps"), "bounces on the end, t = 0.5")


func test_the_start_is_read_from_the_scene_of_a_field() -> void:
	var view := _field("RoundCaps")
	(view.get_node("%Shot") as DraggableVector).lay(Vec2.new(1, 2), Vec2.new(4, 6))
	(view.get_node("%Line") as DraggableVector).lay(Vec2.new(-5, 7), Vec2.new(5, 7))
	(view.get_node("%StartBall") as BallView).radius = 2.5
	var model := LineEndsModel.new()
	(frame().lesson.get_node("%Drawing") as LineEndsDrawing).put_start(model)
	assert_vec2(model.start, Vec2.new(1, 2), 0.0)
	assert_vec2(model.motion, Vec2.new(3, 4), 0.0)
	assert_vec2(model.segment.start, Vec2.new(-5, 7), 0.0)
	assert_vec2(model.segment.end, Vec2.new(5, 7), 0.0)
	assert_eq(model.radius, 2.5)


func test_dragging_the_shot_in_one_field_moves_it_in_all() -> void:
	for field_name: String in _SMALL_FIELDS + (["RoundCaps"] as Array[String]):
		var before := numbers("shot")
		await _drag(field_name, before[0] + before[2], before[1] + before[3], 3.0, -1.0)
		assert_eq(numbers("shot"), _with_head(before, 3.0, -1.0), field_name)
		assert_eq(_ball_place("SegmentTwoSided"), _ball_place("SegmentOneSided"))
		await student.press(&"lab_undo")


func test_dragging_the_ball_keeps_the_head_where_it_is() -> void:
	await _drag("RoundCaps", -6, -8, -10, -6)
	assert_eq(numbers("shot"), PackedFloat64Array([-10, -6, 10, 14, 5]))


func test_dragging_an_end_moves_the_line_in_all_fields() -> void:
	await _drag("SegmentTwoSided", 13, 8, 10, -2)
	assert_eq(numbers("line"), PackedFloat64Array([1, 3, 10, -2]))


func test_a_left_click_aims_and_a_right_click_moves_the_ball() -> void:
	await student.click_at(_place("RoundCaps", -12, 6))
	assert_eq(numbers("shot"), PackedFloat64Array([-6, -8, -6, 14, 5]))
	await student.click_at(_place("RoundCaps", -10, 10), MOUSE_BUTTON_RIGHT)
	assert_eq(numbers("shot"), PackedFloat64Array([-10, 10, -6, 14, 5]))


func test_arrow_keys_nudge_the_shot() -> void:
	Screen.named(_field("RoundCaps"), "Head of v").grab_focus()
	await student.press(&"ui_left")
	await student.press(&"ui_up")
	assert_eq(numbers("shot"), PackedFloat64Array([-6, -8, 5, 15, 5]))


func test_the_tab_key_reaches_the_handles_of_one_field_only() -> void:
	for field_name: String in _SMALL_FIELDS:
		assert_eq(Screen.named(_field(field_name), "Head of v").focus_mode, Control.FOCUS_NONE)
	var handle := Screen.named(_field("RoundCaps"), "Start of line")
	assert_eq(handle.focus_mode, Control.FOCUS_ALL)


func test_typed_numbers_move_the_shot_and_the_line() -> void:
	await student.enter(_number_field("x of v"), "8")
	await student.enter(_number_field("radius"), "3")
	await student.enter(_number_field("y of B"), "-2.5")
	assert_eq(numbers("shot"), PackedFloat64Array([-6, -8, 8, 16, 3]))
	assert_eq(numbers("line"), PackedFloat64Array([1, 3, 13, -2.5]))


func test_a_radius_that_cannot_be_is_refused_and_nothing_is_lost() -> void:
	await student.enter(_number_field("radius"), "-2")
	assert_reads("A radius of −2 cannot be: it goes from 0.001 to 1e6.")
	assert_eq(numbers("shot"), PackedFloat64Array(_START))


func test_a_line_without_length_is_refused() -> void:
	await _drag("RoundCaps", 13, 8, 1, 3)
	assert_reads("The line must be at least 0.001 long: its ends must differ.")
	assert_gt(Vec2.new(numbers("line")[2] - 1.0, numbers("line")[3] - 3.0).length(), 0.5)


func test_undo_redo_and_reset() -> void:
	await student.enter(_number_field("x of v"), "8")
	await student.press(&"lab_undo")
	assert_eq(numbers("shot"), PackedFloat64Array(_START))
	await student.press(&"lab_redo")
	assert_eq(numbers("shot")[2], 8.0)
	await student.press(&"lab_reset")
	assert_eq(numbers("shot"), PackedFloat64Array(_START))


func test_the_steps_bring_one_kind_of_line_after_the_other() -> void:
	var counts: Array[int] = []
	for step: int in 7:
		counts.push_front(_visible_fields())
		await student.press(&"lab_previous_step")
	assert_eq(counts, [1, 2, 4, 5, 5, 5, 5] as Array[int])


func test_only_the_large_field_names_the_motion() -> void:
	for step: int in 7:
		var names := 0
		for node: Node in frame().lesson.find_children("Arrow", "Node2D", true, false):
			var arrow := node as Arrow
			names += 1 if arrow.label == "v" and arrow.is_visible_in_tree() else 0
		assert_eq(names, 1, "%d steps back" % step)
		await student.press(&"lab_previous_step")


func test_the_graph_and_the_roots_come_with_their_steps() -> void:
	await student.press(&"lab_previous_step")
	assert_true(_part("Second").visible)
	assert_has(formula_lines(), "t = (−b ± √D) / (2 a)")
	assert_has(formula_lines(), "t₁ = (436 − 144) / 584 = 0.5")
	await student.press(&"lab_previous_step")
	assert_false(_part("First").visible)
	assert_true((frame().lesson.find_child("Graph") as Control).visible)
	await student.press(&"lab_previous_step")
	assert_false((frame().lesson.find_child("Graph") as Control).visible)


func test_the_field_of_the_step_is_the_largest_one() -> void:
	var active: Dictionary[int, String] = {
		1: "InfiniteTwoSided", 2: "SegmentTwoSided", 4: "RoundCaps"
	}
	for step in active:
		await go_to_step(step)
		for field_name: String in _SMALL_FIELDS:
			if field_name != active[step] and _field(field_name).visible:
				assert_gt(_field(active[step]).size.x, _field(field_name).size.x * 1.2, field_name)


func test_the_normal_is_asked_for_before_the_bounce() -> void:
	await go_to_step(LineEndsTexts.Step.ROOTS)
	await student.press(&"lab_next_step")
	await click_button("perpendicular to the line")
	assert_reads("No, from the end to the ball's centre")
	assert_has(formula_lines(), "n̂ = (P + t₁ v − A) / r = (−0.8, −0.6)")


func test_what_becomes_of_the_ball_is_hidden_with_the_answers() -> void:
	await student.press(&"lab_hide_answers")
	for part: String in ["Ball", "Flight", "ImpactBall", "Words"]:
		for field_name: String in _SMALL_FIELDS:
			var drawn := _field(field_name).get_node("%" + part) as CanvasItem
			assert_eq(drawn.modulate.a, 0.0, "%s in %s" % [part, field_name])
	assert_eq((frame().lesson.find_child("Graph") as CanvasItem).modulate.a, 0.0)
	assert_eq(_part("Normal").modulate.a, 0.0)
	assert_eq(_part("StartBall").modulate.a, 1.0)


func test_before_its_step_the_ball_stops_where_it_touches_the_end() -> void:
	for step: int in [LineEndsTexts.Step.CAP, LineEndsTexts.Step.ROOTS]:
		await go_to_step(step)
		assert_eq(_ball_place("RoundCaps"), str(Vec2.new(-3, 0)), "the touch, at t = 0.5")
	assert_eq(_words("RoundCaps"), "touches the end, t = 0.5")
	await go_to_step(LineEndsTexts.Step.CAP)
	assert_eq(_words("RoundCaps"), "touches the end")
	await go_to_step(LineEndsTexts.Step.BOUNCE)
	assert_eq(_words("RoundCaps"), "bounces on the end, t = 0.5")
	assert_ne(_ball_place("RoundCaps"), str(Vec2.new(-3, 0)))


func test_the_roots_are_marked_with_their_step() -> void:
	for step: int in [LineEndsTexts.Step.QUADRATIC, LineEndsTexts.Step.ROOTS]:
		await go_to_step(step)
		var graph := frame().lesson.find_child("Graph") as CapGraph
		assert_eq(graph.shows_roots, step == LineEndsTexts.Step.ROOTS)


func test_whether_it_touches_an_end_is_asked_only_where_it_is_one_of_both() -> void:
	for preset: String in ["Middle", "Good side"]:
		await click_button(preset)
		await go_to_step(LineEndsTexts.Step.SEGMENT)
		await student.press(&"lab_next_step")
		assert_eq(frame().lesson.step, LineEndsTexts.Step.CAP, preset)
	await student.press(&"lab_reset")
	await click_button("Miss")
	await go_to_step(LineEndsTexts.Step.SEGMENT)
	await student.press(&"lab_next_step")
	assert_eq(frame().lesson.step, LineEndsTexts.Step.SEGMENT)
	await click_button("it passes")
	assert_reads("Right")


func test_the_last_step_speaks_of_this_ball() -> void:
	for case: Array in [
		["Middle", "This ball bounces on the line"],
		["Miss", "This ball touches neither the line nor an end"],
		["Head-on", "n̂ points from the end"],
	]:
		await click_button(str(case[0]))
		assert_reads(str(case[1]))


func test_a_ball_that_only_grazes_an_end_has_no_root_that_counts() -> void:
	await student.enter(_number_field("x of the ball's centre"), "-8")
	await student.enter(_number_field("y of the ball's centre"), "3")
	await student.enter(_number_field("x of v"), "16")
	await student.enter(_number_field("y of v"), "0")
	await student.enter(_number_field("radius"), "3")
	await student.enter(_number_field("x of B"), "0")
	await student.enter(_number_field("y of B"), "-6")
	await student.enter(_number_field("x of A"), "0")
	await student.enter(_number_field("y of A"), "0")
	await go_to_step(LineEndsTexts.Step.ROOTS)
	assert_eq(_words("RoundCaps"), "passes beside")
	assert_string_contains(formula_lines()[-1], "it only grazes: none")


func test_a_ball_that_overlaps_the_end_takes_its_normal_at_the_start() -> void:
	await click_button("Overlap")
	assert_has(formula_lines(), "n̂ = d / |d| = (−0.7071, −0.7071)")


func test_a_near_miss_says_that_there_is_no_root() -> void:
	await click_button("Miss")
	await go_to_step(LineEndsTexts.Step.ROOTS)
	assert_has(formula_lines(), "D < 0: no root. This end is not touched.")
	assert_false(_part("First").visible)


func test_playing_flies_the_ball_and_stops_at_the_end_of_the_frame() -> void:
	await student.press(&"lab_pause")
	assert_lt(_fraction(), 1.0, "it starts again")
	Engine.time_scale = 20.0
	for i: int in 3000:
		if not _transport().is_playing:
			break
		await get_tree().process_frame
	Engine.time_scale = 1.0
	assert_eq(_fraction(), 1.0)


func test_a_step_back_and_on_ends_at_the_same_place() -> void:
	var end := _ball_place("RoundCaps")
	await click_button("One frame back")
	assert_ne(_ball_place("RoundCaps"), end)
	await click_button("One frame on")
	assert_eq(_ball_place("RoundCaps"), end)


func test_a_drag_pauses() -> void:
	await student.press(&"lab_pause")
	await _drag("RoundCaps", 0, 8, 2, 4)
	assert_false(_transport().is_playing)


func test_each_mistake_names_itself_and_its_wrong_fraction() -> void:
	var wrong: Dictionary[String, String] = {
		"Mistake 18": "t = −736269",
		"Mistake 19": "t = NaN",
		"Mistake 20": "t = −0.5",
		"Mistake 22": "t = 0.19753",
		"Mistake 23": "t = 0.26426",
	}
	for heading: String in wrong:
		await _pick_mistake(heading)
		assert_string_contains(_words("RoundCaps"), "✗ the wrong ball: " + wrong[heading])
		await student.press(&"lab_reset")
	assert_false(_part("WrongBall").visible)


func test_a_mistake_that_the_shot_hides_brings_its_own_shot() -> void:
	await _pick_mistake("Mistake 19")
	assert_eq(numbers("shot"), PackedFloat64Array([-9, -7, 16, 12, 3]))
	await student.press(&"lab_undo")
	assert_eq(numbers("shot"), PackedFloat64Array(_START))


func test_a_question_is_answered_and_shown_on_the_board() -> void:
	(frame().lesson.services[&"question"] as FoldableContainer).folded = false
	await student.settle()
	await student.enter(_number_field("t ="), "-7.25")
	assert_reads("is not it yet")
	await click_button("Show on board")
	assert_eq(_words("RoundCaps").begins_with("bounces on the end"), true)
	var fraction := _words("RoundCaps").get_slice(" = ", 1)
	await student.enter(_number_field("t ="), fraction)
	assert_reads("Right: %s." % fraction)


func test_all_fields_keep_the_shot_in_sight_at_every_size() -> void:
	for window_size: Vector2i in [Vector2i(1280, 720), Vector2i(720, 1280), Vector2i(800, 600)]:
		await resize(window_size)
		for field_name: String in _SMALL_FIELDS + (["RoundCaps"] as Array[String]):
			var board := _board(field_name)
			var inside := Rect2(Vector2.ZERO, board.size)
			var radius := Vec2.new(5, 5)
			for corner: Vec2 in [Vec2.new(-6, -8).minus(radius), Vec2.new(0, 8).plus(radius)]:
				var text := "%s at %s" % [field_name, window_size]
				assert_true(inside.has_point(board.to_screen(corner)), text)


func _field(field_name: String) -> LineEndsField:
	return frame().lesson.find_child(field_name) as LineEndsField


func _board(field_name: String) -> Board:
	return _field(field_name).get_node("%Board") as Board


func _part(part_name: String) -> CanvasItem:
	return _field("RoundCaps").get_node("%" + part_name) as CanvasItem


func _place(field_name: String, x: float, y: float) -> Vector2:
	var board := _board(field_name)
	return board.get_global_transform() * board.to_screen(Vec2.new(x, y))


func _drag(field_name: String, x: float, y: float, to_x: float, to_y: float) -> void:
	await student.drag(_place(field_name, x, y), _place(field_name, to_x, to_y))


func _words(field_name: String) -> String:
	return (_field(field_name).get_node("%Words") as Label).text.replace("\u00a0=\u00a0", " = ")


func _fraction() -> float:
	return frame().lesson.state()["time"]


func _with_head(shot: PackedFloat64Array, x: float, y: float) -> PackedFloat64Array:
	return [shot[0], shot[1], x - shot[0], y - shot[1], shot[4]]


func _ball_place(field_name: String) -> String:
	return str((_field(field_name).get_node("%Ball") as BallView).at())


func _number_field(title: String) -> LineEdit:
	return Screen.named(screen(), title) as LineEdit


func _transport() -> Transport:
	return frame().lesson.services[&"transport"] as Transport


func _visible_fields() -> int:
	var count := 0
	for field_name: String in _SMALL_FIELDS + (["RoundCaps"] as Array[String]):
		count += 1 if _field(field_name).visible else 0
	return count


func _pick_mistake(heading: String) -> void:
	var list := frame().lesson.services[&"mistakes"].get_node("%List") as OptionButton
	list.grab_focus()
	await student.press(&"ui_accept")
	for i: int in list.item_count + 1:
		var focused := list.get_popup().get_focused_item()
		if focused < 0 or not list.get_item_text(focused).begins_with(heading):
			await student.press(&"ui_down")
	await student.press(&"ui_accept")
