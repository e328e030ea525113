extends LabTest
## The questions of the lesson on normals.

const _FRESH := 400


func test_a_normal_is_minus_y_and_x() -> void:
	var exercise := NormalExercise.new(NormalExercise.Kind.NORMAL, Vec2.new(3.0, 1.0))
	assert_true(exercise.check([-1.0, 3.0]).is_right)
	assert_string_contains(exercise.check([1.0, -3.0]).sentence, "opposite normal")
	assert_string_contains(exercise.check([1.0, 3.0]).sentence, "no right angle")
	assert_string_contains(exercise.check([-3.0, -1.0]).sentence, "180°")
	assert_string_contains(exercise.check([3.0, 1.0]).sentence, "along v")


func test_the_opposite_normal_is_y_and_minus_x() -> void:
	var exercise := NormalExercise.new(NormalExercise.Kind.OPPOSITE, Vec2.new(3.0, -2.0))
	assert_true(exercise.check([-2.0, -3.0]).is_right)
	assert_string_contains(exercise.check([2.0, 3.0]).sentence, "That is n, +90° from v")
	assert_string_contains(exercise.check([-2.0, 3.0]).sentence, "no right angle")


func test_the_lecture_asks_with_its_own_vectors_and_solves_them() -> void:
	var solutions: Dictionary[NormalExercise.Kind, String] = {
		NormalExercise.Kind.NORMAL: "n = (−y, x) = (−1, 3)",
		NormalExercise.Kind.OPPOSITE: "−n = (y, −x) = (−2, −3)",
		NormalExercise.Kind.UNIT: "n̂ = n / |n| = (4, 3) / 5 = (0.8, 0.6)",
	}
	for kind in solutions:
		assert_eq(NormalExercise.of_the_lecture(kind).solution(), solutions[kind])
	assert_null(NormalExercise.of_the_lecture(NormalExercise.Kind.SCALED))


func test_a_unit_normal_that_was_not_divided_is_named_with_its_length() -> void:
	var exercise := NormalExercise.new(NormalExercise.Kind.UNIT, Vec2.new(3.0, -4.0))
	assert_true(exercise.check([0.8, 0.6]).is_right)
	assert_string_contains(exercise.check([4.0, 3.0]).sentence, "5 times too long")
	assert_string_contains(exercise.check([-4.0, -3.0]).sentence, "5 times too long")
	assert_string_contains(exercise.check([0.6, -0.8]).sentence, "v with length 1")
	assert_string_contains(exercise.check([-0.8, -0.6]).sentence, "opposite normal")


func test_a_scaled_normal_is_first_divided_then_scaled() -> void:
	var exercise := NormalExercise.new(NormalExercise.Kind.SCALED, Vec2.new(3.0, -4.0), 50.0)
	assert_true(exercise.check([40.0, 30.0]).is_right)
	assert_string_contains(exercise.check([200.0, 150.0]).sentence, "5 times too long")
	assert_string_contains(exercise.check([0.8, 0.6]).sentence, "still has to be scaled")
	assert_string_contains(exercise.check([4.0, 3.0]).sentence, "first divide")
	assert_string_contains(exercise.check([-0.8, -0.6]).sentence, "still has to be scaled")
	assert_string_contains(exercise.check([30.0, -40.0]).sentence, "along v")


func test_fresh_answers_are_perpendicular_and_of_the_wanted_length() -> void:
	for kind: NormalExercise.Kind in NormalExercise.Kind.values():
		for exercise in _fresh(kind):
			var x := exercise.right_answer[0]
			var y := exercise.right_answer[1]
			var size := sqrt(exercise.v.x ** 2.0 + exercise.v.y ** 2.0)
			var lengths: Array[float] = [size, size, 1.0, exercise.wanted_length]
			var side := -1.0 if kind == NormalExercise.Kind.OPPOSITE else 1.0
			assert_almost_eq(x * exercise.v.x + y * exercise.v.y, 0.0, 1e-9)
			assert_almost_eq(sqrt(x * x + y * y), lengths[kind], 1e-9)
			var cross := exercise.v.x * y - exercise.v.y * x
			assert_gt(side * cross, 0.0, "+90 degrees, or −90 for the opposite one")


func test_fresh_answers_are_short_decimals() -> void:
	for kind: NormalExercise.Kind in NormalExercise.Kind.values():
		for exercise in _fresh(kind):
			for number: float in exercise.right_answer:
				assert_almost_eq(number * 100.0, roundf(number * 100.0), 1e-9)


func test_no_fresh_question_has_a_mistake_that_is_right_or_named_as_another() -> void:
	for kind: NormalExercise.Kind in NormalExercise.Kind.values():
		for exercise in _fresh(kind):
			for mistake in exercise.mistakes:
				assert_false(exercise.check(mistake.answer).is_right, exercise.prompt)
				assert_eq(
					exercise.check(mistake.answer).sentence, mistake.sentence, exercise.prompt
				)


func _fresh(kind: NormalExercise.Kind) -> Array[NormalExercise]:
	var rng := RandomNumberGenerator.new()
	rng.seed = 21
	var exercises: Array[NormalExercise] = []
	for i: int in _FRESH:
		exercises.append(Exercise.drawn(NormalExercise.fresh, kind, rng) as NormalExercise)
	return exercises
