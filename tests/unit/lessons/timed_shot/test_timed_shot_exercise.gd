extends LabTest
## The questions of the lesson on the moment to fire.

const _SOME := 40


func test_the_moment_at_a_line() -> void:
	var exercise := TimedShotExercise.on_line(1.0, 3.0, 200.0, 100.0)
	assert_true(exercise.check([2.0]).is_right)
	assert_string_contains(exercise.check([3.0]).sentence, "only starts")
	assert_string_contains(exercise.check([4.0]).sentence, "added")
	assert_string_contains(exercise.check([1.0]).sentence, "how long the bullet flies")


func test_the_moment_at_a_circle() -> void:
	var exercise := TimedShotExercise.on_circle(1.0, 180.0, 45.0)
	assert_true(exercise.check([3.0]).is_right)
	assert_string_contains(exercise.check([4.0]).sentence, "only starts")
	assert_eq(exercise.board_state(), {})


func test_the_window() -> void:
	var exercise := TimedShotExercise.of_window(200.0, 150.0, 12.0)
	assert_true(exercise.check([0.1]).is_right)
	assert_string_contains(exercise.check([0.08]).sentence, "the bullet moves, too")
	assert_string_contains(exercise.check([0.2]).sentence, "whole window")


func test_the_board_shows_each_question() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 3
	for kind: TimedShotExercise.Kind in TimedShotExercise.Kind.values():
		for i: int in _SOME:
			var exercise := TimedShotExercise.fresh(kind, rng)
			var model := TimedShotModel.new()
			assert_eq(model.take(exercise.board_state()), "")
			if kind == TimedShotExercise.Kind.LINE:
				assert_almost_eq(model.shot().fire, exercise.right_answer[0], 1e-9)
			elif kind == TimedShotExercise.Kind.WINDOW:
				assert_almost_eq(model.half_window(), exercise.right_answer[0], 1e-9)
