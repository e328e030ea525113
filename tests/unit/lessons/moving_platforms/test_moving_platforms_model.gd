extends LabTest
## The lesson on surfaces that move: what comes out of each kind, and the flight beside it.

const _RANDOM := 150
# A miss is not more than so many times what rounding alone may make of it.
const _MOST_ROUNDINGS := 8.0

var _model: MovingPlatformsModel


func before_each() -> void:
	_model = MovingPlatformsModel.new()


func test_minus_200_against_plus_100_leaves_with_400() -> void:
	_take("Head-on")
	assert_eq(_model.impact().time, 1.0)
	assert_vec2(_model.impact().seen, Vec2.new(-300, 0), 0.0)
	assert_vec2(_model.impact().bounced, Vec2.new(300, 0), 0.0)
	assert_vec2(_model.impact().leaving, Vec2.new(400, 0), 0.0)
	_take("C = 0.5")
	assert_vec2(_model.impact().leaving, Vec2.new(250, 0), 0.0)


func test_a_ball_is_hit_from_behind() -> void:
	_take("From behind")
	assert_almost_eq(_model.impact().time, 0.5, 1e-15)
	assert_vec2(_model.impact().leaving, Vec2.new(500, 50), 1e-12)


func test_a_wall_that_moves_along_itself_changes_nothing() -> void:
	assert_no_refusal(_model.take({"surface_velocity": PackedFloat64Array([0, 70])}))
	assert_vec2(_model.impact().leaving, Vec2.new(200, 100), 1e-12)


func test_a_disc_on_a_belt_of_90_rolls_with_30() -> void:
	_kind(MovingSurface.Kind.BELT)
	var run := _model.run()
	assert_eq(run.slip, -90.0)
	assert_eq(run.run_case, CarriedRun.Case.ROLLS_LATER)
	assert_almost_eq(run.roll_time, 1.0, 1e-15)
	assert_almost_eq(_model.rolling_speed(), 30.0, 1e-13)
	# On the belt it rolls backwards, so that its lowest point goes with the belt.
	assert_almost_eq(run.after(2.0).spin, -60.0 / MovingSurface.RADIUS, 1e-13)


func test_each_case_of_a_disc_on_a_belt() -> void:
	_kind(MovingSurface.Kind.BELT)
	var wanted: Dictionary[CarriedRun.Case, Dictionary] = {
		CarriedRun.Case.ROLLS: {"surface_speed": 0.0},
		CarriedRun.Case.ROLLS_LATER: {"surface_speed": 90.0},
		CarriedRun.Case.ENDS_BEFORE: {"speed": 900.0},
		CarriedRun.Case.SLIPS: {"speed": 0.0, "friction": 0.0},
	}
	for case in wanted:
		assert_no_refusal(_model.take(wanted[case]))
		assert_eq(_model.run().run_case, case, str(wanted[case]))


func test_uphill_it_rolls_with_60_and_then_back() -> void:
	_take("Uphill")
	var run := _model.run()
	assert_almost_eq(run.pull(), -168.0, 1e-12)
	assert_almost_eq(run.roll_time, 0.5, 1e-14)
	assert_almost_eq(_model.rolling_speed(), 60.0, 1e-11)
	# Two thirds of the pull move it, however fast the belt runs.
	assert_almost_eq(run.after(1.5).speed, 60.0 - 112.0, 1e-11)


func test_a_platform_carries_exactly_and_turns_back_below_the_disc() -> void:
	_kind(MovingSurface.Kind.PLATFORM)
	assert_eq(_model.turn_time(), 2.0)
	for seconds: float in [0.0, 0.3, 1.0, 1.999]:
		var start := _model.place_at(0.0)
		assert_vec2(_model.place_at(seconds), start.plus(Vec2.new(90 * seconds, 0)), 1e-12)
	assert_eq(_model.run().slip, 180.0)
	assert_almost_eq(_model.run().roll_time, 0.5, 1e-15)
	assert_almost_eq(_model.rolling_speed(), 30.0, 1e-13)


func test_the_touched_point_of_a_paddle_moves_with_omega_times_the_arm() -> void:
	_kind(MovingSurface.Kind.PADDLE)
	var met := _model.impact()
	assert_almost_eq(met.time, acos(-0.6) / 2.0, 1e-14)
	assert_vec2(met.arm, Vec2.new(0, -100), 1e-11)
	assert_vec2(met.touched, Vec2.new(200, 0), 1e-11)
	assert_vec2(met.leaving, Vec2.new(600, 100), 1e-10)


func test_the_press_is_that_of_the_table() -> void:
	_kind(MovingSurface.Kind.PRESS)
	for bounce: int in 12:
		var left := 200.0 / (bounce + 1.0)
		assert_almost_eq(_model.press_time(bounce), (200.0 - left) / 100.0, 1e-14)
	assert_eq(_model.crush_time(), 2.0)
	assert_vec2(_model.impact().leaving, Vec2.new(500, 0), 0.0)
	assert_vec2(_model.place_at(1.0), Vec2.new(0, 0), 1e-12)


# The frame of reference does not matter: with the same velocity on top of both, all velocities get
# it, and the ball leaves as before, seen from the wall.
func test_the_same_impact_in_another_frame_of_reference() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 21
	var met := 0
	for number: int in _RANDOM:
		_take_random_wall(rng)
		var first := _model.impact()
		var more := Vec2.new(rng.randf_range(-300, 300), rng.randf_range(-300, 300))
		var velocity := _model.velocity.plus(more)
		var wall := _model.surface_velocity.plus(more)
		var changes := {"velocity": _pair(velocity), "surface_velocity": _pair(wall)}
		assert_no_refusal(_model.take(changes))
		var second := _model.impact()
		assert_eq(second.hit, first.hit)
		if first.hit:
			met += 1
			assert_almost_eq(second.time, first.time, 1e-9 * (1.0 + first.time))
			assert_vec2(second.bounced, first.bounced, 1e-6)
			assert_vec2(second.leaving, first.leaving.plus(more), 1e-6)
	assert_gt(4 * met, 3 * _RANDOM)


func test_the_flight_is_where_the_formulas_have_it() -> void:
	for state: Dictionary in _all_presets():
		assert_no_refusal(_model.take(state))
		var flight := PlatformFlight.new(_model)
		assert_lt(flight.miss(), _MOST_ROUNDINGS * flight.rounding(), str(state))
		assert_gt(flight.rounding(), 0.0)
		var last := flight.end(MovingPlatformsModel.Step.FLY)
		# A press only as far as its bounces can be told from each other.
		last *= 0.9 if _model.kind == MovingSurface.Kind.PRESS else 1.0
		for i: int in 20:
			var seconds := last * i / 20.0
			assert_vec2(flight.ball_at(seconds), _model.place_at(seconds), 1e-10, str(state))
		# Back again: the world starts anew.
		assert_vec2(flight.ball_at(0.0), _model.place_at(0.0), 0.0)


func test_random_flights_are_where_the_formulas_have_them() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 5
	for number: int in _RANDOM:
		_take_random_wall(rng)
		_assert_flies_true()
		_kind(MovingSurface.Kind.BELT)
		var changes := {
			"speed": rng.randf_range(-200, 200),
			"surface_speed": rng.randf_range(-300, 300),
			"friction": rng.randf_range(0.02, 1.0),
		}
		assert_no_refusal(_model.take(changes))
		_assert_flies_true()
		_kind(MovingSurface.Kind.PRESS)
		var wall := rng.randf_range(5, 200)
		changes = {"surface_speed": wall, "speed": wall * rng.randf_range(1.2, 6.0)}
		assert_no_refusal(_model.take(changes))
		_assert_flies_true()


func test_a_crushed_ball_is_told_and_stays() -> void:
	_kind(MovingSurface.Kind.PRESS)
	var flight := PlatformFlight.new(_model)
	assert_eq(flight.end(MovingPlatformsModel.Step.FLY), 2.0)
	assert_false(flight.is_crushed(1.999))
	assert_true(flight.is_crushed(2.0))
	assert_vec2(flight.ball_at(2.0), Vec2.new(100, 0), 1e-9)


func test_the_surface_rests_where_everything_is_seen_from_it() -> void:
	for state: Dictionary in MovingPlatformsPresets.OF_KIND:
		assert_no_refusal(_model.take(state))
		var flight := PlatformFlight.new(_model)
		var seconds := 0.7 * flight.end(MovingPlatformsModel.Step.FLY)
		var there := flight.surface_at(seconds)
		assert_no_refusal(_model.take({"from_surface": true}))
		if _model.kind != MovingSurface.Kind.BELT:
			var seen := flight.seen(there.end, seconds)
			assert_vec2(seen, _model.first_surface().end, 1e-9, str(state))
		else:
			# Its ends stay, so a point of it that was at its start is seen there.
			var point := there.start.plus(Vec2.new(90 * seconds, 0))
			assert_vec2(flight.seen(point, seconds), there.start, 1e-9)
		assert_no_refusal(_model.take({"from_surface": false}))


func test_nothing_of_the_answer_is_played_before_it() -> void:
	for state: Dictionary in MovingPlatformsPresets.OF_KIND:
		assert_no_refusal(_model.take(state))
		var flight := PlatformFlight.new(_model)
		var first := flight.end(MovingPlatformsModel.Step.LAW)
		assert_lt(first, flight.end(MovingPlatformsModel.Step.BACK))
		if _model.impact():
			assert_almost_eq(first, _model.impact().time, 1e-15)


func test_what_cannot_be_taken_changes_nothing() -> void:
	var before := _model.to_dictionary()
	assert_string_contains(_model.enter("bounciness", 1.5), "C must be within 0..1, not 1.5.")
	assert_string_contains(_model.enter("turning", 21.0), "ω must be within −20..20, not 21.")
	assert_string_contains(_model.enter("px", -110.0), "more than 20 px from the surface, not 10.")
	assert_string_contains(
		_model.take({"surface": PackedFloat64Array([0, 0, 30, 0])}), "at least 40 px long, not 30."
	)
	assert_eq(_model.to_dictionary(), before)
	_kind(MovingSurface.Kind.BELT)
	assert_string_contains(_model.enter("bx", -190.0), "at least 40 px to the right, not 10.")
	_kind(MovingSurface.Kind.PRESS)
	assert_string_contains(
		_model.enter("speed", 100.5), "faster than the wall with 100, not 100.5."
	)
	assert_string_contains(_model.enter("surface_speed", 0.0), "V must be within 1..10000, not 0.")
	assert_no_refusal(_model.enter("way", 300.0))
	assert_eq(_model.crush_time(), 3.0)


func _assert_flies_true() -> void:
	var flight := PlatformFlight.new(_model)
	var limit := _MOST_ROUNDINGS * flight.rounding()
	assert_lte(flight.miss(), limit, str(_model.to_dictionary()))


# A ball that flies towards a point near the wall, which moves.
func _take_random_wall(rng: RandomNumberGenerator) -> void:
	var changes: Dictionary
	while true:
		var ball := Vec2.new(rng.randf_range(-250, 250), rng.randf_range(-250, 250))
		var surface := _random_pair(rng, 200) + _random_pair(rng, 200)
		var start := Vec2.new(surface[0], surface[1])
		var aim := start.lerped(Vec2.new(surface[2], surface[3]), rng.randf_range(-0.1, 1.1))
		var wall := Vec2.new(rng.randf_range(-200, 200), rng.randf_range(-200, 200))
		var velocity := aim.minus(ball).scaled(rng.randf_range(0.3, 2.0)).plus(wall)
		changes = {
			"kind": 0,
			"ball": _pair(ball),
			"velocity": _pair(velocity),
			"surface": surface,
			"surface_velocity": _pair(wall),
			"bounciness": rng.randf(),
		}
		if not _model.take(changes):
			return


static func _random_pair(rng: RandomNumberGenerator, size: float) -> PackedFloat64Array:
	return [rng.randf_range(-size, size), rng.randf_range(-size, size)]


static func _pair(vector: Vec2) -> PackedFloat64Array:
	return [vector.x, vector.y]


func _all_presets() -> Array[Dictionary]:
	return MovingPlatformsPresets.OF_KIND + MovingPlatformsPresets.ALL.values()


func _take(preset: String) -> void:
	assert_no_refusal(_model.take(MovingPlatformsPresets.ALL[preset]))


func _kind(kind: MovingSurface.Kind) -> void:
	assert_no_refusal(_model.take(MovingPlatformsPresets.OF_KIND[kind]))
