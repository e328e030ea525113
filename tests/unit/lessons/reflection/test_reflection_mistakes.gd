extends LabTest
## The bug gallery of the lesson on reflection gives the wrong numbers that students get.


func test_mistake_11_subtracts_far_too_much() -> void:
	assert_vec2(_wrong(11), Vec2.new(3, -28), 0.0)


func test_mistake_12_turns_the_ball_back_on_its_way() -> void:
	assert_vec2(_wrong(12), Vec2.new(-3, 4), 0.0)


func test_mistake_13_brakes_along_the_line() -> void:
	assert_vec2(_wrong(13, 0.5), Vec2.new(1.5, -4), 0.0)


func test_mistake_14_sends_the_ball_back_in() -> void:
	assert_vec2(_wrong(14), Vec2.new(3, 4), 0.0)


func test_without_a_mistake_there_is_nothing_wrong() -> void:
	assert_vec2(_wrong(0), Vec2.new(3, 4), 0.0)


func test_the_ball_of_mistake_14_sticks_to_the_line() -> void:
	var model := ReflectionModel.new()
	model.mistake = 14
	for frame: int in 60:
		model.time = (frame + 0.5) / 60.0
		var centre := model.ball_centre_with_mistake(0.5)
		assert_almost_eq(centre.x, 3.0 * model.time, 1e-12)
		assert_almost_eq(centre.y, -0.5 - 2.0 / 60.0, 1e-12, "half a frame of 4 units a second")


func test_the_balls_of_the_other_mistakes_fly_straight() -> void:
	var model := ReflectionModel.new()
	model.mistake = 12
	model.time = 1.0
	assert_vec2(model.ball_centre_with_mistake(0.5), Vec2.new(-3, 3.5), 0.0)
	model.time = -1.0
	assert_vec2(model.ball_centre_with_mistake(0.5), Vec2.new(-3, -4.5), 0.0)


func test_each_mistake_names_a_test_that_exists() -> void:
	for info: MistakeInfo in ReflectionMistakes.infos():
		var parts := info.test.split(".")
		var script: Script = load("res://tests/unit/collision/%s.gd" % parts[0])
		var names: Array = script.get_script_method_list().map(
			func(method: Dictionary) -> String: return method["name"]
		)
		assert_has(names, parts[1])


func _wrong(mistake: int, bounciness: float = 1.0) -> Vec2:
	var model := ReflectionModel.new()
	model.mistake = mistake
	model.bounciness = bounciness
	return model.velocity_with_mistake()
