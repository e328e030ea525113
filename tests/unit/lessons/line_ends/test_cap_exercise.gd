extends LabTest
## The questions of the lesson on line ends.


func test_the_worked_example_is_answered() -> void:
	var exercise := _worked(CapExercise.Kind.FRACTION)
	assert_true(exercise.check([0.5]).is_right)
	assert_string_contains(exercise.check([-64799.2]).sentence, "squared")
	assert_string_contains(exercise.check([-0.5]).sentence, "new position")
	assert_string_contains(exercise.check([1.1]).sentence, "way out")
	assert_string_contains(exercise.check([-1.1]).sentence, "not back")


func test_the_discriminant_of_the_worked_example_is_3600() -> void:
	var exercise := _worked(CapExercise.Kind.DISCRIMINANT)
	assert_true(exercise.check([3600.0]).is_right)
	assert_string_contains(exercise.check([60.0]).sentence, "root")
	assert_string_contains(exercise.check([0.0]).sentence, "radius is missing")


func test_the_normal_of_the_worked_example_points_at_the_ball() -> void:
	var exercise := _worked(CapExercise.Kind.NORMAL)
	assert_true(exercise.check([-1.0, 0.0]).is_right)
	assert_string_contains(exercise.check([1.0, 0.0]).sentence, "other way")
	for sign_of_answer: float in [1.0, -1.0]:
		var too_long := exercise.check([3.0 * sign_of_answer, 0.0])
		assert_string_contains(too_long.sentence, "not of length 1")


func test_fresh_questions_have_short_answers_that_the_ball_confirms() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 7
	for i: int in 60:
		var exercise := _drawn(CapExercise.Kind.FRACTION, rng)
		var fraction := exercise.right_answer[0]
		var touch := exercise.difference.plus(exercise.motion.scaled(fraction))
		assert_almost_eq(touch.length(), exercise.radius, 1e-12)
		assert_true(fraction in [0.25, 0.5, 0.75], "t = %s" % fraction)


func test_no_mistake_is_named_for_the_right_answer() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 8
	for kind: CapExercise.Kind in CapExercise.Kind.values():
		for i: int in 20:
			var exercise := _drawn(kind, rng)
			assert_true(exercise.check(exercise.right_answer).is_right)


func test_on_the_board_the_ball_bounces_on_the_end_as_asked() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 9
	for i: int in 30:
		var exercise := _drawn(CapExercise.Kind.FRACTION, rng)
		var model := LineEndsModel.new()
		exercise.lay(model)
		var impact := model.impact_in(LineEndsModel.Field.ROUND_CAPS)
		assert_eq(impact.feature, Impact.Feature.START)
		assert_almost_eq(impact.fraction, exercise.right_answer[0], 1e-12)


static func _worked(kind: CapExercise.Kind) -> CapExercise:
	return CapExercise.new(kind, Vec2.new(-8, 0), Vec2.new(10, 0), 3.0)


static func _drawn(kind: CapExercise.Kind, rng: RandomNumberGenerator) -> CapExercise:
	return Exercise.drawn(CapExercise.fresh, kind, rng) as CapExercise
