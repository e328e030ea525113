extends LabTest
## The model of the lesson on aiming under gravity: its aims, the least speed, and its state.


func test_two_arcs_hit_at_their_times() -> void:
	var model := BallisticAimModel.new()
	assert_eq(model.shots().size(), 2)
	assert_vec2(model.shots()[0].direction, Vec2.new(0.8, -0.6), 1e-15)
	assert_almost_eq(model.shots()[0].time, 1.0, 1e-15)
	assert_vec2(model.shots()[1].direction, Vec2.new(0.6, -0.8), 1e-15)
	assert_almost_eq(model.shots()[1].time, 4.0 / 3.0, 1e-15)


func test_the_least_speed_halves_the_angle_to_straight_up() -> void:
	var model := BallisticAimModel.new()
	assert_almost_eq(model.least_speed(), sqrt(60000.0), 1e-12)
	assert_vec2(model.least_direction(), Vec2.unit_degrees(-45.0), 1e-15)
	model.target.set_xy(0.0, 100.0)
	assert_false(model.has_least(), "it need only be dropped")


func test_below_the_least_speed_nothing_hits() -> void:
	var model := _model("Out of reach")
	assert_false(model.has_shot())
	assert_eq(model.reason(), BallisticAimModel.Reason.TOO_SLOW)
	assert_lt(model.w(), 0.0)


func test_at_the_edge_both_arcs_are_one() -> void:
	var model := _model("Edge")
	assert_eq(model.shots().size(), 1)
	assert_almost_eq(model.least_speed(), 200.0, 1e-12)
	assert_eq(model.w(), 0.0)


func test_without_gravity_one_straight_shot_hits() -> void:
	var model := _model("g = 0")
	assert_eq(model.shots().size(), 1)
	assert_vec2(model.shot().direction, model.target.normalized(), 1e-15)
	assert_false(model.has_least())


func test_straight_up_is_no_special_case() -> void:
	var model := _model("Straight up")
	assert_true(model.is_upright())
	for shot in model.shots():
		assert_vec2(shot.direction, Vec2.new(0.0, -1.0), 1e-12)


func test_a_falling_target_is_aimed_at_straight() -> void:
	var model := _model("Falling target")
	assert_eq(model.shots().size(), 1)
	assert_vec2(model.shot().direction, Vec2.new(0.8, -0.6), 1e-15)
	assert_almost_eq(model.shot().time, 0.5, 1e-15)


func test_a_moving_target_can_be_hit_in_four_ways() -> void:
	var model := _model("Four aims")
	assert_eq(model.shots().size(), 4)
	for place: int in 4:
		model.arc = place
		assert_lt(model.miss().distance, 1e-9, "aim %d" % place)


func test_a_target_that_gets_away_has_its_reason() -> void:
	var model := _model("Falling target")
	model.moves = true
	model.velocity.set_xy(320.0, -240.0)
	assert_eq(model.reason(), BallisticAimModel.Reason.OUTRUN)
	model.target.set_xy(0.0, 0.0)
	assert_eq(model.reason(), BallisticAimModel.Reason.SAME_PLACE)


func test_a_right_shot_misses_by_no_more_than_rounding_makes() -> void:
	for preset: String in BallisticAimModel.PRESETS:
		var model := _model(preset)
		for place: int in model.shots().size():
			model.arc = place
			assert_lt(model.miss().distance, 8.0 * model.rounding(), preset)


func test_the_miss_of_rounding_is_small_and_not_zero() -> void:
	assert_between(BallisticAimModel.new().rounding(), 1e-13, 1e-12)


func test_up_to_the_arcs_it_is_shot_straight_at_the_target() -> void:
	var model := BallisticAimModel.new()
	assert_vec2(model.direction(BallisticAimModel.Step.DROP), Vec2.new(1.0, 0.0), 0.0)
	assert_vec2(model.direction(BallisticAimModel.Step.FIRE), Vec2.new(0.8, -0.6), 1e-15)
	assert_almost_eq(model.end(BallisticAimModel.Step.FIRE), 1.0, 1e-15)


func test_numbers_out_of_range_are_refused() -> void:
	var model := BallisticAimModel.new()
	assert_string_contains(model.enter("s", 0.0), "s must be within 1..100000, not 0")
	assert_string_contains(model.enter("g", -1.0), "g must be within 0..100000, not −1")
	assert_string_contains(model.enter("x", 1e6), "x must be within −100000..100000")
	assert_eq(model.speed, 250.0)
	assert_eq(model.enter("g", 0.0), "")
	assert_eq(model.gravity, 0.0)


func test_its_state_can_be_put_back() -> void:
	var model := _model("Four aims")
	model.arc = 3
	var other := BallisticAimModel.new()
	assert_eq(other.take(model.to_dictionary()), "")
	assert_eq(other.to_dictionary(), model.to_dictionary())
	assert_string_contains(other.take({"arc": 4}), "arc")
	assert_string_contains(other.take({"mistake": 5}), "mistake")


func _model(preset: String) -> BallisticAimModel:
	var model := BallisticAimModel.new()
	assert_eq(model.take(BallisticAimModel.PRESETS[preset]), "")
	return model
