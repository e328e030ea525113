extends LabTest
## The model of the lesson on line ends: one shot at five kinds of line.


func test_at_the_start_the_five_fields_differ_as_the_lesson_says() -> void:
	var model := LineEndsModel.new()
	assert_eq(
		model.result_in(LineEndsModel.Field.INFINITE_ONE_SIDED), LineEndsModel.Result.PASSES_THROUGH
	)
	assert_eq(
		model.result_in(LineEndsModel.Field.INFINITE_TWO_SIDED),
		LineEndsModel.Result.BOUNCES_IN_THE_AIR
	)
	assert_eq(
		model.result_in(LineEndsModel.Field.SEGMENT_ONE_SIDED),
		LineEndsModel.Result.CUTS_THROUGH_THE_END
	)
	assert_eq(
		model.result_in(LineEndsModel.Field.SEGMENT_TWO_SIDED),
		LineEndsModel.Result.CUTS_THROUGH_THE_END
	)
	assert_eq(
		model.result_in(LineEndsModel.Field.ROUND_CAPS), LineEndsModel.Result.BOUNCES_ON_THE_END
	)


func test_a_shot_at_the_middle_from_behind_passes_only_one_sided_lines() -> void:
	var model := _model("Middle")
	assert_eq(
		model.result_in(LineEndsModel.Field.INFINITE_ONE_SIDED), LineEndsModel.Result.PASSES_THROUGH
	)
	assert_eq(
		model.result_in(LineEndsModel.Field.SEGMENT_ONE_SIDED), LineEndsModel.Result.PASSES_THROUGH
	)
	assert_eq(model.result_in(LineEndsModel.Field.SEGMENT_TWO_SIDED), LineEndsModel.Result.BOUNCES)
	assert_eq(model.result_in(LineEndsModel.Field.ROUND_CAPS), LineEndsModel.Result.BOUNCES)


func test_a_shot_at_the_middle_from_the_good_side_bounces_on_every_line() -> void:
	var model := _model("Middle")
	model.start = Vec2.new(-4, 14)
	model.motion = Vec2.new(8, -16)
	for field: LineEndsModel.Field in LineEndsModel.Field.values():
		assert_eq(model.result_in(field), LineEndsModel.Result.BOUNCES)


func test_a_near_miss_passes_beside_every_segment() -> void:
	var model := _model("Miss")
	assert_eq(
		model.result_in(LineEndsModel.Field.SEGMENT_ONE_SIDED), LineEndsModel.Result.PASSES_BESIDE
	)
	assert_eq(model.result_in(LineEndsModel.Field.ROUND_CAPS), LineEndsModel.Result.PASSES_BESIDE)
	assert_lt(model.cap_equation().discriminant(), 0.0)


func test_misses_are_told_apart() -> void:
	var model := _model("Middle")
	model.motion = Vec2.zero()
	assert_eq(model.result_in(LineEndsModel.Field.ROUND_CAPS), LineEndsModel.Result.RESTS)
	model.motion = Vec2.new(0, -5)
	assert_eq(model.result_in(LineEndsModel.Field.ROUND_CAPS), LineEndsModel.Result.MOVES_AWAY)
	model.motion = Vec2.new(5, 0)
	assert_eq(
		model.result_in(LineEndsModel.Field.INFINITE_TWO_SIDED), LineEndsModel.Result.MOVES_ALONG
	)
	model.motion = Vec2.new(0, 2)
	assert_eq(model.result_in(LineEndsModel.Field.ROUND_CAPS), LineEndsModel.Result.FALLS_SHORT)


func test_the_parts_of_the_quadratic_are_those_of_the_worked_example() -> void:
	var equation := _model("Head-on").cap_equation()
	assert_eq([equation.a, equation.b, equation.c], [100.0, -160.0, 55.0])
	assert_eq(equation.discriminant(), 3600.0)
	assert_eq([equation.first_root(), equation.second_root()], [0.5, 1.1])


func test_at_both_roots_the_ball_is_as_far_from_the_end_as_its_radius() -> void:
	var errors := PackedFloat64Array()
	var vectors := random_vectors(91, 600)
	for index: int in range(0, vectors.size(), 3):
		var point := vectors[index + 2]
		var equation := CapEquation.new(vectors[index], vectors[index + 1], 30.0, point)
		if equation.has_roots():
			errors.append(absf(equation.distance_at(equation.first_root()) - 30.0))
			errors.append(absf(equation.distance_at(equation.second_root()) - 30.0))
	assert_gt(errors.size(), 50)
	assert_all_at_most(errors, 1e-9)


func test_the_equation_and_the_impact_agree_on_the_fraction() -> void:
	var model := LineEndsModel.new()
	assert_eq(
		model.cap_equation().first_root(), model.impact_in(LineEndsModel.Field.ROUND_CAPS).fraction
	)


func test_the_exact_fraction_at_an_end_differs_by_rounding_only() -> void:
	var errors := PackedFloat64Array()
	var vectors := random_vectors(92, 600)
	for index: int in range(0, vectors.size(), 3):
		var point := vectors[index + 2]
		var equation := CapEquation.new(vectors[index], vectors[index + 1], 30.0, point)
		var exact := ExactImpactFraction.with_point(vectors[index], vectors[index + 1], 30.0, point)
		assert_eq(exact != null, equation.has_roots())
		if exact:
			errors.append(absf(exact.error_of(equation.first_root())))
	assert_all_at_most(errors, 1e-10)


func test_the_exact_fraction_is_far_closer_than_a_double() -> void:
	# t = (4 - sqrt(2)) / 2: with 100 bits, 2 t - 4 squared is 2 again.
	var exact := ExactImpactFraction.with_point(
		Vec2.new(-2, 1), Vec2.new(1, 0), sqrt(2.0), Vec2.zero()
	)
	var distance_squared := exact.minus(DoubleDouble.from_float(2.0))
	distance_squared = distance_squared.times(distance_squared)
	var radius_squared := DoubleDouble.product_of(sqrt(2.0), sqrt(2.0))
	var want := radius_squared.minus(DoubleDouble.from_float(1.0))
	assert_almost_eq(distance_squared.minus(want).to_float(), 0.0, 1e-29)


func test_the_exact_fraction_at_an_infinite_line_is_that_of_the_slide() -> void:
	var line := LineSegment.new(Vec2.new(-9, 4), Vec2.new(9, 4))
	var exact := ExactImpactFraction.with_line(Vec2.new(-4, -10), Vec2.new(8, 16), 3.0, line)
	assert_eq(exact.to_float(), 0.6875)
	var along := ExactImpactFraction.with_line(Vec2.new(-4, -10), Vec2.new(8, 0), 3.0, line)
	assert_null(along)


func test_a_flight_can_be_asked_for_any_fraction_in_any_order() -> void:
	var flight := LineEndsModel.new().flight_in(LineEndsModel.Field.ROUND_CAPS)
	assert_vec2(flight.position_at(1.0), Vec2.new(-11.52, -0.64), 1e-13)
	assert_vec2(flight.position_at(0.25), Vec2.new(-4.5, -4), 0.0)
	assert_vec2(flight.position_at(0.5), Vec2.new(-3, 0), 0.0)
	assert_vec2(flight.position_at(1.0), Vec2.new(-11.52, -0.64), 1e-13)


func test_a_bounce_keeps_the_speed() -> void:
	var model := LineEndsModel.new()
	for field: LineEndsModel.Field in LineEndsModel.Field.values():
		var after := model.flight_in(field).motion_after()
		assert_almost_eq(after.length(), model.motion.length(), 1e-13)


func test_a_flight_never_enters_the_capsule() -> void:
	var depths := PackedFloat64Array()
	var model := LineEndsModel.new()
	for motion: Vec2 in random_vectors(93, 200, 30.0):
		model.motion = motion
		var flight := model.flight_in(LineEndsModel.Field.ROUND_CAPS)
		for share: int in 51:
			var centre := flight.position_at(share / 50.0)
			var distance := centre.distance_to(model.segment.closest_point(centre))
			depths.append(model.radius - distance)
	assert_all_at_most(depths, 1e-9)


func test_what_cannot_be_is_refused_with_a_sentence() -> void:
	var model := LineEndsModel.new()
	assert_eq(model.problem(), "")
	model.radius = -2.0
	assert_string_contains(model.problem(), "0.001 to 1e6")
	model.radius = 5.0
	model.start.x = 2e6
	assert_string_contains(model.problem(), "-1e6 to 1e6")
	model.start.x = 0.0
	model.segment = LineSegment.new(Vec2.zero(), Vec2.zero())
	assert_string_contains(model.problem(), "ends must differ")


func test_what_is_stored_can_be_put_back() -> void:
	var model := _model("Head-on")
	model.fraction = 0.25
	model.mistake = 18
	var other := LineEndsModel.new()
	other.from_dictionary(model.to_dictionary())
	assert_eq(other.to_dictionary(), model.to_dictionary())
	assert_ne(other.to_dictionary(), LineEndsModel.new().to_dictionary())


func test_every_preset_can_be_used() -> void:
	for preset: String in LineEndsPresets.SHOTS:
		assert_eq(_model(preset).problem(), "", preset)


static func _model(preset: String) -> LineEndsModel:
	var model := LineEndsModel.new()
	LineEndsPresets.lay(model, preset)
	return model


func test_head_on_a_segment_without_caps_is_driven_into_lengthwise() -> void:
	var model := LineEndsModel.new()
	LineEndsPresets.lay(model, "Head-on")
	for field: LineEndsModel.Field in [
		LineEndsModel.Field.SEGMENT_ONE_SIDED, LineEndsModel.Field.SEGMENT_TWO_SIDED
	]:
		assert_eq(model.result_in(field), LineEndsModel.Result.DRIVES_IN_LENGTHWISE)
	LineEndsPresets.lay(model, "End")
	assert_eq(
		model.result_in(LineEndsModel.Field.SEGMENT_TWO_SIDED),
		LineEndsModel.Result.CUTS_THROUGH_THE_END
	)
