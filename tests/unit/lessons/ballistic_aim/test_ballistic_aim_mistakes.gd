extends LabTest
## The bug gallery of the lesson on aiming under gravity gives the wrong numbers of each mistake.


func test_the_sign_of_g_aims_below() -> void:
	var model := _model(BallisticAimMistakes.SIGN)
	assert_vec2(model.wrong_shot().direction, Vec2.new(0.8, 0.6), 1e-15)
	assert_between(model.wrong_shot().miss.distance, 145.0, 147.0)


func test_one_half_forgotten_finds_nothing() -> void:
	var model := _model(BallisticAimMistakes.HALF)
	assert_false(model.wrong_shot().hit)
	assert_true(model.mistake_shows())
	assert_almost_eq(BallisticAimMistakes.halved_time(model.shot().time), 0.5, 1e-15)
	assert_eq(model.fall_after(1.0), 150.0)
	model.speed = 400.0
	assert_true(model.wrong_shot().hit, "a faster bullet only flies too far")
	assert_gt(model.wrong_shot().miss.distance, 1.0)


func test_out_of_reach_is_told() -> void:
	var model := _model(BallisticAimMistakes.NOT_TESTED)
	assert_false(model.mistake_shows(), "it can be reached")
	model.speed = 240.0
	assert_true(model.mistake_shows())
	assert_false(model.wrong_shot().hit)


func test_a_falling_target_is_aimed_at_straight() -> void:
	var model := _model(BallisticAimMistakes.AT_REST)
	assert_false(model.mistake_shows(), "it rests")
	model.falls = true
	assert_vec2(model.wrong_shot().direction, Vec2.new(0.8, -0.6), 1e-15)
	assert_vec2(model.shot().direction, Vec2.new(1.0, 0.0), 1e-15)
	assert_gt(model.wrong_shot().miss.distance, 50.0)


func test_without_gravity_the_bullet_comes_too_low() -> void:
	var model := _model(BallisticAimMistakes.NO_GRAVITY)
	assert_vec2(model.wrong_shot().direction, Vec2.new(1.0, 0.0), 1e-15)
	assert_between(model.wrong_shot().miss.distance, 70.0, 96.0)
	model.falls = true
	assert_false(model.mistake_shows(), "straight is right for a target that falls")


func test_without_a_mistake_there_is_nothing_wrong() -> void:
	var model := _model(0)
	assert_false(model.wrong_shot().hit)
	assert_false(model.mistake_shows())


func test_each_names_the_test_that_catches_it() -> void:
	var methods := get_method_list().map(func(method: Dictionary) -> String: return method["name"])
	for info in BallisticAimMistakes.infos():
		assert_eq(info.test.get_slice(".", 0), "test_ballistic_aim_mistakes")
		assert_has(methods, info.test.get_slice(".", 1))


func _model(mistake: int) -> BallisticAimModel:
	var model := BallisticAimModel.new()
	model.mistake = mistake
	return model
