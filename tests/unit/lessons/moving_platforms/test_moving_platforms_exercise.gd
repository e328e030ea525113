extends LabTest
## The questions of the lesson on surfaces that move.

const _SOME := 40


func test_the_numbers_of_the_table() -> void:
	var wanted: Dictionary[MovingPlatformsExercise.Kind, float] = {
		MovingPlatformsExercise.Kind.WALL: 400.0,
		MovingPlatformsExercise.Kind.SOFT: 250.0,
		MovingPlatformsExercise.Kind.BELT: 30.0,
		MovingPlatformsExercise.Kind.PADDLE: 600.0,
		MovingPlatformsExercise.Kind.PRESS: 900.0,
		MovingPlatformsExercise.Kind.WAY: 50.0,
		MovingPlatformsExercise.Kind.CRUSHED: 2.0,
	}
	for kind in wanted:
		assert_true(_asked(kind).check([wanted[kind]]).is_right, str(kind))


func test_a_wrong_answer_is_named() -> void:
	var wanted: Dictionary[MovingPlatformsExercise.Kind, Dictionary] = {
		MovingPlatformsExercise.Kind.WALL: {200.0: "ignored", 300.0: "never subtracted"},
		MovingPlatformsExercise.Kind.SOFT:
		{100.0: "ignored", 200.0: "never subtracted", 300.0: "for C = 1", 150.0: "That is U′"},
		MovingPlatformsExercise.Kind.BELT: {90.0: "the belt's speed", 60.0: "Two thirds"},
		MovingPlatformsExercise.Kind.PADDLE: {200.0: "taken to rest", 800.0: "speed of the tip"},
		MovingPlatformsExercise.Kind.PRESS: {600.0: "V before, V after", 500.0: "one bounce"},
		MovingPlatformsExercise.Kind.WAY: {66.67: "Not h u"},
		MovingPlatformsExercise.Kind.CRUSHED: {0.5: "V alone", 0.667: "at the other wall"},
	}
	for kind in wanted:
		for answer: float in wanted[kind]:
			var words: String = wanted[kind][answer]
			assert_string_contains(_asked(kind).check([answer]).sentence, words)


func test_answers_are_those_of_the_board() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 21
	for kind: MovingPlatformsExercise.Kind in MovingPlatformsExercise.Kind.values():
		for number: int in _SOME:
			var exercise := Exercise.drawn(MovingPlatformsExercise.fresh, kind, rng)
			assert_true(exercise.tells_mistakes_apart(), exercise.prompt)
			var model := MovingPlatformsModel.new()
			assert_no_refusal(model.take(exercise.board_state()))
			var answer := exercise.right_answer[0]
			match model.kind:
				MovingSurface.Kind.BELT:
					assert_almost_eq(model.rolling_speed(), answer, 1e-9)
				MovingSurface.Kind.PRESS:
					_assert_press(model, kind, answer)
				_:
					assert_almost_eq(model.impact().leaving.x, answer, 1e-9, exercise.prompt)


func _assert_press(
	model: MovingPlatformsModel, kind: MovingPlatformsExercise.Kind, answer: float
) -> void:
	if kind == MovingPlatformsExercise.Kind.CRUSHED:
		assert_almost_eq(model.crush_time(), answer, 1e-12)
		return
	# After so many bounces the ball has this speed, and at one of them so much way.
	var found := false
	for bounce: int in range(2, 6):
		var left := model.way - model.surface_speed * model.press_time(bounce)
		var just_after := model.press_time(bounce) + 1e-9
		var speed := Press.at(just_after, model.way, model.speed, model.surface_speed).speed
		var number := left if kind == MovingPlatformsExercise.Kind.WAY else speed
		found = found or absf(number - answer) < 1e-9 * (1.0 + answer)
	assert_true(found, "%s in %s" % [answer, model.to_dictionary()])


static func _asked(kind: MovingPlatformsExercise.Kind) -> MovingPlatformsExercise:
	return MovingPlatformsExercise.of_the_lecture(kind)
