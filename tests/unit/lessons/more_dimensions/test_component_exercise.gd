extends LabTest
## The questions of the lesson on more dimensions.


func test_a_dot_product_is_checked_and_mistakes_are_named() -> void:
	var exercise := ComponentExercise.new(
		ComponentExercise.Kind.DOT, [4.0, -3.0, 2.0], [2.0, -4.0, -1.0]
	)
	assert_true(exercise.check([18.0]).is_right)
	assert_string_contains(exercise.check([20.0]).sentence, "last component")
	assert_string_contains(exercise.check([-18.0]).sentence, "sign is wrong")
	assert_string_contains(exercise.check([22.0]).sentence, "signs are missing")
	assert_string_contains(exercise.check([-9.0]).sentence, "Multiply first")
	assert_string_contains(exercise.check([0.0]).sentence, "not added")


func test_the_missing_component_makes_a_right_angle() -> void:
	var exercise := ComponentExercise.new(
		ComponentExercise.Kind.MISSING, [4.0, -3.0, -1.0], [2.0, -4.0, 5.0]
	)
	assert_true(exercise.check([20.0]).is_right)
	assert_string_contains(exercise.check([-20.0]).sentence, "add up to 0")
	assert_string_contains(exercise.prompt, "(2, −4, ?)")


func test_fresh_questions_have_whole_answers() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 11
	for kind: ComponentExercise.Kind in ComponentExercise.Kind.values():
		for i: int in 40:
			var exercise := ComponentExercise.fresh(kind, rng)
			var answer := exercise.right_answer[0]
			assert_eq(answer, roundf(answer))
			assert_true(exercise.check([answer]).is_right)


func test_on_the_board_a_missing_component_makes_the_dot_product_0() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 12
	for i: int in 20:
		var model := MoreDimensionsModel.new()
		var exercise := ComponentExercise.fresh(ComponentExercise.Kind.MISSING, rng)
		assert_eq(model.take(exercise.board_state()), "")
		assert_eq(model.dot(), 0.0)


func test_the_solution_has_the_numbers_put_in() -> void:
	var exercise := ComponentExercise.new(
		ComponentExercise.Kind.DOT, [4.0, -3.0, 2.0], [2.0, -4.0, -1.0]
	)
	assert_eq(exercise.solution(), "a · b = 4·2 + (−3)·(−4) + 2·(−1) = 18")
	exercise = ComponentExercise.new(
		ComponentExercise.Kind.MISSING, [4.0, -3.0, -1.0], [2.0, -4.0, 5.0]
	)
	assert_string_contains(exercise.solution(), "add up to 20")
	assert_string_contains(exercise.solution(), "−(20) / (−1) = 20")
