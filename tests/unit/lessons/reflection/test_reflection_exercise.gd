extends LabTest
## The questions of the lesson on reflection.


func test_the_bounce_off_a_level_line() -> void:
	var exercise := _exercise(ReflectionExercise.Kind.MIRROR, 1.0)
	assert_true(exercise.check([3.0, -4.0]).is_right)
	assert_string_contains(exercise.check([3.0, 0.0]).sentence, "once only")
	assert_string_contains(exercise.check([-3.0, 4.0]).sentence, "normal of the normal")


func test_a_normal_that_was_not_brought_to_length_1_is_named() -> void:
	var exercise := ReflectionExercise.new(
		ReflectionExercise.Kind.MIRROR, Vec2.new(0, 5), Vec2.new(4, 3), 1.0
	)
	assert_true(exercise.check([4.8, -1.4]).is_right)
	assert_string_contains(exercise.check([120.0, -155.0]).sentence, "length 1")


func test_bounciness_one_half() -> void:
	var exercise := _exercise(ReflectionExercise.Kind.BOUNCE, 0.5)
	assert_true(exercise.check([3.0, -2.0]).is_right)
	assert_string_contains(exercise.check([1.5, -4.0]).sentence, "not along the line")
	assert_string_contains(exercise.check([1.5, -2.0]).sentence, "whole v")
	assert_string_contains(exercise.check([3.0, -4.0]).sentence, "C = 1")


func test_the_part_along_the_normal() -> void:
	var exercise := _exercise(ReflectionExercise.Kind.PART, 1.0)
	assert_true(exercise.check([0.0, 4.0]).is_right)
	assert_string_contains(exercise.check([3.0, 0.0]).sentence, "part along the line")
	assert_string_contains(exercise.check([0.0, 196.0]).sentence, "length 1")


func test_a_ball_that_moves_away_is_left_alone() -> void:
	var exercise := ReflectionExercise.new(
		ReflectionExercise.Kind.AWAY, Vec2.new(3, -4), Vec2.new(-7, 0), 1.0
	)
	assert_true(exercise.check([3.0, -4.0]).is_right)
	assert_string_contains(exercise.check([3.0, 4.0]).sentence, "would stick")


func test_a_ball_falls_on_a_ramp_and_loses_nothing() -> void:
	var exercise := ReflectionExercise.new(
		ReflectionExercise.Kind.RAMP, Vec2.new(0, 25), Vec2.new(-3, -4), 1.0
	)
	assert_true(exercise.check([24.0, 7.0]).is_right)
	assert_string_contains(exercise.check([0.0, -25.0]).sentence, "right angle")
	assert_string_contains(exercise.solution(), "(24, 7)")


func test_the_lecture_asks_for_its_own_velocity() -> void:
	var exercise := ReflectionExercise.of_the_lecture(ReflectionExercise.Kind.MIRROR)
	assert_true(exercise.check([3.0, -4.0]).is_right)
	assert_true(exercise.tells_mistakes_apart())
	assert_null(ReflectionExercise.of_the_lecture(ReflectionExercise.Kind.AWAY))


func test_level_and_upright_lines_are_asked_for_too() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 182
	for kind: int in ReflectionExercise.Kind.values():
		if kind == ReflectionExercise.Kind.RAMP:
			continue
		var straight := 0
		for i: int in 40:
			var exercise := (
				Exercise.drawn(ReflectionExercise.fresh, kind, rng) as ReflectionExercise
			)
			straight += int(exercise.along.x == 0.0 or exercise.along.y == 0.0)
		assert_gt(straight, 0, "kind %d" % kind)


func test_fresh_questions_have_whole_answers_and_the_right_side() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 181
	for i: int in 80:
		var kind := (i % ReflectionExercise.Kind.size()) as ReflectionExercise.Kind
		var exercise := ReflectionExercise.fresh(kind, rng)
		for number: float in exercise.right_answer:
			assert_almost_eq(number, roundf(number), 1e-12)
		var is_away := exercise.velocity.dot(exercise.along.normal()) > 0.0
		assert_eq(is_away, kind == ReflectionExercise.Kind.AWAY)


func _exercise(kind: ReflectionExercise.Kind, bounciness: float) -> ReflectionExercise:
	return ReflectionExercise.new(kind, Vec2.new(3, 4), Vec2.new(-7, 0), bounciness)
