extends LabTest
## The questions on sliding and rolling.

const _QUESTIONS := 200


func test_the_numbers_of_the_table() -> void:
	assert_true(_asked(RollExercise.Kind.MARK).check([0.25]).is_right)
	assert_true(_asked(RollExercise.Kind.ACCELERATION).check([240.0]).is_right)
	assert_true(_asked(RollExercise.Kind.TIME).check([1.0]).is_right)
	assert_true(_asked(RollExercise.Kind.LEVEL_SPEED).check([200.0]).is_right)
	assert_true(_asked(RollExercise.Kind.LEVEL_TIME).check([0.833]).is_right)


func test_a_wrong_answer_is_named() -> void:
	var wanted: Dictionary[RollExercise.Kind, Dictionary] = {
		RollExercise.Kind.MARK: {0.75: "a block begins to slide", 0.375: "a ring"},
		RollExercise.Kind.ACCELERATION:
		{360.0: "without friction", 257.14: "solid sphere", 168.0: "not µ N"},
		RollExercise.Kind.TIME: {0.8165: "without friction", 0.9661: "solid sphere"},
		RollExercise.Kind.LEVEL_SPEED: {0.0: "does not stop", 100.0: "loses"},
		RollExercise.Kind.LEVEL_TIME: {2.5: "a block would stop"},
	}
	for kind in wanted:
		for answer: float in wanted[kind]:
			var words: String = wanted[kind][answer]
			assert_string_contains(_asked(kind).check([answer]).sentence, words)


func test_answers_are_those_of_the_board() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 5
	for number: int in _QUESTIONS:
		var kind: RollExercise.Kind = (number % RollExercise.Kind.size()) as RollExercise.Kind
		var exercise := Exercise.drawn(RollExercise.fresh, kind, rng) as RollExercise
		assert_true(exercise.tells_mistakes_apart(), exercise.prompt)
		var model := SlideAndRollModel.new()
		assert_no_refusal(model.take(exercise.board_state()))
		var ball := model.ball()
		var wanted: Dictionary[RollExercise.Kind, float] = {
			RollExercise.Kind.MARK: model.mark(),
			RollExercise.Kind.ACCELERATION: model.last_acceleration(model.run_case(ball)),
			RollExercise.Kind.TIME: ball.end_time,
			RollExercise.Kind.LEVEL_SPEED: ball.end_speed,
			RollExercise.Kind.LEVEL_TIME: ball.roll_time,
		}
		assert_true(exercise.check([wanted[kind]]).is_right, exercise.prompt)


func _asked(kind: RollExercise.Kind) -> RollExercise:
	return RollExercise.of_the_lecture(kind)
