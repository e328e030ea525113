extends LabTest
## The model of the game: turning, firing, hitting, and what a link holds.

var _model: AimingGameModel


func before_each() -> void:
	_model = AimingGameModel.new()


func test_the_barrel_turns_to_a_point_by_hand() -> void:
	_model.aim_at(_model.level().gun.plus(Vec2.new(0, -10)))
	assert_almost_eq(_model.hand_degrees, -90.0, 1e-9)
	assert_vec2(_model.barrel(), Vec2.new(0, -1), 1e-12)
	_model.aim_at(_model.level().gun)
	assert_almost_eq(_model.hand_degrees, -90.0, 1e-9, "the gun itself is no direction")


func test_a_drag_switches_the_barrel_of_the_helper_off() -> void:
	_model.aims = true
	_model.aim_at(Vec2.new(200, 100))
	assert_false(_model.aims)


func test_a_shot_by_hand_hits_and_ends_the_level() -> void:
	_model.aim_at(_model.target_place())
	assert_true(_model.fire())
	assert_false(_model.fire(), "one bullet at a time")
	_let_pass(3.0)
	assert_true(_model.is_won())
	assert_null(_model.shot)
	assert_false(_model.fire(), "the level is won")
	assert_eq(_model.all_shots(), 1)
	var there := _model.target_place()
	_let_pass(1.0)
	assert_vec2(_model.target_place(), there, 0.0)


func test_a_miss_is_counted_and_told() -> void:
	_model.aim_at(Vec2.new(390, 240))
	assert_true(_model.fire())
	_let_pass(3.0)
	assert_false(_model.is_won())
	assert_almost_eq(_model.missed.nearest, 150.0, 0.01)
	assert_eq(_model.shots_in[1], 1)


func test_with_aim_on_the_barrel_turns_by_itself_and_hits() -> void:
	_model.aims = true
	_let_pass(1.0)
	var wanted := _model.target_place().minus(_model.level().gun).normalized()
	assert_vec2(_model.barrel(), wanted, 1e-3)
	assert_true(_model.fire())
	_let_pass(3.0)
	assert_true(_model.is_won())


func test_after_the_last_level_comes_the_first() -> void:
	for number: int in _model.level_count():
		assert_eq(_model.level_number, number + 1)
		_model.go_on()
	assert_eq(_model.level_number, 1)


func test_levels_that_were_hit_are_passed_over_until_all_are() -> void:
	for number: int in [2, 3]:
		_model.levels_hit[number] = true
	_model.go_on()
	assert_eq(_model.level_number, 4)
	for number: int in _model.level_count():
		_model.levels_hit[number + 1] = true
	_model.shots_in[4] = 3
	assert_true(_model.is_complete())
	_model.go_on()
	assert_eq(_model.level_number, 1)
	assert_eq(_model.all_shots(), 0, "the score begins anew")


func test_the_barrel_of_the_start_hits_nothing() -> void:
	for number: int in _model.level_count():
		assert_no_refusal(_model.take({level = number + 1}))
		assert_true(_model.fire())
		assert_eq(_model.shot.hit_after, INF, "level %d" % (number + 1))


func test_the_plan_stays_while_a_bullet_flies() -> void:
	assert_no_refusal(_model.take({level = 7, aims = true, leads = true, bounces = true}))
	_let_pass(0.5)
	assert_true(_model.fire())
	var plan := _model.plan()
	_let_pass(0.3)
	assert_same(_model.plan(), plan)


func test_after_a_hit_the_barrel_stays() -> void:
	_model.aim_at(_model.target_place())
	assert_true(_model.fire())
	_let_pass(3.0)
	var angle := _model.hand_degrees
	_model.aim_at(Vec2.new(50, 0))
	assert_eq(_model.hand_degrees, angle)


func test_a_link_names_level_angle_and_helpers() -> void:
	assert_no_refusal(_model.take({level = 3, falls = true}))
	assert_eq(_model.level_number, 3)
	assert_string_contains(_model.take({level = 8}), "level must be within 1..7, not 8.")
	assert_string_contains(_model.take({angle = 200.0}), "angle must be within")
	assert_eq(_model.level_number, 3)


func test_the_plan_is_not_made_anew_in_each_frame() -> void:
	_model.aims = true
	var plan := _model.plan()
	_model.time += 0.05
	assert_same(_model.plan(), plan)
	_model.time += 0.1
	assert_not_same(_model.plan(), plan)


func _let_pass(seconds: float) -> void:
	for frame: int in roundi(seconds * 60.0):
		_model.advance(1.0 / 60.0)
