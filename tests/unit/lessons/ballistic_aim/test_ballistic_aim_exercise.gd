extends LabTest
## The questions of the lesson on aiming under gravity.

const _SOME := 40


func test_the_flat_arc_of_the_first_board() -> void:
	var exercise := _shot(BallisticAimExercise.Kind.AIM, Vec2.new(0.8, -0.6), 1.0)
	assert_true(exercise.check([0.8, -0.6]).is_right)
	assert_string_contains(exercise.prompt, "P = (200, 0), s = 250, g = 300")
	assert_string_contains(exercise.prompt, "flat arc")
	assert_string_contains(exercise.check([0.6, -0.8]).sentence, "other arc")
	assert_string_contains(exercise.check([0.8, 0.6]).sentence, "added")
	assert_string_contains(exercise.check([1.0, 0.0]).sentence, "straight")


func test_the_high_arc_is_asked_for_by_its_name() -> void:
	var exercise := _shot(BallisticAimExercise.Kind.AIM, Vec2.new(0.6, -0.8), 4.0 / 3.0)
	assert_string_contains(exercise.prompt, "high arc")
	var arc: int = exercise.board_state()["arc"]
	assert_eq(arc, 1)


func test_the_time_of_a_level_shot() -> void:
	var exercise := _shot(BallisticAimExercise.Kind.TIME, Vec2.new(0.8, -0.6), 1.0)
	assert_true(exercise.check([1.0]).is_right)
	assert_string_contains(exercise.check([0.5]).sentence, "g t² / 2")
	assert_string_contains(exercise.check([5.0 / 3.0]).sentence, "points up")


func test_the_least_speed() -> void:
	var exercise := BallisticAimExercise.of_target(
		BallisticAimExercise.Kind.LEAST, Vec2.new(80, -60), 100.0, 250.0
	)
	assert_true(exercise.check([200.0]).is_right)
	assert_string_contains(exercise.check([40000.0]).sentence, "root")
	assert_string_contains(exercise.check([100.0]).sentence, "y points down")


func test_a_falling_target() -> void:
	var exercise := BallisticAimExercise.of_target(
		BallisticAimExercise.Kind.FALLING, Vec2.new(40, -30), 250.0, 300.0
	)
	assert_true(exercise.check([0.8, -0.6]).is_right)
	assert_string_contains(exercise.check([0.8, 0.6]).sentence, "y points down")
	var aims := BallisticAim.at_fixed(Vec2.zero(), Vec2.new(40, -30), Vec2.new(0, 300), 250.0)
	var above := aims[0].direction
	assert_string_contains(exercise.check([above.x, above.y]).sentence, "falls as the bullet")


func test_the_board_shows_each_question() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 3
	for kind: BallisticAimExercise.Kind in BallisticAimExercise.Kind.values():
		for i: int in _SOME:
			var exercise := BallisticAimExercise.fresh(kind, rng)
			var model := BallisticAimModel.new()
			assert_eq(model.take(exercise.board_state()), "")
			var asks_aim := kind != BallisticAimExercise.Kind.LEAST
			assert_true(model.has_shot() or not asks_aim, exercise.prompt)
			if kind == BallisticAimExercise.Kind.TIME:
				assert_almost_eq(model.shot().time, exercise.right_answer[0], 1e-9)
			elif asks_aim:
				var d := model.shot().direction
				assert_true(exercise.check([d.x, d.y]).is_right, exercise.prompt)


func _shot(
	kind: BallisticAimExercise.Kind, direction: Vec2, seconds: float
) -> BallisticAimExercise:
	return BallisticAimExercise.of_shot(kind, direction, 250.0, 300.0, seconds)
