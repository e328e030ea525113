extends LabTest
## The questions of the lesson on bank shots.

const _SEED := 3


func test_the_right_answer_of_each_kind_hits_on_its_board() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = _SEED
	for number: int in 20:
		for kind: BankShotExercise.Kind in [
			BankShotExercise.Kind.IMAGE, BankShotExercise.Kind.BOUNCE, BankShotExercise.Kind.LOSS
		]:
			var exercise := BankShotExercise.fresh(kind, rng)
			var model := BankShotModel.new()
			model.board.walls.append(LineSegment.new(Vec2.zero(), Vec2.new(1, 0)))
			assert_no_refusal(model.take(exercise.board_state()))
			var way := model.answer().way
			assert_true(way.hit, exercise.prompt)
			var wanted := [way.images[0].x, way.images[0].y]
			if kind == BankShotExercise.Kind.BOUNCE:
				wanted = [way.bounces[0].x]
			assert_true(exercise.check(PackedFloat64Array(wanted)).is_right, exercise.prompt)


func test_mistakes_are_named() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = _SEED
	for kind: BankShotExercise.Kind in BankShotExercise.Kind.values():
		var exercise := Exercise.drawn(BankShotExercise.fresh, kind, rng)
		assert_true(exercise.tells_mistakes_apart())
		for mistake in exercise.mistakes:
			assert_eq(exercise.check(mistake.answer).sentence, mistake.sentence)


func test_two_mirrors_in_the_other_order_are_named() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = _SEED
	var exercise := BankShotExercise.fresh(BankShotExercise.Kind.ORDER, rng)
	var target := exercise.target
	assert_true(exercise.check([target.y, 2.0 * exercise.floor_y - target.x]).is_right)
	var wrong := exercise.check([2.0 * exercise.floor_y - target.y, target.x])
	assert_string_contains(wrong.sentence, "begin with the last one")
	assert_eq(exercise.board_state(), {})
