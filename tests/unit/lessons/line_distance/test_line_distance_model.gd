extends LabTest
## The model of the lesson on the distance from a line, its mistakes and its question.

var model: LineDistanceModel


func before_each() -> void:
	model = LineDistanceModel.new()


func test_it_starts_with_a_free_ball_100_pixels_from_the_line() -> void:
	assert_almost_eq(model.distance(), 100.0, 1e-12)
	assert_almost_eq(model.gap(), 70.0, 1e-12)
	assert_false(model.is_overlapping())


func test_sliding_p_changes_the_difference_vector_but_not_the_distance() -> void:
	for share: float in [-20.0, -0.4, 0.0, 0.7, 1.0, 35.0]:
		model.from_share = share
		assert_almost_eq(model.distance(), 100.0, 1e-10, "p at %s" % share)
	assert_gt(model.difference().length(), 10000.0)


func test_p_slides_to_the_foot_of_the_perpendicular() -> void:
	model.slide_to(Vec2.new(120, -35))
	assert_vec2(model.from(), Vec2.new(60, 45), 1e-12)
	model.slide_to(Vec2.new(-400, -300))
	assert_almost_eq(model.from_share, 1.5, 1e-14)


func test_the_foot_is_on_the_line_and_perpendicular_below_the_ball() -> void:
	for place: Vec2 in random_vectors(91, 100, 400.0):
		model.ball.position = place
		var down := place.minus(model.foot())
		assert_almost_eq(down.dot(model.line.along()), 0.0, 1e-9)
		assert_almost_eq(model.foot().minus(model.line.start).cross(model.line.along()), 0.0, 1e-9)


func test_beside_the_end_the_segment_is_farther_away_than_the_line() -> void:
	model.ball.position = Vec2.new(263, 166)
	assert_true(model.is_beside_end())
	assert_almost_eq(model.distance(), 25.0, 1e-12)
	assert_almost_eq(model.segment_distance(), 65.0, 1e-12)
	assert_true(model.is_overlapping())


func test_between_the_ends_both_distances_agree() -> void:
	assert_false(model.is_beside_end())
	assert_almost_eq(model.segment_distance(), model.distance(), 1e-12)


func test_behind_the_line_the_distance_is_negative() -> void:
	model.ball.position = Vec2.new(24, 93)
	assert_true(model.is_behind())
	assert_almost_eq(model.distance(), -60.0, 1e-12)


func test_each_mistake_gives_its_wrong_distance() -> void:
	var wrong: Dictionary[int, float] = {
		LineDistanceMistakes.NOT_UNIT: 50000.0,
		LineDistanceMistakes.WRONG_SIGN: -100.0,
		LineDistanceMistakes.STRAIGHT_UP: 125.0,
	}
	for number in wrong:
		model.mistake = number
		assert_almost_eq(model.distance_with_mistake(), wrong[number], 1e-9, str(number))
		assert_almost_eq(model.distance(), 100.0, 1e-12)


func test_without_a_mistake_the_distance_is_the_right_one() -> void:
	assert_almost_eq(model.distance_with_mistake(), 100.0, 1e-12)
	assert_vec2(model.position_with_mistake(), model.ball.position, 1e-12)


func test_straight_up_from_a_vertical_line_is_no_number() -> void:
	assert_no_refusal(model.move_line(Vec2.new(0, 50), Vec2.new(0, -50)))
	model.mistake = LineDistanceMistakes.STRAIGHT_UP
	assert_false(model.position_with_mistake().is_finite())


func test_every_mistake_of_the_gallery_names_a_test_that_exists() -> void:
	var script: GDScript = load("res://tests/unit/collision/test_line_distance.gd")
	var names := script.get_script_method_list().map(
		func(method: Dictionary) -> String: return method["name"]
	)
	for info in LineDistanceMistakes.infos():
		assert_eq(info.test.get_slice(".", 0), "test_line_distance")
		assert_has(names, info.test.get_slice(".", 1))


func test_a_mistake_of_the_lecture_is_headed_by_its_part() -> void:
	var headings := LineDistanceMistakes.infos().map(
		func(info: MistakeInfo) -> String: return info.heading().get_slice(":", 0)
	)
	assert_eq(headings, ["Part 2", "Mistake 9", "Mistake 10"])


func test_a_line_without_length_is_refused_and_the_old_one_stays() -> void:
	var problem := model.move_line(Vec2.new(5, 5), Vec2.new(5, 5))
	assert_string_contains(problem, "longer than 0")
	assert_vec2(model.line.start, Vec2.new(200, 150), 0.0)


func test_a_radius_that_is_not_positive_is_refused_and_the_old_one_stays() -> void:
	for radius: float in [0.0, -3.0, INF, NAN]:
		assert_string_contains(model.resize_ball(radius), "radius")
		assert_eq(model.ball.radius, 30.0)
	assert_eq(model.resize_ball(12.0), "")
	assert_eq(model.ball.radius, 12.0)


func test_a_stored_state_comes_back() -> void:
	assert_no_refusal(model.move_line(Vec2.new(1, 2), Vec2.new(3, 5)))
	model.ball = Ball.new(Vec2.new(7, -8), 9)
	model.from_share = -0.25
	model.mistake = LineDistanceMistakes.STRAIGHT_UP
	var again := LineDistanceModel.new()
	again.from_dictionary(model.to_dictionary())
	assert_eq(again.to_dictionary(), model.to_dictionary())


func test_a_stored_state_shares_nothing_with_the_model() -> void:
	var stored := model.to_dictionary()
	model.ball.position.add(Vec2.new(1, 1))
	model.line.start.add(Vec2.new(1, 1))
	assert_eq(stored, LineDistanceModel.new().to_dictionary())


func test_the_question_takes_the_right_answer_and_names_the_mistakes() -> void:
	var line := LineSegment.new(Vec2.new(4, 3), Vec2.new(0, 0))
	var exercise := LineDistanceExercise.new(
		LineDistanceExercise.Kind.DISTANCE, line, Ball.new(Vec2.new(5, -5), 2)
	)
	assert_true(exercise.check([7.0]).is_right)
	assert_string_contains(exercise.check([35.0]).sentence, "5 times the distance")
	assert_string_contains(exercise.check([-7.0]).sentence, "(−y, x)")
	assert_string_contains(exercise.check([8.75]).sentence, "the vertical way")
	assert_string_contains(exercise.check([5.4]).sentence, "not it yet")


func test_the_question_on_the_gap_names_a_radius_forgotten_or_added() -> void:
	var line := LineSegment.new(Vec2.new(4, 3), Vec2.new(0, 0))
	var exercise := LineDistanceExercise.new(
		LineDistanceExercise.Kind.GAP, line, Ball.new(Vec2.new(5, -5), 2)
	)
	assert_true(exercise.check([5.0]).is_right)
	assert_string_contains(exercise.check([7.0]).sentence, "not subtracted")
	assert_string_contains(exercise.check([9.0]).sentence, "not added")


func test_fresh_questions_have_short_answers() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 92
	var errors := PackedFloat64Array()
	for i: int in 200:
		var kind := (i % LineDistanceExercise.Kind.size()) as LineDistanceExercise.Kind
		var exercise := LineDistanceExercise.fresh(kind, rng)
		var tenths := 10.0 * exercise.right_answer[0]
		errors.append(absf(tenths - roundf(tenths)))
		assert_true(exercise.check(exercise.right_answer).is_right)
	assert_all_at_most(errors, 1e-9)


func test_a_way_that_is_not_the_perpendicular_is_named_with_either_sign() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 93
	for i: int in 200:
		var kind := (i % LineDistanceExercise.Kind.FRAME) as LineDistanceExercise.Kind
		var exercise := (
			Exercise.drawn(LineDistanceExercise.fresh, kind, rng) as LineDistanceExercise
		)
		var less := exercise.ball.radius if kind == LineDistanceExercise.Kind.GAP else 0.0
		var centre := exercise.ball.position
		var up := LineDistanceMistakes.point_straight_below(centre, exercise.line).y - centre.y
		var way := LineDistance.difference(centre, exercise.line)
		for side: float in [1.0, -1.0]:
			assert_string_contains(exercise.check([side * up - less]).sentence, "the vertical way")
			assert_string_contains(exercise.check([side * way.length() - less]).sentence, "|d|")


func test_the_first_frame_in_which_a_ball_overlaps_is_asked_for() -> void:
	var line := LineSegment.new(Vec2.new(0, 0), Vec2.new(-10, 0))
	var ball := Ball.new(Vec2.new(0, -30), 4.0)
	var exercise := LineDistanceExercise.new(LineDistanceExercise.Kind.FRAME, line, ball, 7.0)
	assert_true(exercise.check([4.0]).is_right, "26 px are free: 3 frames of 7 px are 21, 4 are 28")
	assert_string_contains(exercise.check([3.0]).sentence, "does not overlap yet")
	assert_string_contains(exercise.check([5.0]).sentence, "the radius is not subtracted")
	assert_string_contains(exercise.check([26.0 / 7.0]).sentence, "whole frames")
	assert_string_contains(exercise.solution(), "30 − 4")


func test_detection_looks_once_a_frame() -> void:
	var red: Dictionary[DiscreteDetection.Rule, Array] = {
		DiscreteDetection.Rule.BELOW_RADIUS: [false, false, false, true, true],
		DiscreteDetection.Rule.ONLY_ABOVE: [false, false, false, false, false],
		DiscreteDetection.Rule.BOTH_SIDES: [false, false, false, true, false],
	}
	for rule: DiscreteDetection.Rule in red:
		var detection := DiscreteDetection.new(100.0, 30.0, 35.0, rule)
		assert_eq(detection.last_frame(), 4)
		var seen: Array = range(5).map(detection.is_red)
		assert_eq(seen, red[rule], "100, 65, 30, -5, -40: rule %d" % rule)
	assert_true(DiscreteDetection.new(35.0, 30.0, 3.0, DiscreteDetection.Rule.ONLY_ABOVE).is_red(2))


func test_a_fast_ball_is_never_seen() -> void:
	var both := DiscreteDetection.Rule.BOTH_SIDES
	assert_true(DiscreteDetection.new(100.0, 30.0, 140.0, both).is_never_seen())
	assert_false(DiscreteDetection.new(100.0, 30.0, 35.0, both).is_never_seen())
	assert_false(DiscreteDetection.new(-60.0, 30.0, 35.0, both).is_never_seen(), "behind already")
	assert_false(DiscreteDetection.new(1e9, 30.0, 140.0, both).is_never_seen(), "not there yet")
	var signed := DiscreteDetection.Rule.BELOW_RADIUS
	assert_false(DiscreteDetection.new(100.0, 30.0, 140.0, signed).is_never_seen())


func test_the_question_on_the_gap_asks_for_free_balls_too() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 94
	var free := 0
	for i: int in 200:
		var exercise := Exercise.drawn(
			LineDistanceExercise.fresh, LineDistanceExercise.Kind.GAP, rng
		)
		free += 1 if exercise.right_answer[0] > 0.0 else 0
	assert_between(free, 40, 160)


func test_what_rounding_leaves_of_a_distance_or_a_gap_is_0() -> void:
	for place: Vec2 in random_vectors(95, 100, 400.0):
		model.ball.position = model.line.start.lerped(model.line.end, place.x / 400.0)
		assert_true(model.is_on_line(), "on the line")
		assert_false(model.is_behind())
		model.ball.position.add(model.line.normal().scaled(model.ball.radius))
		assert_true(model.is_touching(), "touching")
		assert_false(model.is_overlapping())
		assert_eq(LineDistanceTexts.right_choice(model), -1)


func test_the_flight_begins_at_the_distance_that_the_steps_have_found() -> void:
	model.line = LineSegment.new(Vec2.new(200.0, 150.0), Vec2.new(-200.0, -150.0))
	model.ball.position = Vec2.new(199.99999999992, 149.999999999815)
	model.ball.radius = 30.0
	model.from_share = 1.0
	model.speed = 1e-12
	assert_eq(model.detection().distance_at(12), model.distance() - 12.0 * model.speed)
	assert_ne(model.distance(), model.distance_from_start(), "which differ by rounding here")
