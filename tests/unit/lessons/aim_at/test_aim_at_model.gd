extends LabTest
## The lesson on aiming at a target: angles that are nested, the short way, and by how much each
## mistake misses.

var _model: AimAtModel


func before_each() -> void:
	_model = AimAtModel.new()


func test_the_numbers_of_the_table() -> void:
	assert_almost_eq(_model.target_degrees(), 90.0, 1e-12)
	assert_almost_eq(_model.wanted_degrees(), 60.0, 1e-12)
	assert_almost_eq(_model.turn_degrees(), 60.0, 1e-12)


func test_the_barrel_turns_with_its_hull() -> void:
	_change({"hull_degrees": 170.0, "barrel_degrees": 20.0})
	assert_eq(_model.current_degrees(), -170.0)
	assert_vec2(_model.nozzle_at(90.0), Vec2.new(-80, -20), 1e-13)


func test_a_barrel_that_is_not_reduced_is_off_by_the_hull() -> void:
	_change({"mistake": AimAtMistakes.NOT_REDUCED})
	assert_almost_eq(AimAtModel.short(_model.wrong_degrees()), 120.0, 1e-12)
	assert_almost_eq(_shots().wrong.miss, 180.0 * sin(PI / 6.0), 1e-9)


func test_degrees_for_radians() -> void:
	_change({"mistake": AimAtMistakes.DEGREES})
	# 60 rad are 9 turns and 197.7°.
	assert_almost_eq(AimAtModel.short(_model.wrong_degrees() - 30.0), 197.747 - 360.0, 1e-3)
	assert_gt(_shots().wrong.miss, 100.0)


func test_atan2_with_its_arguments_swapped() -> void:
	_change({"mistake": AimAtMistakes.SWAPPED})
	assert_eq(_model.wrong_degrees(), 0.0)


func test_the_long_way_round() -> void:
	_take("Over 180°")
	assert_almost_eq(_model.turn_degrees(), 90.0, 1e-9)
	_change({"mistake": AimAtMistakes.LONG_WAY})
	assert_almost_eq(_model.wrong_turn_degrees(), -270.0, 1e-9)


func test_every_mistake_shows_as_soon_as_it_is_switched_on() -> void:
	for info: MistakeInfo in AimAtMistakes.infos():
		_model = AimAtModel.new()
		_model.show_mistake(info.number)
		assert_true(_model.shows_mistake(), info.title)


func test_every_mistake_names_a_test_that_is_here() -> void:
	var names := get_method_list().map(func(method: Dictionary) -> String: return method["name"])
	for info: MistakeInfo in AimAtMistakes.infos():
		assert_eq(info.test.get_slice(".", 0), "test_aim_at_model")
		assert_has(names, info.test.get_slice(".", 1))


func test_half_of_the_turn_is_done_in_each_half_life() -> void:
	assert_almost_eq(_model.left_degrees(0.2), 30.0, 1e-12)
	assert_almost_eq(_model.left_degrees(0.6), 7.5, 1e-12)
	assert_almost_eq(_model.degrees_after(0.6), 82.5, 1e-12)


func test_what_fires_too_early_misses_and_from_the_least_wait_on_it_hits() -> void:
	assert_almost_eq(_shots().early.miss, 180.0 * sin(Vec2.deg_to_rad(7.5)), 1e-9)
	assert_false(_shots().early.hits())
	var wait := _model.least_wait()
	_change({"fire": wait * 1.001})
	assert_true(_shots().early.hits())
	_change({"fire": wait * 0.999})
	assert_false(_shots().early.hits())


func test_an_aligned_barrel_waits_for_nothing() -> void:
	_change({"barrel_degrees": 60.0})
	assert_eq(_model.least_wait(), 0.0)
	_change({"radius": 0.0, "barrel_degrees": 0.0})
	assert_eq(_model.least_wait(), INF)


func test_a_target_nearer_than_the_nozzle_is_not_hit() -> void:
	_take("Too near")
	assert_eq(_model.shot_case(), AimAtModel.Case.TOO_NEAR)
	assert_true(is_nan(_model.least_wait()))
	assert_eq(_shots().right.moment, 0.0)


func test_without_a_direction_there_is_no_mistake() -> void:
	_change({"target": [-80.0, -70.0], "mistake": AimAtMistakes.SWAPPED})
	assert_eq(_model.shot_case(), AimAtModel.Case.NO_DIRECTION)
	assert_false(_model.shows_mistake())


func test_rounding_moves_a_right_shot_by_less_than_its_condition_says() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 3
	var hits := 0
	for i: int in 300:
		var at := [rng.randf_range(-300, 300), rng.randf_range(-300, 300)]
		_change({"target": at, "length": rng.randf_range(1, 100)})
		if _model.shot_case() == AimAtModel.Case.HITS:
			hits += 1
			assert_lte(_shots().right.miss, _shots().right.from_rounding(), "shot %d" % i)
	assert_gt(hits, 200)


func test_the_sprite_turns_with_the_velocity() -> void:
	_change({"hull_degrees": 0.0})
	assert_vec2(_shots().falling_velocity(0.5), Vec2.new(200, 100), 1e-12)
	assert_vec2(_shots().falling_place(0.5), Vec2.new(70, -45), 1e-9)


func test_what_cannot_be_taken_changes_nothing() -> void:
	var before := _model.to_dictionary()
	assert_string_contains(
		_model.enter("length", 0.0), "length must be within 0.001..10000, not 0."
	)
	assert_string_contains(_model.enter("half_life", -1.0), "half_life must be within")
	assert_string_contains(_model.enter("Px", 2e6), "hull must be within")
	assert_eq(_model.to_dictionary(), before)


func test_typed_angles_come_within_half_a_turn() -> void:
	assert_no_refusal(_model.enter("hull_degrees", 330.0))
	assert_eq(_model.hull_degrees, -30.0)
	assert_no_refusal(_model.enter("barrel_degrees", -180.0))
	assert_eq(_model.barrel_degrees, 180.0)


func _take(preset: String) -> void:
	assert_no_refusal(_model.take(AimAtModel.PRESETS[preset]))


func _change(changes: Dictionary) -> void:
	assert_no_refusal(_model.take(changes))


func _shots() -> AimShots:
	return AimShots.new(_model)
