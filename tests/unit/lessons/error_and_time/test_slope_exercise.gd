extends LabTest
## Tests of the questions on error and run time: the right answer by other means, and that wrong
## ones are told apart.


func test_the_order_asked_for_is_that_of_both_points() -> void:
	for exercise in _exercises(SlopeExercise.Kind.ORDER):
		var p := exercise.points
		var order := (log(p[1]) - log(p[3])) / (log(p[2]) - log(p[0]))
		assert_almost_eq(exercise.right_answer[0], order, 1e-9, exercise.prompt)


func test_the_time_asked_for_lies_on_a_line_of_that_order() -> void:
	for exercise in _exercises(SlopeExercise.Kind.COST):
		var p := exercise.points
		var order := roundi(log(p[1] / p[3]) / log(p[2] / p[0]))
		assert_string_contains(exercise.prompt, "order %d " % order)
		assert_almost_eq(p[1] / p[3], (p[2] / p[0]) ** order, 1e-9)


func test_as_many_are_on_the_frontier_as_the_report_would_find() -> void:
	for exercise in _exercises(SlopeExercise.Kind.FRONTIER):
		var all: Array[Measurement] = []
		for i: int in 4:
			var measurement := Measurement.new()
			measurement.run_time_us = exercise.points[2 * i]
			measurement.error = exercise.points[2 * i + 1]
			all.append(measurement)
		assert_eq(exercise.right_answer[0], 1.0 * Frontier.of(all).size(), exercise.prompt)


func test_wrong_answers_tell_which_mistake_led_to_them() -> void:
	for kind: int in SlopeExercise.Kind.size():
		for exercise in _exercises(kind as SlopeExercise.Kind):
			assert_true(exercise.tells_mistakes_apart(), exercise.prompt)
			for mistake in exercise.mistakes:
				assert_eq(exercise.check(mistake.answer).sentence, mistake.sentence)


func test_prompts_have_their_numbers_and_both_kinds_of_frontier_come() -> void:
	var answers: Array[float] = []
	for exercise in _exercises(SlopeExercise.Kind.FRONTIER):
		answers.append(exercise.right_answer[0])
		assert_false(exercise.prompt.contains("%s"))
	assert_has(answers, 2.0)
	assert_has(answers, 3.0)


func _exercises(kind: SlopeExercise.Kind) -> Array[SlopeExercise]:
	var rng := RandomNumberGenerator.new()
	rng.seed = 5
	var found: Array[SlopeExercise] = []
	for i: int in 30:
		found.append(SlopeExercise.fresh(kind, rng))
	return found
