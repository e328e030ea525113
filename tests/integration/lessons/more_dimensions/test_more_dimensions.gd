extends LessonTest
## The lesson on more dimensions, driven as a student does.

const _HALF_A_HANDLE := Vector2(Handle.TOUCH_SIZE, Handle.TOUCH_SIZE) / 2.0


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"more_dimensions"))
	await go_to_step(MoreDimensionsTexts.Step.ANGLE)


func test_the_first_sight_is_an_acute_angle_in_space() -> void:
	assert_reads("a · b > 0\nthe angle is below 90°")
	assert_has(formula_lines(), "a · b = 4·2 + (−3)·(−4) + 2·(−1) = 18")
	assert_has(formula_lines(), "α = 43.16°")
	assert_true(_part("Picture").visible)


func test_the_presets_show_all_three_signs() -> void:
	await click_button("Right angle")
	assert_reads("a · b = 0\na right angle")
	await click_button("Obtuse")
	assert_reads("a · b < 0\nthe angle is above 90°")
	await click_button("Acute")
	assert_reads("a · b > 0\nthe angle is below 90°")


func test_the_fourth_component_takes_part_in_the_same_formula() -> void:
	await click_button("Four components")
	assert_has(formula_lines(), "a · b = 4·2 + (−3)·(−4) + 2·(−1) + 1·3 = 21")
	assert_false(_part("Picture").visible)
	assert_not_null(Screen.named(screen(), "Component 4 of a"))


func test_five_components_take_part_in_the_same_formula_and_four_do_not_then() -> void:
	await click_button("Four components")
	await click_button("Five components")
	assert_has(formula_lines(), "a · b = 4·2 + (−3)·(−4) + 2·(−1) + 1·3 + 3·(−2) = 15")
	var has_four: bool = frame().lesson.state()["has_four"]
	assert_false(has_four)
	assert_not_null(Screen.named(screen(), "Component 5 of b"))
	await click_button("Five components")
	assert_true(_part("Picture").visible)


func test_the_last_step_says_what_the_dot_product_is_for() -> void:
	assert_does_not_read("moment of the touch")
	await student.press(&"lab_next_step")
	assert_reads("moment of the touch")
	assert_reads("t = (distance − r) / (−v · n̂)")
	for part: String in ["Picture", "Bars", "Stairs", "VerdictCard", "Hint"]:
		assert_false(_part(part).visible, part)
	await student.press(&"lab_previous_step")
	for part: String in ["Picture", "Bars", "Stairs", "VerdictCard", "Hint"]:
		assert_true(_part(part).visible, part)


# The table of the last step names them by their numbers.
func test_the_lessons_of_the_table_have_the_numbers_that_it_says() -> void:
	var shown: Dictionary[StringName, String] = {
		&"normals": "3",
		&"dot_product": "4",
		&"projection_proof": "5",
		&"line_distance": "6",
		&"point_of_impact": "7",
		&"reflection": "8",
		&"angled_lines": "9",
		&"line_ends": "10",
		&"more_dimensions": "11",
	}
	for id in shown:
		assert_eq(LessonIndex.lessons()[shown[id].to_int() - 1].id, id)


func test_the_card_covers_no_bar_where_bars_fill_the_board() -> void:
	await click_button("Four components")
	await click_button("Flat")
	var card := _part("VerdictCard").get_global_rect()
	var highest := _part("Bars").get_node("B1") as Control
	assert_false(card.grow(8.0).has_point(highest.get_global_rect().get_center()))
	assert_gt(_part("Bars").get_global_rect().position.y, card.end.y)


func test_typed_components_are_taken() -> void:
	await student.enter(_field("Component 3 of b"), "-2.5")
	assert_eq(numbers("b"), PackedFloat64Array([2, -4, -2.5, 3]))
	assert_has(formula_lines(), "a · b = 4·2 + (−3)·(−4) + 2·(−2.5) = 15")


func test_a_component_that_cannot_be_is_refused() -> void:
	await student.enter(_field("Component 1 of a"), "1e7")
	assert_reads("1e7 cannot be: a component is 0, or from 1e-6 to 1e6 in size.")
	assert_eq(numbers("a"), PackedFloat64Array([4, -3, 2, 1]))


func test_dragging_the_end_of_a_bar_changes_its_component_only() -> void:
	var handle := _part("Bars").get_node("B2") as Control
	var from := handle.get_global_rect().get_center()
	var unit := (_part("Bars") as ComponentBars).pixels_per_unit
	await student.drag(from, from - Vector2(0.0, 3.0 * unit))
	assert_eq(numbers("b"), PackedFloat64Array([2, -1, -1, 3]))
	assert_eq(numbers("a"), PackedFloat64Array([4, -3, 2, 1]))


func test_arrow_keys_nudge_a_bar_by_one() -> void:
	(_part("Bars").get_node("A1") as Control).grab_focus()
	await student.press(&"ui_up")
	await student.press(&"ui_left")
	assert_eq(numbers("a"), PackedFloat64Array([5, -3, 2, 1]))


func test_dragging_a_head_moves_it_to_whole_numbers_near_the_pointer() -> void:
	var picture := _part("Picture") as SpacePicture
	var head := picture.get_node("%HeadOfA") as Control
	var target := picture.to_plane(head.position + _HALF_A_HANDLE)
	target.add(Vec2.new(3, 2))
	var from := Screen.named(screen(), "Head of a").get_global_rect().get_center()
	await student.drag(from, from + Vector2(3.0, 2.0) * picture.pixels_per_unit)
	var a := numbers("a")
	assert_eq(a, PackedFloat64Array([roundf(a[0]), roundf(a[1]), roundf(a[2]), 1]))
	# Rounding each component moves the head by half the diagonal of a unit cube at most.
	assert_lt(Axonometry.new().seen_at(a[0], a[1], a[2]).distance_to(target), sqrt(0.75))


func test_dragging_beside_the_arrows_turns_the_view_and_nothing_else() -> void:
	var corner := _part("Picture").get_global_rect().end - Vector2(60.0, 60.0)
	var view := numbers("view")
	await student.drag(corner, corner - Vector2(100.0, 30.0))
	assert_almost_eq(numbers("view")[0], view[0] + 1.0, 0.01)
	assert_eq(numbers("a"), PackedFloat64Array([4, -3, 2, 1]))
	await student.press(&"lab_undo")
	assert_eq(numbers("view"), view)


func test_undo_redo_and_reset() -> void:
	await click_button("Obtuse")
	await student.press(&"lab_undo")
	assert_reads("the angle is below 90°")
	await student.press(&"lab_redo")
	assert_reads("the angle is above 90°")
	await student.press(&"lab_reset")
	assert_reads("the angle is below 90°")


func test_the_steps_build_the_sum_up() -> void:
	var counts: Array[int] = []
	for step: int in 5:
		counts.push_front(formula_lines().size())
		await student.press(&"lab_previous_step")
	assert_eq(counts, [2, 3, 3, 4, 7] as Array[int])
	assert_false(_part("Stairs").visible)
	await student.press(&"lab_next_step")
	assert_true(_part("Stairs").visible)


func test_the_sign_is_asked_for_before_it_is_shown() -> void:
	await go_to_step(MoreDimensionsTexts.Step.SUM)
	await student.press(&"lab_next_step")
	await click_button("below 90°")
	assert_reads("Right")
	assert_reads("a · b > 0")


func test_a_zero_vector_has_no_angle() -> void:
	for i: int in 3:
		await student.enter(_field("Component %d of a" % (i + 1)), "0")
	assert_reads("a zero vector makes no angle")
	assert_does_not_read("cos α")
	assert_false((frame().lesson.get_node("%Picture/Shadow") as CanvasItem).visible)


func test_the_table_comes_with_the_angle() -> void:
	assert_reads("cos α")
	await go_to_step(MoreDimensionsTexts.Step.SIGN)
	assert_does_not_read("cos α")


func test_at_the_opening_the_axes_turn_and_no_number_changes() -> void:
	screen().free()
	OpeningMotion.is_allowed = true
	await open_lesson(LessonIndex.find(&"more_dimensions"))
	OpeningMotion.is_allowed = false
	var first := numbers("view")[0]
	for i: int in 40:
		await get_tree().process_frame
	assert_gt(numbers("view")[0], first + 0.1)
	assert_eq(numbers("a"), PackedFloat64Array([4, -3, 2, 1]))


func test_hidden_answers_hide_the_angle_everywhere() -> void:
	await student.press(&"lab_hide_answers")
	assert_has(formula_lines(), "a · b ? 0: ?")
	assert_has(formula_lines(), "α = ?°")
	for part: String in ["%Arc", "%Shadow", "%Stairs", "%VerdictCard"]:
		var shown := frame().lesson.get_node(part) as CanvasItem
		assert_eq([shown.visible, shown.modulate.a], [true, 0.0], part)
	await student.press(&"lab_hide_answers")
	assert_has(formula_lines(), "α = 43.16°")


func test_the_arc_of_the_angle_goes_from_one_vector_to_the_other() -> void:
	var arc := frame().lesson.get_node("%Arc") as Line2D
	var from := frame().lesson.get_node("%ArrowOfA") as Arrow
	var to := frame().lesson.get_node("%ArrowOfB") as Arrow
	assert_lt(absf(arc.points[0].angle_to(from.head)), 1e-3)
	assert_lt(absf(arc.points[-1].angle_to(to.head)), 1e-3)
	await go_to_step(MoreDimensionsTexts.Step.SIGN)
	assert_false(arc.visible)


# The arc cosine would make 8.5e-7 degrees of them.
func test_parallel_vectors_make_no_angle_or_180_degrees() -> void:
	for i: int in 3:
		await student.enter(_field("Component %d of a" % (i + 1)), str(i + 3))
		await student.enter(_field("Component %d of b" % (i + 1)), str(2 * i + 6))
	assert_has(formula_lines(), "α = 0°")
	for i: int in 3:
		await student.enter(_field("Component %d of b" % (i + 1)), str(-2 * i - 6))
	assert_has(formula_lines(), "α = 180°")


func test_the_products_are_added_up_with_the_step_that_adds_them() -> void:
	var stairs := _part("Stairs") as ProductStairs
	await go_to_step(MoreDimensionsTexts.Step.PRODUCTS)
	assert_eq([stairs.accessibility_name, stairs.spanned()], ["The products", Vector2(-2, 12)])
	await go_to_step(MoreDimensionsTexts.Step.SUM)
	assert_eq(
		[stairs.accessibility_name, stairs.spanned()], ["The products added up", Vector2(0, 20)]
	)


func test_an_angle_just_below_90_degrees_is_not_shown_as_90() -> void:
	await click_button("Right angle")
	await student.enter(_field("Component 3 of b"), "-4.9999999")
	assert_reads("a · b > 0")
	assert_has(formula_lines(), "α = 89.9999996°")


func test_a_question_is_answered_and_shown_on_the_board() -> void:
	(frame().lesson.services[&"question"] as FoldableContainer).folded = false
	await student.settle()
	await student.enter(_field("a · b ="), "0.5")
	assert_reads("0.5 is not it yet")
	await click_button("Show on board")
	var last := formula_lines()[2].get_slice(" = ", 2).replace("(", "").replace(")", "")
	await student.enter(_field("a · b ="), last)
	assert_reads("Right: %s." % last)


func _part(part_name: String) -> Control:
	return frame().lesson.get_node("%" + part_name) as Control


# A handle of the bars has the same name as its field.
func _field(title: String) -> LineEdit:
	var panel := frame().get_node("%Panel")
	return Screen.named(panel, title) as LineEdit
