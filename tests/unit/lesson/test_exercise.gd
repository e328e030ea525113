extends LabTest
## What an exercise says of an answer.


func test_the_right_answer_is_right_and_repeated() -> void:
	var verdict := _exercise().check([5.0])
	assert_true(verdict.is_right)
	assert_eq(verdict.sentence, "Right: 5.")


func test_a_known_mistake_is_named() -> void:
	var verdict := _exercise().check([50.0])
	assert_false(verdict.is_right)
	assert_eq(verdict.sentence, "Ten times too big.")


func test_a_mistake_of_either_sign_is_named_with_both() -> void:
	var exercise := Exercise.new()
	exercise.right_answer = [5.0, 1.0]
	exercise.add_mistake_of_either_sign([3.0, -4.0], "Turned.")
	for answer: PackedFloat64Array in [[3.0, -4.0], [-3.0, 4.0]] as Array[PackedFloat64Array]:
		assert_eq(exercise.check(answer).sentence, "Turned.")
	assert_ne(exercise.check([3.0, 4.0]).sentence, "Turned.", "one sign alone is another mistake")


func test_an_answer_that_nobody_foresaw_is_just_not_right() -> void:
	var verdict := _exercise().check([-7.5])
	assert_false(verdict.is_right)
	assert_eq(verdict.sentence, "−7.5 is not it yet. Go through the steps once more.")


func test_a_mistake_that_leads_to_the_right_answer_by_accident_is_not_named() -> void:
	var verdict := _exercise().check([5.0])
	assert_eq(verdict.sentence.find("By accident"), -1)


func test_the_first_of_two_mistakes_with_the_same_answer_is_named() -> void:
	var exercise := _exercise()
	exercise.add_mistake([50.0], "Another.")
	assert_eq(exercise.check([50.0]).sentence, "Ten times too big.")


func test_answers_are_compared_to_two_decimals() -> void:
	assert_true(_exercise().check([5.004]).is_right)
	assert_false(_exercise().check([5.006]).is_right)
	assert_false(_exercise().check([4.994]).is_right)


func test_nan_is_never_right() -> void:
	assert_false(_exercise().check([NAN]).is_right)


func test_both_numbers_of_a_pair_have_to_be_right() -> void:
	var exercise := Exercise.new()
	exercise.right_answer = [4.0, -3.0]
	assert_true(exercise.check([4.0, -3.0]).is_right)
	assert_eq(exercise.check([4.0, -3.0]).sentence, "Right: (4, −3).")
	assert_false(exercise.check([4.0, 3.0]).is_right)
	assert_false(exercise.check([-4.0, -3.0]).is_right)


func test_the_solution_names_each_number_with_its_title() -> void:
	var exercise := Exercise.new()
	exercise.answer_titles = ["n̂x =", "n̂y ="]
	exercise.right_answer = [-sqrt(0.1), 3.0 * sqrt(0.1)]
	assert_eq(exercise.solution(), "n̂x = −0.3162, n̂y = 0.9487")


func test_mistakes_are_told_apart_unless_two_answers_are_the_same() -> void:
	var exercise := Exercise.new()
	exercise.right_answer = [5.0]
	exercise.add_mistake([50.0], "One.")
	exercise.add_mistake([0.5], "Another.")
	assert_true(exercise.tells_mistakes_apart())
	exercise.add_mistake([50.001], "As the first.")
	assert_false(exercise.tells_mistakes_apart())


func test_a_mistake_with_the_right_answer_is_not_told_apart() -> void:
	assert_false(_exercise().tells_mistakes_apart())


func test_a_mistake_may_lead_to_the_same_answer_in_two_ways() -> void:
	var exercise := Exercise.new()
	exercise.right_answer = [5.0]
	exercise.add_mistake([50.0], "One.")
	exercise.add_mistake([50.0], "One.")
	assert_true(exercise.tells_mistakes_apart())


func test_a_question_is_drawn_until_its_mistakes_can_be_told_apart() -> void:
	var numbers: Array[float] = [5.0, 5.001, 7.0, 8.0]
	var drawn := Exercise.drawn(_fresh.bind(numbers), 3, RandomNumberGenerator.new())
	assert_eq(drawn.mistakes[0].answer, PackedFloat64Array([7.0]))
	assert_eq(drawn.prompt, "3")
	assert_eq(numbers, [8.0])


func test_a_question_whose_mistakes_are_always_the_same_is_drawn_only_so_often() -> void:
	var numbers: Array[float] = []
	numbers.resize(Exercise.MOST_DRAWS + 1)
	numbers.fill(5.0)
	Exercise.drawn(_fresh.bind(numbers), 0, RandomNumberGenerator.new())
	assert_eq(numbers.size(), 1)


# The right answer is 5, and the next of the numbers a mistake.
func _fresh(kind: int, _rng: RandomNumberGenerator, numbers: Array[float]) -> Exercise:
	var exercise := Exercise.new()
	exercise.prompt = str(kind)
	exercise.right_answer = [5.0]
	exercise.add_mistake([numbers.pop_front()], "One.")
	return exercise


func _exercise() -> Exercise:
	var exercise := Exercise.new()
	exercise.right_answer = [5.0]
	exercise.add_mistake([5.0], "By accident.")
	exercise.add_mistake([50.0], "Ten times too big.")
	return exercise
