extends LabTest
## The lesson on sliding and rolling: its cases, and where each mistake lets the ball be.

var _model: SlideAndRollModel


func before_each() -> void:
	_model = SlideAndRollModel.new()


func test_down_a_slope_of_3_to_4_it_slides_with_360_and_rolls_with_240() -> void:
	var incline := _model.incline(_model.friction)
	assert_eq([incline.pull, incline.pressure, incline.length], [360.0, 480.0, 120.0])
	assert_almost_eq(_model.last_acceleration(SlideAndRollModel.Case.ROLLS), 240.0, 1e-12)
	assert_almost_eq(_model.ball().after(0.5).speed, 120.0, 1e-12)
	assert_almost_eq(_model.sliding_ball().after(0.5).speed, 180.0, 1e-12)


func test_120_px_take_1_s_rolling_and_0_816_s_sliding() -> void:
	assert_almost_eq(_model.ball().end_time, 1.0, 1e-15)
	assert_almost_eq(_model.sliding_ball().end_time, 0.8165, 1e-4)
	assert_almost_eq(_model.rolling_ball().end_time, 1.0, 1e-15)


func test_the_mark_is_a_third_of_tan() -> void:
	assert_almost_eq(_model.mark(), 0.25, 1e-16)
	for friction: float in [0.25, 0.251, 0.5, 0.75, 10.0]:
		assert_no_refusal(_model.take({"friction": friction}))
		assert_eq(_case(), SlideAndRollModel.Case.ROLLS, "µ = %s" % friction)
	for friction: float in [0.0, 0.1, 0.249]:
		assert_no_refusal(_model.take({"friction": friction}))
		assert_eq(_case(), SlideAndRollModel.Case.SLIPS, "µ = %s" % friction)


func test_on_the_level_it_rolls_at_two_thirds_after_0_833_s() -> void:
	_take("Level")
	var ball := _model.ball()
	assert_almost_eq(ball.roll_time, 300.0 / 360.0, 1e-15)
	assert_almost_eq(ball.end_speed, 200.0, 1e-12)
	assert_almost_eq(ball.end_time, 5.0 / 3.0, 1e-15)


func test_each_preset_is_its_case() -> void:
	var wanted: Dictionary[String, SlideAndRollModel.Case] = {
		"Rolls": SlideAndRollModel.Case.ROLLS,
		"At the mark": SlideAndRollModel.Case.ROLLS,
		"Slips": SlideAndRollModel.Case.SLIPS,
		"Pushed": SlideAndRollModel.Case.ROLLS_LATER,
		"Level": SlideAndRollModel.Case.ROLLS_LATER,
		"Too short": SlideAndRollModel.Case.ENDS_BEFORE,
	}
	assert_eq(wanted.keys(), SlideAndRollModel.PRESETS.keys())
	for title in wanted:
		_take(title)
		assert_eq(_case(), wanted[title], title)


func test_a_ball_at_rest_on_the_level_stays() -> void:
	assert_no_refusal(_model.take({"end": PackedFloat64Array([48.0, -36.0])}))
	assert_eq(_case(), SlideAndRollModel.Case.RESTS)
	assert_eq(_model.ball().end_time, INF)
	assert_eq(_model.ball().after(5.0).distance, 0.0)
	assert_gt(BallRace.new(_model).end(SlideAndRollModel.Step.RACE), 0.0)


func test_the_threshold_tan_lets_the_ball_slip_too_long() -> void:
	_switch_on(SlideAndRollMistakes.THRESHOLD)
	assert_almost_eq(_wrong().first, 168.0, 1e-12)
	assert_almost_eq(_lead(), -36.0, 1e-12)
	assert_almost_eq(_wrong().time_to(120.0), sqrt(240.0 / 168.0), 1e-14)
	# From tan on it is right again.
	assert_no_refusal(_model.take({"friction": 0.75}))
	assert_false(_model.shows_mistake())


func test_the_share_of_a_sphere_is_too_fast() -> void:
	_switch_on(SlideAndRollMistakes.SPHERE)
	assert_almost_eq(_wrong().second, 257.14, 0.01)
	assert_almost_eq(_lead(), 8.57, 0.01)


func test_friction_does_not_stop_a_ball_on_the_level() -> void:
	_take("Level")
	_switch_on(SlideAndRollMistakes.STOPS)
	assert_true(_wrong().stops())
	assert_almost_eq(_wrong().change, 2.5, 1e-15)
	assert_almost_eq(_wrong().distance_after(9.0), 375.0, 1e-9)
	assert_gt(_model.ball().end_speed, 199.0)


func test_without_the_spin_a_rolling_ball_is_too_fast() -> void:
	_switch_on(SlideAndRollMistakes.WITHOUT_SPIN)
	assert_almost_eq(_wrong().time_to(120.0), sqrt(2.0 / 3.0), 1e-15)
	assert_almost_eq(_lead(), 60.0, 1e-12)


func test_every_mistake_shows_as_soon_as_it_is_switched_on() -> void:
	for info: MistakeInfo in SlideAndRollMistakes.infos():
		_model = SlideAndRollModel.new()
		assert_no_refusal(_model.take({"friction": 0.25}))
		_switch_on(info.number)
		assert_true(_model.shows_mistake(), info.title)


func test_every_mistake_names_a_test_that_is_here() -> void:
	var names := get_method_list().map(func(method: Dictionary) -> String: return method["name"])
	for info: MistakeInfo in SlideAndRollMistakes.infos():
		assert_eq(info.test.get_slice(".", 0), "test_slide_and_roll_model")
		assert_has(names, info.test.get_slice(".", 1))


func test_where_a_ball_has_turned_to_fits_its_spin_at_every_moment() -> void:
	for preset: String in SlideAndRollModel.PRESETS:
		_take(preset)
		for ball: RacingBall in [_model.ball(), _model.sliding_ball(), _model.rolling_ball()]:
			for i in range(1, 40):
				var seconds := i / 40.0 * ball.end_time
				var step := 1e-6
				var turned := ball.turn_after(seconds + step) - ball.turn_after(seconds - step)
				var run := ball.after(seconds)
				if absf(seconds - ball.roll_time) > step and seconds + step < ball.end_time:
					assert_almost_eq(turned / (2.0 * step), run.spin, 1e-4, preset)


func test_the_exact_end_agrees_with_the_run_to_its_last_digits() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 18
	var rolled := 0
	for number: int in 300:
		var changes := {
			"end": PackedFloat64Array([rng.randf_range(20, 400), rng.randf_range(-36, 300)]),
			"friction": rng.randf_range(0, 0.6),
			"speed": maxf(0.0, rng.randf_range(-200, 300)),
			"gravity": rng.randf_range(50, 900),
		}
		assert_no_refusal(_model.take(changes))
		var ball := _model.ball()
		rolled += int(ball.roll_time >= 0.0)
		var error := absf(_model.error_of_end(ball.end_time, ball))
		assert_lt(error, 2e-14 * ball.end_time, "row %d" % number)
		# A time that is late is seen to be.
		var late := _model.error_of_end(ball.end_time + 0.25, ball)
		assert_almost_eq(late, 0.25, 1e-9, "row %d" % number)
	assert_between(rolled, 100, 290)


# The run of a mistake, step by step.
func test_a_wrong_run_moves_as_its_accelerations_say() -> void:
	for run: WrongRun in [
		WrongRun.that_rolls(90.0, 360.0, 240.0, 3.5),
		WrongRun.that_stops(300.0, 0.0, 120.0),
		WrongRun.new(50.0, 30.0, INF, 30.0)
	]:
		var step := 1e-4
		var way := 0.0
		var speed := run.first_speed
		for i: int in 20000:
			var acceleration := run.first if i * step < run.change else run.second
			way += (speed + 0.5 * acceleration * step) * step
			speed += acceleration * step
			if i % 1000 == 999:
				assert_almost_eq(run.distance_after((i + 1) * step), way, 0.1)
		var there := run.time_to(100.0)
		assert_almost_eq(run.distance_after(there), 100.0, 1e-9)


func test_what_cannot_be_taken_changes_nothing() -> void:
	var before := _model.to_dictionary()
	assert_string_contains(_model.enter("friction", -0.5), "µ must be within 0..10, not −0.5.")
	assert_string_contains(_model.enter("gravity", 0.0), "g must be within 0.001..1000000, not 0.")
	assert_string_contains(
		_model.enter("speed", -1.0), "v₀ must be 0, or within 0.001..1000000, not −1."
	)
	assert_string_contains(_model.enter("radius", 0.0), "r must be within 0.1..10000, not 0.")
	var climbs := "must lead at least 1 px to the right and not climb: from (−48, −36) to (48, −40)"
	assert_string_contains(_model.enter("By", -40.0), climbs)
	assert_string_contains(_model.enter("Bx", -48.0), "to (−48, 36) it does not.")
	assert_eq(_model.to_dictionary(), before)
	assert_no_refusal(_model.enter("By", -36.0))
	assert_eq(_model.height(), 0.0)


func _case() -> SlideAndRollModel.Case:
	return _model.run_case(_model.ball())


func _take(preset: String) -> void:
	assert_no_refusal(_model.take(SlideAndRollModel.PRESETS[preset]))


func _switch_on(number: int) -> void:
	assert_no_refusal(_model.take({"mistake": number}))


func _wrong() -> WrongRun:
	return BallRace.new(_model).wrong


func _lead() -> float:
	return BallRace.new(_model).lead_of_wrong()
