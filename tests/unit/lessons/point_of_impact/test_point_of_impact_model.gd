extends LabTest
## The model of the lesson on the point of impact, its mistakes and its question.

var model: PointOfImpactModel


func before_each() -> void:
	model = PointOfImpactModel.new()


func test_it_starts_with_the_numbers_of_the_course() -> void:
	assert_almost_eq(model.old_distance(), 50.0, 1e-13)
	assert_almost_eq(model.new_distance(), -30.0, 1e-13)
	assert_almost_eq(model.way_to_contact(), 40.0, 1e-13)
	assert_almost_eq(model.way_of_frame(), 80.0, 1e-13)
	assert_almost_eq(model.fraction(), 0.5, 1e-15)


func test_impact_is_on_the_path_and_reset_is_beside_it() -> void:
	assert_vec2(model.impact().position, Vec2.new(6, -8), 1e-13)
	assert_vec2(model.reset_position(), Vec2.new(30, 10), 1e-13)
	assert_almost_eq(model.error_of(model.impact().position), 0.0, 1e-13)
	assert_almost_eq(model.error_of(model.reset_position()), 30.0, 1e-13)


func test_the_error_of_the_reset_grows_with_the_speed_and_that_of_the_impact_does_not() -> void:
	for speed: float in [10.0, 38.0, 72.0, 500.0]:
		model.old_position = Vec2.new(6, -8 - speed / 2.0)
		model.new_position = Vec2.new(6, -8 + speed / 2.0)
		assert_almost_eq(model.error_of(model.reset_position()), 0.3 * speed, 1e-12)
		assert_almost_eq(model.error_of(model.impact().position), 0.0, 1e-12)


func test_the_error_of_the_reset_is_what_is_left_of_the_sideways_motion() -> void:
	var along := model.line.along().normalized()
	for place: Vec2 in random_vectors(101, 50, 200.0):
		model.new_position = place
		if model.frame_case() == PointOfImpactModel.Case.IN_FRAME:
			var sideways := absf(model.motion().dot(along))
			var want := (1.0 - model.fraction()) * sideways
			assert_almost_eq(model.error_of(model.reset_position()), want, 1e-10)


func test_each_mistake_gives_its_wrong_share_for_the_numbers_of_the_course() -> void:
	var wrong: Dictionary[int, float] = {
		PointOfImpactMistakes.OVER_NEW: -4.0 / 3.0,
		PointOfImpactMistakes.UNSIGNED: 2.0,
		PointOfImpactMistakes.NOT_LIMITED: 0.5,
		PointOfImpactMistakes.FROM_NEW: -0.5,
	}
	for number in wrong:
		model.mistake = number
		assert_almost_eq(model.fraction_with_mistake(), wrong[number], 1e-13, str(number))
		assert_almost_eq(model.fraction(), 0.5, 1e-15)


func test_the_gap_of_the_course_read_from_the_new_position_gives_minus_one_half() -> void:
	assert_eq(PointOfImpactMistakes.fraction(0, 8, -2, 3), 0.5)
	assert_eq(PointOfImpactMistakes.fraction(PointOfImpactMistakes.FROM_NEW, 8, -2, 3), -0.5)


func test_a_share_without_limits_loses_a_ball_that_moves_along_the_line() -> void:
	_move(Vec2.new(-34, -88), Vec2.new(46, -28))
	model.mistake = PointOfImpactMistakes.NOT_LIMITED
	assert_false(model.position_with_mistake().is_finite())


func test_every_mistake_of_the_gallery_names_a_test_that_exists() -> void:
	var script: GDScript = load("res://tests/unit/collision/test_point_of_impact.gd")
	var names := script.get_script_method_list().map(
		func(method: Dictionary) -> String: return method["name"]
	)
	for info in PointOfImpactMistakes.infos():
		assert_eq(info.test.get_slice(".", 0), "test_point_of_impact")
		assert_has(names, info.test.get_slice(".", 1))


func test_a_line_that_is_not_reached_has_a_share_above_1() -> void:
	_move(Vec2.new(6, -58), Vec2.new(6, -20.5))
	assert_eq(model.frame_case(), PointOfImpactModel.Case.TOO_FAR)
	assert_gt(model.fraction(), 1.0)
	assert_false(model.is_reset())


func test_a_ball_that_overlaps_from_the_start_touches_at_once() -> void:
	_move(Vec2.new(3, -4), Vec2.new(3, 21))
	assert_eq(model.frame_case(), PointOfImpactModel.Case.OVERLAPS_FROM_START)
	assert_almost_eq(model.fraction(), -0.25, 1e-15)
	assert_vec2(model.impact().position, Vec2.new(3, -4), 0.0)


func test_a_ball_that_moves_away_has_a_negative_b() -> void:
	_move(Vec2.new(12, -16), Vec2.new(12, -66))
	assert_eq(model.frame_case(), PointOfImpactModel.Case.MOVING_AWAY)
	assert_almost_eq(model.fraction(), -0.25, 1e-15)


func test_a_ball_on_its_way_out_has_a_share_within_0_and_1_and_still_no_impact() -> void:
	_move(Vec2.new(3, -4), Vec2.new(3, -29))
	assert_eq(model.frame_case(), PointOfImpactModel.Case.LEAVING)
	assert_almost_eq(model.fraction(), 0.25, 1e-15)
	assert_false(model.impact().hit)


func test_a_ball_that_moves_along_the_line_divides_by_0() -> void:
	_move(Vec2.new(-34, -88), Vec2.new(46, -28))
	assert_eq(model.frame_case(), PointOfImpactModel.Case.PARALLEL)
	assert_almost_eq(model.way_of_frame(), 0.0, 1e-13)


func test_each_case_is_explained_in_other_words() -> void:
	var seen: Array[String] = []
	for places: Array[Vec2] in (
		[
			[Vec2.new(6, -58), Vec2.new(6, 42)],
			[Vec2.new(6, -58), Vec2.new(6, -20.5)],
			[Vec2.new(3, -4), Vec2.new(3, 21)],
			[Vec2.new(12, -16), Vec2.new(12, -66)],
			[Vec2.new(3, -4), Vec2.new(3, -29)],
			[Vec2.new(-34, -88), Vec2.new(46, -28)],
		]
		as Array[Array]
	):
		_move(places[0], places[1])
		var words := PointOfImpactTexts.verdict(model)[1]
		assert_does_not_have(seen, words)
		seen.append(words)


func test_a_new_speed_keeps_old_position_and_direction() -> void:
	model.new_position = Vec2.new(6 + 30, -58 + 40)
	assert_eq(model.set_speed(500.0), "")
	assert_vec2(model.motion(), Vec2.new(300, 400), 1e-12)
	assert_vec2(model.old_position, Vec2.new(6, -58), 0.0)


func test_a_speed_that_is_not_positive_is_refused_and_the_motion_stays() -> void:
	for speed: float in [0.0, -5.0, INF, NAN]:
		assert_string_contains(model.set_speed(speed), "speed must be above 0")
		assert_vec2(model.motion(), Vec2.new(0, 100), 0.0)


func test_a_ball_at_rest_takes_no_speed() -> void:
	model.new_position = model.old_position.copy()
	assert_string_contains(model.set_speed(10.0), "no direction")


func test_a_line_without_length_is_refused_and_the_old_one_stays() -> void:
	assert_string_contains(model.move_line(Vec2.new(5, 5), Vec2.new(5, 5)), "longer than 0")
	assert_vec2(model.line.start, Vec2.new(60, 45), 0.0)


func test_a_radius_that_is_not_positive_is_refused_and_the_old_one_stays() -> void:
	assert_string_contains(model.set_radius(-1.0), "radius")
	assert_eq(model.radius, 10.0)


func test_a_stored_state_comes_back() -> void:
	_move(Vec2.new(1, 2), Vec2.new(3, 4))
	assert_no_refusal(model.move_line(Vec2.new(9, 8), Vec2.new(7, 5)))
	model.radius = 3.0
	model.mistake = PointOfImpactMistakes.FROM_NEW
	var again := PointOfImpactModel.new()
	again.from_dictionary(model.to_dictionary())
	assert_eq(again.to_dictionary(), model.to_dictionary())


func test_the_question_on_the_share_names_the_mistakes_of_the_course() -> void:
	var exercise := PointOfImpactExercise.new(PointOfImpactExercise.Kind.FRACTION, 50, -30, 10, 0)
	assert_true(exercise.check([0.5]).is_right)
	assert_string_contains(exercise.check([-1.333]).sentence, "b is old − new")
	assert_string_contains(exercise.check([2.0]).sentence, "negative behind the line")
	assert_string_contains(exercise.check([-0.5]).sentence, "counts from old")
	assert_string_contains(exercise.check([0.625]).sentence, "radius is missing")


func test_the_question_on_the_point_names_a_reset_and_a_wrong_start() -> void:
	var exercise := PointOfImpactExercise.new(PointOfImpactExercise.Kind.POINT, 50, -30, 10, -60)
	assert_vec2(exercise.old_position, Vec2.new(30, -40), 1e-12)
	assert_vec2(exercise.new_position, Vec2.new(30, 60), 1e-12)
	assert_true(exercise.check([30.0, 10.0]).is_right)
	assert_string_contains(exercise.check([54.0, 28.0]).sentence, "position reset")
	assert_string_contains(exercise.check([30.0, 110.0]).sentence, "not to new")
	assert_string_contains(exercise.check([0.0, 50.0]).sentence, "old is missing")


func test_fresh_questions_have_short_answers_and_end_behind_the_line() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 102
	var errors := PackedFloat64Array()
	for i: int in 200:
		var kind := (i % PointOfImpactExercise.Kind.size()) as PointOfImpactExercise.Kind
		var exercise := PointOfImpactExercise.fresh(kind, rng)
		for number in exercise.right_answer:
			errors.append(absf(100.0 * number - roundf(100.0 * number)))
		var new_distance := LineDistance.signed_distance(exercise.new_position, exercise.line)
		assert_lt(new_distance, 0.0)
		assert_true(exercise.check(exercise.right_answer).is_right)
	assert_all_at_most(errors, 1e-8)


func _move(old: Vec2, new: Vec2) -> void:
	model.old_position = old
	model.new_position = new


func test_a_mistake_is_named_without_its_minus_too() -> void:
	var exercise := PointOfImpactExercise.new(PointOfImpactExercise.Kind.FRACTION, 42, -38, 10, 0)
	assert_true(exercise.check([0.4]).is_right)
	assert_string_contains(exercise.check([0.842]).sentence, "b is old − new")
	assert_string_contains(exercise.check([0.6]).sentence, "counts from old")
	assert_string_contains(exercise.check([-0.4]).sentence, "not new − old")
	assert_string_contains(exercise.check([0.65]).sentence, "radius is subtracted")


# 30 pixels along the normal, 40 along the line: each distance is off by rounding.
func test_what_rounding_leaves_of_a_distance_decides_no_case() -> void:
	var normal := model.line.normal()
	var along := model.line.along().normalized()
	for place: Vec2 in random_vectors(103, 100, 200.0):
		var touching := model.line.start.plus(along.scaled(place.x)).plus(normal.scaled(10.0))
		_move(touching, touching.plus(along.scaled(place.y)))
		assert_eq(model.frame_case(), PointOfImpactModel.Case.PARALLEL)
		_move(touching, touching.plus(along.scaled(place.y)).minus(normal.scaled(30.0)))
		assert_eq(model.frame_case(), PointOfImpactModel.Case.IN_FRAME)
		assert_eq(model.fraction(), 0.0)
		_move(touching.plus(along.scaled(place.y)).plus(normal.scaled(30.0)), touching)
		assert_eq(model.frame_case(), PointOfImpactModel.Case.IN_FRAME)
		assert_eq(model.fraction(), 1.0)
		assert_vec2(model.impact_position(), touching, 1e-12)


func test_a_ball_that_flies_straight_at_the_line_is_reset_to_where_it_touches() -> void:
	var normal := model.line.normal()
	_move(normal.scaled(50.0), normal.scaled(-30.0))
	assert_true(model.is_reset_at_impact())
	assert_string_contains(PointOfImpactTexts.sentences(model)[-1], "the same place")


func test_t_is_told_only_where_it_counts() -> void:
	var words: Dictionary[String, String] = {
		"Lecture": "within 0..1",
		"Not yet": "after this frame",
		"Inside": "before this frame",
		"Away": "moves away, and t does not count",
		"Leaving": "moves away, and t does not count",
		"Along": "so there is no t",
	}
	for preset in words:
		assert_no_refusal(model.take(PointOfImpactModel.PRESETS[preset]))
		var sentence := PointOfImpactTexts.sentences(model)[PointOfImpactTexts.Step.FRACTION]
		assert_string_contains(sentence, words[preset])
