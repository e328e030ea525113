extends DotProductTest
## A key hides all answers for a class, and nothing else.


func test_the_key_hides_what_is_in_the_group_and_moves_nothing() -> void:
	await go_to_step()
	var places := _places()
	await student.press(&"lab_hide_answers")
	for part: String in [
		"%Projection", "%HeadDrop", "%Unit", "%Angle", "%Alpha", "%Plot", "%Verdict"
	]:
		assert_eq(_opacity(part), 0.0, part)
	assert_eq((frame().lesson.get_node("%A") as CanvasItem).modulate.a, 1.0)
	assert_eq(_places(), places)
	await student.press(&"lab_hide_answers")
	for part: String in ["%Projection", "%Plot", "%Verdict"]:
		assert_eq(_opacity(part), 1.0, part)


func test_the_menu_does_the_same() -> void:
	await go_to_step()
	await pick_in_view_menu("Answers")
	assert_eq(_opacity("%Verdict"), 0.0)
	await pick_in_view_menu("Answers")
	assert_eq(_opacity("%Verdict"), 1.0)


func test_numbers_that_cannot_be_typed_are_question_marks() -> void:
	await go_to_step(2)
	await student.press(&"lab_hide_answers")
	assert_has(formula_lines(), "a = ( 7 , 1 )")
	assert_has(formula_lines(), "a · b\u0302 = ? / ? = ?")
	await drag(Vec2.new(7, 1), Vec2.new(3, 4))
	await go_to_step(3)
	assert_has(formula_lines(), "p = ? b\u0302 = ?")
	await student.press(&"lab_hide_answers")
	assert_has(formula_lines(), "p = 0 b\u0302 = (0, 0)")


func test_answers_that_come_later_are_hidden_too() -> void:
	await student.press(&"lab_hide_answers")
	await go_to_step()
	assert_eq(_opacity("%Verdict"), 0.0)
	for column: int in range(1, 4):
		var cell := (frame().lesson.services[&"readout"] as Readout).cell(1, column)
		assert_eq(cell.modulate.a, 0.0, cell.text)


func test_what_is_hidden_is_not_read_to_anybody() -> void:
	await go_to_step()
	var lesson: Array[Control] = [frame().lesson, frame().lesson.services[&"readout"]]
	assert_string_contains(PageText.of(lesson), "Scalar projection 5")
	await student.press(&"lab_hide_answers")
	assert_eq(PageText.of(lesson).find("Scalar projection"), -1)
	assert_eq(PageText.of(lesson).find("ns"), -1)


func test_neither_undo_nor_links_know_of_it() -> void:
	await student.press(&"lab_hide_answers")
	assert_true((frame().get_node("%Undo") as Button).disabled)
	assert_eq(frame().link.text(), "dot_product")


func _opacity(part: String) -> float:
	return (frame().lesson.get_node(part) as CanvasItem).modulate.a


func _places() -> Array[Rect2]:
	var places: Array[Rect2] = []
	for control: Control in Screen.controls(screen()):
		if control is not Label:
			places.append(control.get_global_rect())
	return places
