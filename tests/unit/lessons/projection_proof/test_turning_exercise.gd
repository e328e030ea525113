extends LabTest
## The questions of the proof.


func test_the_x_of_the_turned_a() -> void:
	var exercise := _exercise(TurningExercise.Kind.TURNED_A)
	assert_true(exercise.check([5.0]).is_right)
	assert_string_contains(exercise.check([50.0]).sentence, "10 times too big")
	assert_string_contains(exercise.check([6.2]).sentence, "wrong way")
	assert_string_contains(exercise.check([-3.4]).sentence, "swapped")
	assert_string_contains(exercise.check([-50.0]).sentence, "not divided by |b|")


func test_cosine_and_sine_of_the_angle_of_b() -> void:
	var exercise := _exercise(TurningExercise.Kind.COSINE_AND_SINE)
	assert_true(exercise.check([0.8, -0.6]).is_right)
	assert_string_contains(exercise.check([-0.6, 0.8]).sentence, "Swapped")
	assert_string_contains(exercise.check([0.8, 0.6]).sentence, "sine has the sign")
	assert_string_contains(exercise.check([0.6, -0.8]).sentence, "Swapped")


func test_the_turned_b_lies_on_the_x_axis() -> void:
	var exercise := _exercise(TurningExercise.Kind.TURNED_B)
	assert_true(exercise.check([10.0, 0.0]).is_right)
	assert_string_contains(exercise.check([1.0, 0.0]).sentence, "unit vector")
	assert_string_contains(exercise.check([0.0, 10.0]).sentence, "y axis")
	assert_string_contains(exercise.check([0.0, -10.0]).sentence, "y axis")
	assert_string_contains(exercise.check([2.8, -9.6]).sentence, "wrong way")


func test_fresh_questions_have_short_answers() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 161
	for i: int in 60:
		var kind := (i % TurningExercise.Kind.size()) as TurningExercise.Kind
		for number: float in TurningExercise.fresh(kind, rng).right_answer:
			assert_almost_eq(number * 130.0, roundf(number * 130.0), 1e-9)


func _exercise(kind: TurningExercise.Kind) -> TurningExercise:
	return TurningExercise.new(kind, Vec2.new(7, 1), Vec2.new(8, -6))
