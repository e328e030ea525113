extends LabTest
## The questions on aiming at a target.

const _QUESTIONS := 200


func test_the_numbers_of_the_table() -> void:
	var own := AimExercise.of_the_table(AimExercise.Kind.OWN_ANGLE)
	assert_true(own.check([60.0]).is_right)
	assert_string_contains(own.check([90.0]).sentence, "That is θ")
	assert_string_contains(own.check([120.0]).sentence, "taken off, not added")
	assert_string_contains(own.check([-60.0]).sentence, "θ − α, not α − θ")
	var short := AimExercise.of_the_table(AimExercise.Kind.SHORT_WAY)
	assert_true(short.check([90.0]).is_right)
	assert_string_contains(short.check([-270.0]).sentence, "the long way round: add")
	assert_string_contains(short.check([-90.0]).sentence, "turns the other way")
	assert_null(AimExercise.of_the_table(AimExercise.Kind.NOZZLE))


func test_a_wrong_nozzle_is_named() -> void:
	# P (-40, -30), T (160, 120), L 50.
	var nozzle := AimExercise.new(AimExercise.Kind.NOZZLE, 0, 50, 50)
	assert_true(nozzle.check([0.0, 0.0]).is_right)
	assert_string_contains(nozzle.check([40.0, 30.0]).sentence, "L d alone")
	assert_string_contains(nozzle.check([-80.0, -60.0]).sentence, "the other end")
	assert_string_contains(nozzle.check([9960.0, 7470.0]).sentence, "divide by its length")


func test_answers_are_those_of_the_core() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 5
	for number: int in _QUESTIONS:
		var kind: AimExercise.Kind = (number % AimExercise.Kind.size()) as AimExercise.Kind
		var exercise := Exercise.drawn(AimExercise.fresh, kind, rng) as AimExercise
		assert_true(exercise.tells_mistakes_apart(), exercise.prompt)
		for answer in exercise.right_answer:
			assert_almost_eq(answer, snappedf(answer, 1.0), 1e-9, exercise.prompt)
		if kind != AimExercise.Kind.NOZZLE:
			assert_between(exercise.right_answer[0], -180.0, 180.0)
