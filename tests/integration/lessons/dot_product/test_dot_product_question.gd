extends DotProductTest
## The question of the lesson on the dot product: what a student answers and is told.

const _SEED := 3

# The vectors of the question, as its prompt writes them.
var _a: Vec2
var _b: Vec2


func before_each() -> void:
	await super.before_each()
	var rng := (frame().lesson.services[&"question"] as Question).rng
	rng.seed = _SEED
	_question().folded = false
	await student.settle()


func test_the_question_is_folded_away_at_first_and_opened_by_a_click() -> void:
	_question().folded = true
	await student.settle()
	assert_null(Screen.button(screen(), "Check"))
	await student.scroll_to(_question())
	await student.click_at(_question().get_global_rect().get_center())
	assert_not_null(Screen.button(screen(), "Check"))


func test_right_answers_to_all_kinds_are_called_right() -> void:
	for kind: int in 8:
		await _new_numbers()
		var right := _right_answer()
		await _answer(right)
		assert_reads("Right: ")


func test_the_forgotten_normalization_is_named() -> void:
	# Four with the lecture's numbers come first.
	for i: int in 4:
		await _new_numbers()
	assert_reads("scalar projection of a on b?")
	await _answer([_a.x * _b.x + _a.y * _b.y])
	var length := roundi(sqrt(_b.x * _b.x + _b.y * _b.y))
	assert_reads("b was not normalized: that is |b| = %d times too big." % length)


func test_an_answer_that_stems_from_no_known_mistake_is_just_not_right() -> void:
	await _answer(_numbers(1234.5, _fields().size()))
	assert_reads("is not it yet. Go through the steps once more.")


func test_nonsense_is_refused_and_may_be_typed_over() -> void:
	await student.enter(_fields()[0], "seven")
	assert_reads("“seven” cannot be taken: type 0 or a number")
	assert_eq(_fields()[0].text, "seven")
	assert_true(Screen.button(screen(), "Show on board").disabled)


func test_nothing_typed_is_refused_too() -> void:
	await click_button("Check")
	assert_reads("“” cannot be taken")


func test_new_numbers_ask_another_question_and_clear_the_answer() -> void:
	await _answer(_numbers(1234.5, _fields().size()))
	var old := _prompt()
	await click_button("New numbers")
	assert_ne(_prompt(), old)
	assert_eq(_fields()[0].text, "")
	assert_does_not_read("is not it yet")


func test_the_numbers_of_the_question_can_be_shown_on_the_board_after_an_answer() -> void:
	await _new_numbers()
	await click_button("Show solution")
	assert_reads("p = (a · b\u0302) b\u0302 = 5 (0.8, −0.6) = (4, −3)")
	await _new_numbers()
	assert_true(Screen.button(screen(), "Show on board").disabled)
	await _answer(_numbers(1234.5, _fields().size()))
	await click_button("Show on board")
	assert_a([0, 0, _a.x, _a.y])
	assert_b([0, 0, _b.x, _b.y])


func test_an_answer_does_not_move_the_vectors_on_the_board() -> void:
	var before := frame().lesson.state()
	await _answer(_numbers(1.0, _fields().size()))
	assert_eq(frame().lesson.state(), before)


func _new_numbers() -> void:
	await click_button("New numbers")
	var numbers := RegEx.create_from_string("\\((\\S+), (\\S+)\\)").search_all(_prompt())
	if numbers.is_empty():
		return
	_a = _vector(numbers[0])
	_b = _vector(numbers[1])


func _vector(pair: RegExMatch) -> Vec2:
	var x := pair.get_string(1).replace("−", "-").to_float()
	return Vec2.new(x, pair.get_string(2).replace("−", "-").to_float())


func _right_answer() -> PackedFloat64Array:
	if _prompt().contains("angle"):
		var numbers := RegEx.create_from_string("= (\\S+?)[,°]").search_all(_prompt())
		var found: Array[float] = []
		for number in numbers:
			found.append(number.get_string(1).replace("−", "-").to_float())
		return [found[0] * cos(deg_to_rad(found[1] - found[2]))]
	var dot := _a.x * _b.x + _a.y * _b.y
	var square := _b.x * _b.x + _b.y * _b.y
	if _prompt().contains("dot product"):
		return [dot]
	if _prompt().contains("scalar projection"):
		return [dot / sqrt(square)]
	return [dot * _b.x / square, dot * _b.y / square]


func _answer(numbers: PackedFloat64Array) -> void:
	for i: int in numbers.size():
		await student.enter(_fields()[i], str(numbers[i]))
	await click_button("Check")


func _numbers(value: float, count: int) -> PackedFloat64Array:
	var numbers: PackedFloat64Array = []
	numbers.resize(count)
	numbers.fill(value)
	return numbers


func _question() -> Question:
	return frame().lesson.services[&"question"] as Question


func _fields() -> Array[LineEdit]:
	var found: Array[LineEdit] = []
	for control: Control in Screen.controls(_question()):
		if control is LineEdit:
			found.append(control as LineEdit)
	return found


func _prompt() -> String:
	return (_question().get_node("%Prompt") as Label).text
