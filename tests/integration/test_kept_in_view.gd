extends LessonTest
## What a press has brought into the panel is scrolled into view, whole.


func test_a_wrong_answer_leaves_the_button_that_checks_in_view() -> void:
	await open_lesson(LessonIndex.find(&"class_or_value"))
	await go_to_step()
	var question := frame().lesson.services[&"question"] as Question
	question.expand()
	await student.settle()
	# The Vec2 of the first kind of question shares its object: its own number is a mistake.
	var own: Exercise = question.get("_exercise")
	var input := question.find_children("*", "LineEdit", true, false)[0] as LineEdit
	await student.enter(input, str(own.mistakes[0].answer[0]))
	assert_reads("A Vec2 is an object")
	_assert_is_in_view(question.get_node("%Check") as Control)


func test_a_mistake_that_is_picked_shows_all_that_is_said_of_it() -> void:
	for id: StringName in [&"reflection", &"line_ends", &"angled_lines"]:
		await open_lesson(LessonIndex.find(id))
		await go_to_step()
		var mistakes := frame().lesson.services[&"mistakes"]
		await pick_mistake((mistakes.get_node("%List") as OptionButton).get_item_text(1))
		assert_ne((mistakes.get_node("%Sentence") as Label).text, "", id)
		_assert_is_in_view(mistakes.get_node("%Sentence") as Control)
		screen().free()


func _assert_is_in_view(part: Control) -> void:
	var panel := frame().get_node("%Panel") as Control
	var is_whole := panel.get_global_rect().grow(1.0).encloses(part.get_global_rect())
	assert_true(is_whole, "%s is in view" % part.name)
