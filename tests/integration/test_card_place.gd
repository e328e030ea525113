extends ScreenTest
## On a small board the cards of a lesson lie in the panel: nothing that is drawn is below them.

const _PHONE := Vector2i(390, 844)
const _WIDE := Vector2i(1280, 720)
const _CARDS: Dictionary[StringName, String] = {
	&"dot_product": "Plot",
	&"projection_proof": "Plot",
	&"reflection": "Table",
	&"more_dimensions": "Uses",
	&"error_and_time": "Legend",
	&"timed_shot": "Timeline",
}


func test_a_card_is_in_the_panel_of_a_phone_and_on_a_wide_board() -> void:
	for id: StringName in _CARDS:
		await resize(_PHONE)
		var card := await _open_card(id)
		assert_true(_is_in_panel(card), id)
		# A timeline is as high as its one row, anything else higher.
		assert_gt(card.size.y, 80.0 if id == &"timed_shot" else 100.0, id)
		await resize(_WIDE)
		assert_false(_is_in_panel(card), id)
		var place := card.get_global_rect()
		screen().free()
		card = await _open_card(id)
		assert_false(_is_in_panel(card), id)
		assert_eq(place, card.get_global_rect(), "%s: where it is without the way there" % id)
		screen().free()


func test_on_a_phone_the_picture_is_beside_the_uses_of_the_dot_product() -> void:
	await resize(_PHONE)
	await _open_card(&"more_dimensions")
	assert_true((frame().lesson.get_node("%Picture") as Control).is_visible_in_tree())
	await resize(_WIDE)
	assert_false((frame().lesson.get_node("%Picture") as Control).is_visible_in_tree())


func test_a_phone_shows_two_kinds_of_ends_at_most_and_then_the_last_one_with_its_graph() -> void:
	await resize(_PHONE)
	await open_lesson(LessonIndex.find(&"line_ends"))
	var most: Array[int] = [1, 2, 2, 2, 1, 1, 1]
	for step: int in most.size():
		await go_to_step(step)
		assert_eq(_count_fields(), most[step], "step %d" % step)
	await student.press(&"lab_panel")
	assert_eq(_count_fields(), 5, "without the panel there is room for all")


func _open_card(id: StringName) -> Control:
	await open_lesson(LessonIndex.find(id))
	await go_to_step()
	return screen().find_child(_CARDS[id], true, false) as Control


func _is_in_panel(card: Control) -> bool:
	return (frame().get_node("%Panel") as Control).is_ancestor_of(card)


func _count_fields() -> int:
	return (
		frame()
		. lesson
		. find_children("*", "LineEndsField", true, false)
		. filter(func(field: Control) -> bool: return field.is_visible_in_tree())
		. size()
	)
