extends LabTest
## The bug gallery of the lesson on the moment to fire gives the wrong numbers of each mistake.


func test_fired_when_it_is_in_front_it_misses() -> void:
	var model := _model(TimedShotMistakes.IN_FRONT)
	assert_almost_eq(model.wrong_fire(), 3.0, 1e-12)
	assert_almost_eq(model.miss_at(model.wrong_fire()).distance, 89.4427191, 1e-6)
	assert_eq(model.take(TimedShotModel.PRESETS["Turning barrel"]), "")
	assert_true(model.mistake_shows())
	assert_gt(model.miss_at(model.wrong_fire()).distance, 10.0, "it points at the target itself")


func test_the_flight_is_taken_away() -> void:
	var model := _model(TimedShotMistakes.FLIGHT_ADDED)
	assert_almost_eq(model.wrong_fire(), 4.0, 1e-12)


func test_the_window_has_the_bullet_s_motion() -> void:
	var model := _model(TimedShotMistakes.BULLET_FORGOTTEN)
	assert_almost_eq(model.plain_half_window(), 0.1, 1e-15)
	assert_true(model.mistake_shows())
	assert_false(model.compares(TimedShotModel.Step.FIRE), "it is no other shot")
	model.bullet.set_xy(100.0, -200.0)
	assert_false(model.mistake_shows(), "beside the target the bullet does not move")


func test_without_a_shot_no_mistake_shows() -> void:
	var model := _model(TimedShotMistakes.IN_FRONT)
	model.velocity.set_xy(0.0, 0.0)
	assert_false(model.mistake_shows())
	assert_false(_model(0).mistake_shows())


func test_each_names_the_test_that_catches_it() -> void:
	var methods := get_method_list().map(func(method: Dictionary) -> String: return method["name"])
	for info in TimedShotMistakes.infos():
		assert_eq(info.test.get_slice(".", 0), "test_timed_shot_mistakes")
		assert_has(methods, info.test.get_slice(".", 1))


func _model(mistake: int) -> TimedShotModel:
	var model := TimedShotModel.new()
	model.mistake = mistake
	return model
