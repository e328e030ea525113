extends LabTest
## The questions of the lesson on the easy bounce.

const _FRESH := 400


func test_the_right_answers_are_right_and_others_name_the_mistake() -> void:
	var flip := _exercise(BounceExercise.Kind.FLIP)
	assert_true(flip.check([3.0, -4.0]).is_right)
	assert_string_contains(flip.check([-3.0, 4.0]).sentence, "a floor flips y")
	assert_string_contains(flip.check([-3.0, -4.0]).sentence, "Both are flipped")
	assert_string_contains(flip.check([3.0, 4.0]).sentence, "goes on into the floor")


func test_put_back_takes_the_radius_off_the_floor() -> void:
	var back := _exercise(BounceExercise.Kind.PUT_BACK)
	assert_true(back.check([80.0]).is_right)
	assert_string_contains(back.check([100.0]).sentence, "take the radius off")
	assert_string_contains(back.check([120.0]).sentence, "y points down")


func test_the_shortest_distance_is_the_straight_one_times_the_cosine() -> void:
	# The line runs along (4, 3): straight down 10, so 10 · 4 / 5.
	var shortest := _exercise(BounceExercise.Kind.SHORTEST)
	assert_true(shortest.check([8.0]).is_right)
	assert_string_contains(shortest.check([10.0]).sentence, "straight down")
	assert_string_contains(shortest.check([6.0]).sentence, "along the line")
	assert_string_contains(shortest.check([12.5]).sentence, "not divided")


func test_no_fresh_question_has_a_mistake_that_is_right() -> void:
	for kind: BounceExercise.Kind in BounceExercise.Kind.values():
		for exercise in _fresh(kind):
			for mistake in exercise.mistakes:
				assert_false(exercise.check(mistake.answer).is_right, exercise.prompt)


func test_no_two_mistakes_lead_to_the_same_answer() -> void:
	for kind: BounceExercise.Kind in BounceExercise.Kind.values():
		for exercise in _fresh(kind):
			for mistake in exercise.mistakes:
				assert_eq(
					exercise.check(mistake.answer).sentence, mistake.sentence, exercise.prompt
				)


func test_answers_are_whole_numbers() -> void:
	for kind: BounceExercise.Kind in BounceExercise.Kind.values():
		for exercise in _fresh(kind):
			for number: float in exercise.right_answer:
				assert_almost_eq(number, roundf(number), 1e-9, exercise.prompt)


func test_shown_on_the_board_the_question_is_answered_by_the_model() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 8
	for i: int in 50:
		var model := EasyBounceModel.new()
		model.swap_axes()
		var exercise := BounceExercise.fresh(BounceExercise.Kind.SHORTEST, rng)
		exercise.set_up(model)
		var distance := model.shortest_distance(model.ball.position)
		assert_true(exercise.check([distance]).is_right, exercise.prompt)
		assert_false(model.is_wall)


func test_shown_on_the_board_the_ball_is_put_back_to_the_answer() -> void:
	var model := EasyBounceModel.new()
	var exercise := _exercise(BounceExercise.Kind.PUT_BACK)
	exercise.set_up(model)
	assert_true(exercise.check([model.easy_result(model.ball).position.y]).is_right)


func test_shown_on_the_board_the_ball_bounces_as_answered() -> void:
	var model := EasyBounceModel.new()
	model.ball.position = Vec2.new(500.0, -500.0)
	var exercise := _exercise(BounceExercise.Kind.FLIP)
	exercise.set_up(model)
	var after := model.easy_result(model.ball).velocity.scaled(0.25)
	assert_true(exercise.check([after.x, after.y]).is_right)


func _exercise(kind: BounceExercise.Kind) -> BounceExercise:
	return BounceExercise.new(kind, 100.0, 20.0, Vec2.new(3.0, 4.0), Vector3i(4, 3, 5))


func _fresh(kind: BounceExercise.Kind) -> Array[BounceExercise]:
	var rng := RandomNumberGenerator.new()
	rng.seed = 20
	var exercises: Array[BounceExercise] = []
	for i: int in _FRESH:
		exercises.append(BounceExercise.fresh(kind, rng))
	return exercises
