extends DotProductTest
## Typing over the numbers in the formula of the lesson on the dot product.


func test_a_typed_number_moves_the_arrow() -> void:
	await student.enter(field("x of a"), "3")
	assert_a([0, 0, 3, 1])


func test_each_field_sets_its_own_component() -> void:
	await student.enter(field("x of a"), "1")
	await student.enter(field("y of a"), "2.5")
	await student.enter(field("x of b"), "-3e2")
	await student.enter(field("y of b"), "0,5")
	assert_a([0, 0, 1, 2.5])
	assert_b([0, 0, -300, 0.5])


func test_a_typed_number_is_the_difference_of_head_and_tail() -> void:
	await drag(Vec2.new(3.5, 0.5), Vec2.new(1.5, 3.5))
	await student.enter(field("x of a"), "3")
	assert_a([-2, 3, 1, 4])


func test_a_number_is_taken_when_the_field_is_left() -> void:
	await student.click(field("x of a"))
	await student.press_key(KEY_A, false, true)
	await student.type_text("4")
	await student.press_key(KEY_TAB)
	assert_a([0, 0, 4, 1])


func test_what_cannot_be_taken_gets_one_notice_and_changes_nothing() -> void:
	for text: String in ["abc", "2.5e", "1e4294967296", "1e101", "1e-101", "1.2.3"]:
		await student.enter(field("x of a"), text)
		assert_eq(
			notice(),
			(
				(
					"“%s” cannot be taken: type 0 or a number from 1e-100 to 1e100 in size, like 7, "
					+ "-2.5 or 3e8."
				)
				% text
			)
		)
		assert_a([0, 0, 7, 1], text)


func test_what_is_typed_is_taken_to_the_last_bit() -> void:
	await student.enter(field("x of a"), "00000000000000000001.5")
	await student.enter(field("y of a"), "0.0000000000000000271")
	await student.enter(field("x of b"), " −0,1 ")
	await student.enter(field("y of b"), "5.2999999999999998")
	assert_a([0, 0, 1.5, 2.71e-17])
	assert_b([0, 0, -0.1, 5.3])


func test_the_notice_goes_with_the_next_number_that_is_taken() -> void:
	await student.enter(field("x of a"), "abc")
	await student.enter(field("x of a"), "3")
	assert_eq(notice(), "")


func test_the_notice_goes_with_the_next_change_on_the_board() -> void:
	await student.enter(field("x of a"), "abc")
	await student.click_at(place(-3, -4))
	assert_eq(notice(), "")
	assert_eq(field("x of a").text, "-3")


func test_escape_puts_the_number_back_and_stays_in_the_lesson() -> void:
	await student.click(field("x of a"))
	await student.type_text("99")
	await student.press_key(KEY_ESCAPE)
	assert_eq(field("x of a").text, "7")
	assert_a([0, 0, 7, 1])
	assert_not_null(frame())


func test_escape_takes_the_notice_away() -> void:
	await student.enter(field("x of a"), "abc")
	await student.press_key(KEY_ESCAPE)
	assert_eq(notice(), "")
	assert_eq(field("x of a").text, "7")


func test_letters_typed_into_a_field_are_no_shortcuts() -> void:
	await student.click_at(place(-3, -4))
	await student.click(field("x of a"))
	await student.type_text("rsp")
	assert_a([0, 0, -3, -4], "not reset")
	assert_false((frame().lesson.services[&"transport"] as Transport).is_playing)


func test_a_field_shows_what_undo_brings_back_while_it_has_the_focus() -> void:
	await student.enter(field("x of a"), "3")
	await student.press(&"lab_undo")
	assert_a([0, 0, 7, 1])
	assert_eq(field("x of a").text, "7")


func test_a_field_that_is_left_untouched_changes_nothing() -> void:
	await student.click(field("x of a"))
	await student.click_at(place(-3, -4))
	await click_button("Undo")
	await click_button("Redo")
	assert_a([0, 0, -3, -4])


func test_a_long_number_shows_all_its_digits_only_while_its_field_has_the_focus() -> void:
	var state := frame().lesson.state()
	state["a"] = PackedFloat64Array([5.0 * sqrt(2.0), 1.0])
	frame().lesson.show_state(state)
	assert_eq(field("x of a").text, "7.071")
	await student.click(field("x of a"))
	assert_eq(field("x of a").text, "7.07106781187")
	await student.click(field("y of a"))
	assert_eq(field("x of a").text, "7.071")
	assert_a([0, 0, 5.0 * sqrt(2.0), 1.0])


func test_a_number_that_was_not_entered_is_lost_without_an_error_on_the_way_back() -> void:
	Navigation.open_lesson(get_tree(), LessonIndex.find(&"dot_product"))
	await student.settle()
	await student.click(field("x of a"))
	await student.type_text("abc")
	await student.press_pad(JOY_BUTTON_B)
	assert_null(frame())


func test_pointing_at_a_symbol_lights_its_arrow_up() -> void:
	var lit: Array[Node] = screen().find_children("*", "Node2D", true, false).filter(
		func(node: Node) -> bool: return node is Arrow and (node as Arrow).role == Palette.Role.A
	)
	student.move_to(field("x of a").get_global_rect().get_center())
	assert_true((lit[0] as Arrow).lit)
	student.move_to(place(-3, -4))
	assert_false((lit[0] as Arrow).lit)
