extends LabTest
## The model of the lesson on the moment to fire: the moment, the window, what other moments miss
## by, and its state.

const _SHOTS := 30


func test_the_right_moment_at_a_target_on_a_line() -> void:
	var model := TimedShotModel.new()
	assert_almost_eq(model.shot().fire, 2.0, 1e-15)
	assert_almost_eq(model.flight(), 1.0, 1e-15)
	assert_almost_eq(model.time_to_crossing(), 3.0, 1e-15)
	assert_vec2(model.crossing(), Vec2.new(0, -100), 1e-12)


func test_fired_late_it_misses_by_less_than_the_target_is_past() -> void:
	var model := TimedShotModel.new()
	assert_almost_eq(model.miss_at(3.0).distance, 20000.0 / sqrt(50000.0), 1e-9)
	assert_almost_eq(model.miss_at(2.0).distance, 0.0, 1e-12)


func test_the_window_has_both_motions() -> void:
	var model := TimedShotModel.new()
	assert_almost_eq(model.half_window(), 0.1118, 5e-5)
	assert_almost_eq(model.window()[0], 2.0 - 10.0 * sqrt(50000.0) / 20000.0, 1e-12)
	for edge: float in model.window():
		assert_almost_eq(model.miss_at(edge).distance, 10.0, 1e-9)


func test_the_window_never_begins_before_the_start() -> void:
	var model := TimedShotModel.new()
	model.radius = 1000.0
	assert_eq(model.window()[0], 0.0)


func test_a_target_on_a_circle() -> void:
	var model := _model("Circle")
	assert_almost_eq(model.shot().fire, 0.5, 1e-12)
	assert_almost_eq(model.flight(), 0.5, 1e-12)
	assert_lt(model.miss().distance, 1e-9)
	for edge: float in model.window():
		assert_almost_eq(model.miss_at(edge).distance, 10.0, 1e-3)


func test_the_search_on_a_circle_finds_the_nearest_moment() -> void:
	var model := _model("Circle")
	var rng := RandomNumberGenerator.new()
	rng.seed = 4
	for number: int in _SHOTS:
		var fire := rng.randf_range(0, 6)
		var shot := FiredShot.new(model.muzzle, model.bullet_velocity(fire))
		var place := func(seconds: float) -> Vec2: return model.target_after(fire + seconds)
		var least := INF
		for part: int in 400:
			least = minf(least, shot.distance_after(3.0 * part / 400.0, place))
		assert_lt(model.miss_at(fire).distance, least + 1e-9, "fired after %s s" % fire)


func test_a_barrel_that_turns() -> void:
	var model := _model("Turning barrel")
	assert_true(model.has_shot())
	assert_lt(model.miss().distance, 1e-9)
	var span := model.window()
	assert_lt(span[0], model.shot().fire)
	for edge: float in span:
		assert_almost_eq(model.miss_at(edge).distance, 10.0, 1e-3)


func test_a_right_shot_misses_by_no_more_than_rounding_makes() -> void:
	for preset: String in TimedShotModel.PRESETS:
		var model := _model(preset)
		if model.has_shot():
			assert_lt(model.miss().distance, 8.0 * model.rounding(), preset)


func test_each_reason_why_no_moment_hits() -> void:
	var model := _model("Too late")
	assert_eq(model.reason(), TimedShotModel.Reason.TOO_LATE)
	assert_eq(_model("Parallel").reason(), TimedShotModel.Reason.PARALLEL)
	model.target.set_xy(-9000.0, -100.0)
	assert_eq(model.reason(), TimedShotModel.Reason.TOO_LONG)
	model.target.set_xy(-300.0, 200.0)
	assert_eq(model.reason(), TimedShotModel.Reason.NO_CROSSING)
	model.velocity.set_xy(0.0, 0.0)
	assert_eq(model.reason(), TimedShotModel.Reason.RESTS)
	model = _model("Circle")
	model.muzzle.set_xy(300.0, 100.0)
	assert_eq(model.reason(), TimedShotModel.Reason.NO_CROSSING)
	model = _model("Turning barrel")
	model.velocity.set_xy(300.0, 0.0)
	assert_eq(model.reason(), TimedShotModel.Reason.TOO_SLOW)


func test_what_cannot_be_is_refused() -> void:
	var model := TimedShotModel.new()
	assert_string_contains(model.enter("wy", 0.0), "speed of 1 px/s or more, not 0")
	assert_string_contains(model.enter("R", -1.0), "radius must be within 0..10000, not −1")
	assert_string_contains(model.enter("circling", 0.0), "circling must be within 1..720, not 0")
	assert_string_contains(model.enter("tx", 1e5), "target must be within")
	assert_string_contains(model.take({"fire": -1.0}), "fire must be within 0..60")
	assert_string_contains(model.take({"kind": 3}), "kind must be within 0..2")
	assert_eq(model.take({"target": PackedFloat64Array([0.0, -50.0])}), "", "on a line")
	assert_string_contains(model.take({"kind": 1}), "radius of 1 px or more, not 0")
	assert_vec2(model.bullet, Vec2.new(0, -200), 0.0)


func test_its_state_can_be_put_back() -> void:
	var model := _model("Circle")
	model.own_fire = 2.5
	var other := TimedShotModel.new()
	assert_eq(other.take(model.to_dictionary()), "")
	assert_eq(other.to_dictionary(), model.to_dictionary())


func _model(preset: String) -> TimedShotModel:
	var model := TimedShotModel.new()
	assert_eq(model.take(TimedShotModel.PRESETS[preset]), "")
	return model
