extends LabTest
## The model of the lesson on reflection.


func test_the_three_velocities_of_the_lecture() -> void:
	var model := ReflectionModel.new()
	assert_vec2(model.unit_normal(), Vec2.new(0, -1), 0.0)
	assert_vec2(model.velocity_after(0.0), Vec2.new(3, 4), 0.0)
	assert_vec2(model.velocity_after(1.0), Vec2.new(3, 0), 0.0)
	assert_vec2(model.velocity_after(2.0), Vec2.new(3, -4), 0.0)


func test_the_steps_subtract_never_once_twice_and_1_plus_c_times() -> void:
	var model := ReflectionModel.new()
	model.bounciness = 0.25
	var times: Array[float] = []
	for step: int in ReflectionModel.Step.size():
		times.append(model.times_subtracted(step as ReflectionModel.Step))
	assert_eq(times, [1.25, 0.0, 1.0, 2.0, 1.25, 1.25] as Array[float])


func test_the_normal_part_of_the_lecture() -> void:
	assert_vec2(ReflectionModel.new().normal_part(), Vec2.new(0, 4), 0.0)


func test_both_normals_give_the_same() -> void:
	var model := ReflectionModel.new()
	var one := model.reflected()
	model.along = model.along.negated()
	assert_vec2(model.unit_normal(), Vec2.new(0, 1), 0.0)
	assert_vec2(model.reflected(), one, 0.0)


func test_the_facing_normal_is_on_the_side_the_ball_comes_from() -> void:
	var model := ReflectionModel.new()
	assert_vec2(model.facing_normal(), Vec2.new(0, -1), 0.0)
	model.velocity = Vec2.new(3, -4)
	assert_vec2(model.facing_normal(), Vec2.new(0, 1), 0.0)


func test_both_angles_are_equal_for_c_1() -> void:
	var differences := PackedFloat64Array()
	var vectors := random_vectors(171, 100)
	for i: int in range(0, 100, 2):
		var model := _model(vectors[i], vectors[i + 1])
		var out := model.angle_out_degrees(model.reflected())
		differences.append(absf(model.angle_in_degrees() - out))
	assert_all_at_most(differences, 1e-11)


func test_the_angles_of_the_lecture_at_c_1_and_one_half() -> void:
	var model := ReflectionModel.new()
	assert_almost_eq(model.angle_in_degrees(), 36.86989764584402, 1e-12)
	model.bounciness = 0.5
	assert_almost_eq(model.angle_out_degrees(model.reflected()), 56.309932474020215, 1e-12)
	assert_almost_eq(model.energy_share(model.reflected()), 13.0 / 25.0, 1e-15)


func test_below_c_1_the_angles_are_equal_head_on_and_along_the_line_only() -> void:
	var step := ReflectionModel.Step.BOUNCE
	var signs: Array[String] = []
	for velocity: Vec2 in [Vec2.new(3, 4), Vec2.new(0, 5), Vec2.new(5, 0)]:
		var model := _model(velocity, Vec2.new(-7, 0))
		model.bounciness = 0.5
		signs.append(ReflectionTexts.verdict_sign(model, step))
	assert_eq(signs, ["≠", "=", "="] as Array[String])


func test_a_ball_that_stops_has_no_angle_out() -> void:
	var model := _model(Vec2.new(0, 5), Vec2.new(-7, 0))
	var step := ReflectionModel.Step.SLIDE
	assert_eq(ReflectionTexts.verdict_sign(model, step), "≠")
	assert_eq(ReflectionTexts.verdict(model, step)[0], "in 0° from n̂, and it stops")


func test_what_rounding_leaves_of_a_ball_head_on_stops() -> void:
	var velocity := Vec2.new(1.507691997926561, -1.3141022941111606)
	var model := _model(velocity, Vec2.new(-61.5, -70.56))
	assert_ne(model.velocity_after(1.0).length(), 0.0, "the numbers leave a rest")
	var verdict := ReflectionTexts.verdict(model, ReflectionModel.Step.SLIDE)
	assert_eq(verdict[0], "in 0° from n̂, and it stops")


func test_a_normal_that_is_not_unit_is_refused_in_the_words_of_vec2() -> void:
	for size: float in [2.0, 0.5, 14.000001, 1.0 + 2e-9]:
		var model := ReflectionModel.new()
		model.has_unit_normal = false
		model.normal_length = size
		var velocity := model.velocity.reflected(model.used_normal())
		assert_push_error(model.refusal())
		assert_vec2(model.reflected(), velocity, 0.0)


func test_a_normal_of_length_1_is_taken_by_both() -> void:
	var model := ReflectionModel.new()
	model.has_unit_normal = false
	model.normal_length = 1.0 + 0.5e-9
	assert_eq(model.refusal(), "")
	assert_vec2(model.reflected(), Vec2.new(3, -4), 1e-8)


func test_numbers_are_taken_by_their_names() -> void:
	var model := ReflectionModel.new()
	for name_in_line: String in ["vx", "vy", "lx", "ly", "n_length"]:
		assert_eq(model.enter(name_in_line, 2.5), "")
	assert_eq(model.enter("C", 0.25), "")
	assert_vec2(model.velocity, Vec2.new(2.5, 2.5), 0.0)
	assert_vec2(model.along, Vec2.new(2.5, 2.5), 0.0)
	assert_eq([model.normal_length, model.bounciness], [2.5, 0.25])


func test_what_cannot_be_is_refused_with_its_value_and_the_old_stays() -> void:
	var model := ReflectionModel.new()
	assert_eq(model.enter("C", 1.5), "C must be within 0..1, but is 1.5.")
	assert_eq(model.enter("C", -0.1), "C must be within 0..1, but is −0.1.")
	assert_eq(model.bounciness, 1.0)
	assert_string_contains(model.enter("lx", 0.0), "no direction")
	assert_vec2(model.along, Vec2.new(-7, 0), 0.0)
	assert_string_contains(model.enter("n_length", -2.0), "must be above 0, but is −2")
	assert_eq(model.normal_length, 2.0)


func test_pointing_the_normal_turns_the_line_and_keeps_its_length() -> void:
	var model := ReflectionModel.new()
	model.point_normal(Vec2.new(3, -4))
	assert_vec2(model.unit_normal(), Vec2.new(0.6, -0.8), EPSILON)
	assert_almost_eq(model.along.length(), 7.0, 1e-14)
	model.point_normal(Vec2.zero())
	assert_vec2(model.unit_normal(), Vec2.new(0.6, -0.8), EPSILON, "a zero vector has no direction")


func test_dragging_what_leaves_sets_the_bounciness_within_0_and_1() -> void:
	var model := ReflectionModel.new()
	var found: Array[float] = []
	for y: float in [-2.0, -9.0, 3.0, -1.13]:
		model.fit_bounciness(Vec2.new(8, y))
		found.append(model.bounciness)
	assert_eq(found, [0.5, 1.0, 0.0, 0.3] as Array[float])


func test_a_ball_along_the_line_keeps_its_bounciness() -> void:
	var model := _model(Vec2.new(5, 0), Vec2.new(-7, 0))
	model.fit_bounciness(Vec2.new(5, -2))
	assert_eq(model.bounciness, 1.0)
	assert_vec2(model.reflected(), Vec2.new(5, 0), 0.0)


func test_the_ball_touches_the_line_at_time_0() -> void:
	var model := ReflectionModel.new()
	model.time = 0.0
	assert_vec2(model.ball_centre(0.5, model.reflected()), Vec2.new(0, -0.5), 0.0)
	model.time = -1.0
	assert_vec2(model.ball_centre(0.5, model.reflected()), Vec2.new(-3, -4.5), 0.0)
	model.time = 1.0
	assert_vec2(model.ball_centre(0.5, model.reflected()), Vec2.new(3, -4.5), 0.0)


func test_time_stays_within_the_flight() -> void:
	var model := ReflectionModel.new()
	model.time = 99.0
	assert_eq(model.time, ReflectionModel.END)
	model.time = -99.0
	assert_eq(model.time, ReflectionModel.START)


func test_what_is_stored_can_be_put_back() -> void:
	var model := _model(Vec2.new(1, 2), Vec2.new(3, 4))
	model.bounciness = 0.5
	model.has_unit_normal = false
	model.mistake = 13
	var other := ReflectionModel.new()
	other.from_dictionary(model.to_dictionary())
	assert_eq(other.to_dictionary(), model.to_dictionary())


func _model(velocity: Vec2, along: Vec2) -> ReflectionModel:
	var model := ReflectionModel.new()
	model.velocity = velocity.copy()
	model.along = along.copy()
	return model
