extends LabTest
## The questions on balls that meet.

const _QUESTIONS := 200


func test_the_numbers_of_the_course() -> void:
	assert_true(_of(BounceOfBallsExercise.Kind.HEAD_ON).check([-2.0, 4.0]).is_right)
	assert_true(_of(BounceOfBallsExercise.Kind.IMPULSE).check([8.0]).is_right)
	assert_true(_of(BounceOfBallsExercise.Kind.OBLIQUE).check([1.8, -2.4]).is_right)
	assert_true(_of(BounceOfBallsExercise.Kind.LOST).check([9.0]).is_right)


func test_a_wrong_answer_is_named() -> void:
	var head_on := _of(BounceOfBallsExercise.Kind.HEAD_ON)
	assert_string_contains(head_on.check([-6.0, 0.0]).sentence, "as off a wall")
	assert_string_contains(head_on.check([0.0, 6.0]).sentence, "exchange")
	assert_string_contains(head_on.check([2.0, 2.0]).sentence, "stick together")
	assert_string_contains(head_on.check([4.0, -2.0]).sentence, "order")
	var impulse := _of(BounceOfBallsExercise.Kind.IMPULSE)
	assert_string_contains(impulse.check([12.0]).sentence, "masses are missing")
	assert_string_contains(impulse.check([4.0]).sentence, "1 + C")
	var oblique := _of(BounceOfBallsExercise.Kind.OBLIQUE)
	assert_string_contains(oblique.check([3.2, 2.4]).sentence, "v₂′")
	assert_string_contains(oblique.check([8.2, 2.4]).sentence, "against n")
	var lost := _of(BounceOfBallsExercise.Kind.LOST)
	assert_string_contains(lost.check([6.0]).sentence, "1 − C²")
	assert_string_contains(lost.check([18.0]).sentence, "half")


func test_answers_are_right_short_and_shown_on_the_board() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 8
	for number: int in _QUESTIONS:
		var kind := number % BounceOfBallsExercise.Kind.size()
		var exercise := Exercise.drawn(BounceOfBallsExercise.fresh, kind, rng)
		assert_true(exercise.tells_mistakes_apart(), exercise.prompt)
		var model := NewtonBallsModel.new()
		assert_no_refusal(model.take(exercise.board_state()))
		var meeting := model.run().meeting
		assert_almost_eq(meeting.time, 1.0, 1e-9)
		assert_true(exercise.check(_answer(kind, meeting)).is_right, exercise.prompt)
		for answer in exercise.right_answer:
			assert_almost_eq(answer, snappedf(answer, 0.005), 1e-9, exercise.prompt)


static func _answer(kind: BounceOfBallsExercise.Kind, meeting: BallMeeting) -> PackedFloat64Array:
	var after := meeting.velocities_after()
	match kind:
		BounceOfBallsExercise.Kind.HEAD_ON:
			return [after[0].x, after[1].x]
		BounceOfBallsExercise.Kind.IMPULSE:
			return [meeting.impulse()]
		BounceOfBallsExercise.Kind.OBLIQUE:
			return [after[0].x, after[0].y]
	return [meeting.energy() - meeting.energy_of(after)]


static func _of(kind: BounceOfBallsExercise.Kind) -> BounceOfBallsExercise:
	return BounceOfBallsExercise.of_the_course(kind)
