extends LabTest
## The questions on friction at a bounce.

const _QUESTIONS := 200


func test_the_numbers_of_the_table() -> void:
	assert_true(_asked(GripExercise.Kind.SLIP).check([900.0]).is_right)
	assert_true(_asked(GripExercise.Kind.MARK).check([0.125]).is_right)
	assert_true(_asked(GripExercise.Kind.AFTER).check([200.0, 10.0]).is_right)
	assert_true(_asked(GripExercise.Kind.STRAIGHT_UP).check([-30.0]).is_right)
	assert_true(_asked(GripExercise.Kind.THROW).check([175.0, 100.0]).is_right)


func test_a_wrong_answer_is_named() -> void:
	_assert_named(GripExercise.Kind.SLIP, [-300.0], "sign of r ω")
	_assert_named(GripExercise.Kind.MARK, [0.375], "A third of the slip")
	_assert_named(GripExercise.Kind.MARK, [0.25], "(1 + C)")
	_assert_named(GripExercise.Kind.AFTER, [225.0, 0.0], "no brake on the speed")
	_assert_named(GripExercise.Kind.AFTER, [100.0, 0.0], "Friction turns the ball, too")
	_assert_named(GripExercise.Kind.AFTER, [100.0, 20.0], "never turns it round")
	_assert_named(GripExercise.Kind.AFTER, [0.0, 0.0], "does not stop")
	_assert_named(GripExercise.Kind.STRAIGHT_UP, [30.0], "topspin")
	_assert_named(GripExercise.Kind.THROW, [160.0, 120.0], "does not leave along n")
	_assert_named(GripExercise.Kind.THROW, [350.0, 200.0], "each ball takes half")


func test_answers_are_those_of_the_board() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 5
	for number: int in _QUESTIONS:
		var kind: GripExercise.Kind = (number % GripExercise.Kind.size()) as GripExercise.Kind
		var exercise := Exercise.drawn(GripExercise.fresh, kind, rng) as GripExercise
		assert_true(exercise.tells_mistakes_apart(), exercise.prompt)
		var model := CollisionFrictionModel.new()
		assert_no_refusal(model.take(exercise.board_state()))
		assert_true(exercise.check(_answer(kind, model)).is_right, exercise.prompt)


# By the model, and for the two that ask for a number of the state, by trying it.
func _answer(kind: GripExercise.Kind, model: CollisionFrictionModel) -> PackedFloat64Array:
	var contact := model.contact()
	match kind:
		GripExercise.Kind.SLIP:
			return [contact.slip()]
		GripExercise.Kind.MARK:
			var mark := contact.slip() / 3.0 / contact.push()
			for share: float in [0.999, 1.001]:
				assert_no_refusal(model.take({"friction": absf(mark) * share}))
				var sticks := model.contact().regime() == Friction.Regime.STICK
				assert_eq(sticks, share > 1.0)
			return [absf(mark)]
		GripExercise.Kind.AFTER:
			var leaving := contact.after()[0]
			return [leaving.velocity.x, leaving.spin]
		GripExercise.Kind.STRAIGHT_UP:
			var spin := -2.0 * model.velocity.x / model.radius
			assert_no_refusal(model.take({"spin": spin, "friction": 9.0}))
			assert_almost_eq(model.contact().after()[0].velocity.x, 0.0, 1e-10)
			return [spin]
	var thrown := contact.after()[1].velocity
	return [thrown.x, thrown.y]


func _asked(kind: GripExercise.Kind) -> GripExercise:
	return GripExercise.of_the_lecture(kind)


func _assert_named(kind: GripExercise.Kind, answer: PackedFloat64Array, words: String) -> void:
	assert_string_contains(_asked(kind).check(answer).sentence, words)
