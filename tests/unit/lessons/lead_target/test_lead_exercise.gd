extends LabTest
## The questions on leading a target.

const _QUESTIONS := 200


func test_the_numbers_of_the_table() -> void:
	assert_eq(LeadExercise.of_the_table(LeadExercise.Kind.TIME).right_answer, _pack([2.0]))
	var direction := LeadExercise.of_the_table(LeadExercise.Kind.DIRECTION)
	assert_true(direction.check([0.8, 0.6]).is_right)
	var moving := LeadExercise.of_the_table(LeadExercise.Kind.MOVING_SHOOTER)
	assert_true(moving.check([1.0, 0.0]).is_right)


func test_a_wrong_answer_is_named() -> void:
	var time := LeadExercise.of_the_table(LeadExercise.Kind.TIME)
	assert_string_contains(time.check([1.6]).sentence, "|P| / s")
	assert_string_contains(time.check([-2.0]).sentence, "below 0")
	var direction := LeadExercise.of_the_table(LeadExercise.Kind.DIRECTION)
	assert_string_contains(direction.check([1.0, 0.0]).sentence, "where the target is now")
	assert_string_contains(direction.check([240.0, 180.0]).sentence, "divide it by its length")
	assert_string_contains(direction.check([0.8, -0.6]).sentence, "the past")
	var moving := LeadExercise.of_the_table(LeadExercise.Kind.MOVING_SHOOTER)
	assert_string_contains(moving.check([0.8, 0.6]).sentence, "u is forgotten")
	assert_string_contains(moving.check([0.8, -0.6]).sentence, "twice")


func test_answers_are_right_and_short() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 5
	for number: int in _QUESTIONS:
		var kind: LeadExercise.Kind = (number % LeadExercise.Kind.size()) as LeadExercise.Kind
		var exercise := Exercise.drawn(LeadExercise.fresh, kind, rng) as LeadExercise
		assert_true(exercise.tells_mistakes_apart(), exercise.prompt)
		var model := LeadTargetModel.new()
		assert_no_refusal(model.take(exercise.board_state()))
		var aim := model.aim()
		var wanted: Array[float] = [aim.time]
		if kind != LeadExercise.Kind.TIME:
			wanted = [aim.direction.x, aim.direction.y]
		assert_true(exercise.check(_pack(wanted)).is_right, exercise.prompt)
		for answer in exercise.right_answer:
			assert_almost_eq(answer, snappedf(answer, 0.1), 1e-12, exercise.prompt)


func _pack(numbers: Array[float]) -> PackedFloat64Array:
	return PackedFloat64Array(numbers)
