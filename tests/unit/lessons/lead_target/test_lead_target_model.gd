extends LabTest
## The lesson on leading a target: its cases, and by how much each mistake misses.

var _model: LeadTargetModel


func before_each() -> void:
	_model = LeadTargetModel.new()


func test_the_numbers_of_the_table() -> void:
	assert_vec2(_model.way(), Vec2.new(240, 0), 0.0)
	assert_almost_eq(_model.aim().time, 2.0, 1e-15)
	assert_vec2(_model.aim().direction, Vec2.new(0.8, 0.6), 1e-15)
	assert_almost_eq(_model.equation().other_root(), -2.0, 1e-15)
	assert_lt(LeadShots.new(_model).right.miss, 1e-12)


func test_aimed_at_where_it_is_now_misses_by_123() -> void:
	_switch_on(LeadTargetMistakes.AT_PRESENT)
	assert_vec2(_wrong().direction, Vec2.new(1, 0), 0.0)
	assert_almost_eq(_wrong().miss, 123.48, 0.01)


func test_one_step_of_lead_misses_by_24() -> void:
	_switch_on(LeadTargetMistakes.ONE_STEP)
	assert_vec2(_wrong().direction.scaled(280.0), Vec2.new(240, 144), 0.2)
	assert_almost_eq(_wrong().miss, 23.8, 0.05)


func test_the_root_below_zero_aims_at_the_past() -> void:
	_switch_on(LeadTargetMistakes.BELOW_ZERO)
	assert_vec2(_wrong().direction.scaled(300.0), Vec2.new(240, -180), 1e-12)
	assert_gt(_wrong().miss, 190.0)


func test_own_velocity_forgotten_or_taken_twice() -> void:
	_take("Moving shooter")
	assert_vec2(_model.aim().direction, Vec2.new(1, 0), 1e-15)
	_switch_on(LeadTargetMistakes.WITHOUT_OWN)
	assert_vec2(_wrong().direction, Vec2.new(0.8, 0.6), 1e-15)
	_switch_on(LeadTargetMistakes.OWN_TWICE)
	assert_vec2(_wrong().direction, Vec2.new(0.8, -0.6), 1e-15)
	assert_almost_eq(_wrong().miss, 144.0, 1e-9)


func test_every_mistake_shows_as_soon_as_it_is_switched_on() -> void:
	for info: MistakeInfo in LeadTargetMistakes.infos():
		_model = LeadTargetModel.new()
		_model.show_mistake(info.number)
		assert_true(_model.shows_mistake(), info.title)
		assert_gt(_wrong().miss, 20.0, info.title)


func test_every_mistake_names_a_test_that_is_here() -> void:
	var names := get_method_list().map(func(method: Dictionary) -> String: return method["name"])
	for info: MistakeInfo in LeadTargetMistakes.infos():
		assert_eq(info.test.get_slice(".", 0), "test_lead_target_model")
		assert_has(names, info.test.get_slice(".", 1))


func test_each_preset_is_its_case() -> void:
	var wanted: Dictionary[String, LeadTargetModel.Case] = {
		"Across": LeadTargetModel.Case.HITS,
		"Moving shooter": LeadTargetModel.Case.HITS,
		"Radius": LeadTargetModel.Case.HITS,
		"At rest": LeadTargetModel.Case.HITS,
		"Passes by": LeadTargetModel.Case.HITS_TWICE,
		"Gets away": LeadTargetModel.Case.GETS_AWAY,
		"Equal speeds": LeadTargetModel.Case.HITS,
		"Nearly equal": LeadTargetModel.Case.HITS,
	}
	assert_eq(wanted.keys(), LeadTargetModel.PRESETS.keys())
	for title in wanted:
		_take(title)
		assert_eq(_model.shot_case(), wanted[title], title)


func test_the_times_of_the_presets_are_short() -> void:
	_take("Radius")
	assert_almost_eq(_model.aim().time, 2.0, 1e-14)
	assert_vec2(_model.aim().direction, Vec2.new(0.8, 0.6), 1e-14)
	_take("Passes by")
	assert_almost_eq(_model.equation().times()[0], 0.8, 1e-14)
	assert_almost_eq(_model.equation().other_root(), 4.0, 1e-13)
	_take("Equal speeds")
	assert_eq(_model.aim().time, 1.0)
	assert_true(is_nan(_model.equation().other_root()))


func test_a_target_as_fast_as_the_bullet_that_flees_keeps_away() -> void:
	assert_no_refusal(_model.take({"velocity": [120.0, 90.0]}))
	assert_eq(_model.shot_case(), LeadTargetModel.Case.KEEPS_AWAY)
	assert_false(LeadShots.new(_model).right.is_fired())


func test_what_touches_from_the_start_is_hit_at_once() -> void:
	assert_no_refusal(_model.take({"radius": 240.0}))
	assert_eq(_model.shot_case(), LeadTargetModel.Case.TOUCHES)
	assert_eq(_model.aim().time, 0.0)
	assert_true(is_nan(_model.equation().other_root()))


func test_where_speeds_are_nearly_equal_the_slide_is_wrong_and_the_error_says_so() -> void:
	_take("Nearly equal")
	assert_lt(absf(_model.error_of_time(_model.aim().time)), 1e-15)
	assert_gt(absf(_model.error_of_time(_model.aim_by_the_slide().time)), 1e-6)


func test_a_large_radius_makes_a_wrong_shot_hit() -> void:
	assert_no_refusal(_model.take({"radius": 30.0}))
	_switch_on(LeadTargetMistakes.ONE_STEP)
	assert_true(_wrong().touches())


# The bullet flies in the event world: nothing nearer is found by looking at many moments.
func test_no_moment_is_nearer_than_the_one_that_is_shown() -> void:
	for preset: String in LeadTargetModel.PRESETS:
		_take(preset)
		for shot: LeadShot in [_wrong(), LeadShots.new(_model).at_present]:
			for i: int in 200 if shot.is_fired() else 0:
				assert_gte(shot.distance_after(0.05 * i), shot.miss - 1e-9, preset)


func test_rounding_moves_a_right_shot_by_less_than_its_condition_says() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 7
	for i: int in 200:
		var v := Vec2.random_unit(rng).scaled(rng.randf_range(0, 140))
		var u := Vec2.random_unit(rng).scaled(rng.randf_range(0, 100))
		var moving := {"velocity": [v.x, v.y], "own": [u.x, u.y], "radius": rng.randf_range(0, 50)}
		assert_no_refusal(_model.take(moving))
		var right := LeadShots.new(_model).right
		if right.is_right:
			assert_lte(right.miss, right.from_rounding(), "shot %d" % i)


func test_a_hit_that_is_too_late_is_not_flown() -> void:
	assert_no_refusal(_model.take({"velocity": [1e6 - 1e-4, 0.0], "speed": 1e6}))
	assert_true(_model.can_hit())
	assert_false(_model.can_fly())
	assert_false(LeadShots.new(_model).right.is_right)


func test_what_cannot_be_taken_changes_nothing() -> void:
	var before := _model.to_dictionary()
	assert_string_contains(_model.enter("speed", 0.0), "s must be within 0.001..1000000, not 0.")
	assert_string_contains(_model.enter("radius", -1.0), "R must be within 0..1000000, not −1.")
	assert_string_contains(_model.enter("vx", 2e6), "velocity must be within")
	assert_eq(_model.to_dictionary(), before)
	assert_no_refusal(_model.enter("Tx", 5.0))
	assert_eq(_model.target.x, 5.0)


func _take(preset: String) -> void:
	assert_no_refusal(_model.take(LeadTargetModel.PRESETS[preset]))


func _switch_on(number: int) -> void:
	assert_no_refusal(_model.take({"mistake": number}))


func _wrong() -> LeadShot:
	return LeadShots.new(_model).wrong
