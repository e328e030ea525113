extends LabTest
## The bug gallery of the lesson on surfaces that move gives the wrong numbers of each mistake.

var _model: MovingPlatformsModel


func before_each() -> void:
	_model = MovingPlatformsModel.new()


func test_a_wall_that_comes_makes_the_ball_faster() -> void:
	_switch_on(MovingPlatformsMistakes.IGNORED, "Head-on")
	assert_vec2(_model.wrong_velocity(), Vec2.new(200, 0), 0.0)
	assert_gt(_model.impact().leaving.x, 399.0)
	_kind(MovingSurface.Kind.PRESS)
	assert_eq(_model.wrong_speed(), 300.0)


func test_what_is_added_after_is_subtracted_before() -> void:
	_switch_on(MovingPlatformsMistakes.ADDED_ONCE, "Head-on")
	assert_vec2(_model.wrong_velocity(), Vec2.new(300, 0), 0.0)
	_switch_on(MovingPlatformsMistakes.ADDED_ONCE, "C = 0.5")
	assert_vec2(_model.wrong_velocity(), Vec2.new(200, 0), 0.0)
	_kind(MovingSurface.Kind.PRESS)
	assert_eq(_model.wrong_speed(), 600.0)


func test_a_soft_ball_gets_less_than_twice_the_wall() -> void:
	_switch_on(MovingPlatformsMistakes.ADDED_TWICE, "C = 0.5")
	assert_vec2(_model.wrong_velocity(), Vec2.new(300, 0), 0.0)
	assert_true(_model.mistake_shows())
	_switch_on(0, "Head-on")
	_model.mistake = MovingPlatformsMistakes.ADDED_TWICE
	assert_false(_model.mistake_shows(), "for C = 1 it is right")


func test_the_touched_point_counts_not_the_tip() -> void:
	_kind(MovingSurface.Kind.PADDLE)
	_model.mistake = MovingPlatformsMistakes.TIP
	# The tip is 150 px from the pivot, the touched point 100.
	assert_vec2(_model.wrong_velocity(), Vec2.new(800, 100), 1e-9)


func test_a_disc_on_a_belt_ends_at_a_third_of_its_speed() -> void:
	_kind(MovingSurface.Kind.BELT)
	_model.mistake = MovingPlatformsMistakes.BELT_SPEED
	assert_eq(_model.wrong_speed(), 90.0)
	assert_true(_model.mistake_shows())
	_kind(MovingSurface.Kind.PLATFORM)
	assert_eq(_model.wrong_speed(), -90.0)


func test_a_ball_that_is_carried_is_not_a_frame_late() -> void:
	_kind(MovingSurface.Kind.PLATFORM)
	_model.mistake = MovingPlatformsMistakes.FRAME_LATE
	assert_true(_model.mistake_shows())
	var late := _model.place_at(1.0 - MovingPlatformsMistakes.FRAME)
	assert_almost_eq(_model.place_at(1.0).distance_to(late), 1.5, 1e-12)


func test_every_mistake_shows_as_soon_as_it_is_switched_on() -> void:
	for info in MovingPlatformsMistakes.infos():
		for kind: MovingSurface.Kind in MovingSurface.Kind.values():
			_kind(kind)
			assert_no_refusal(_model.take({"mistake": info.number}))
			assert_true(_model.mistake_shows(), "%s %s" % [kind, info.title])


func test_each_names_the_test_that_catches_it() -> void:
	var methods := get_method_list().map(func(method: Dictionary) -> String: return method["name"])
	for info in MovingPlatformsMistakes.infos():
		assert_eq(info.test.get_slice(".", 0), "test_moving_platforms_mistakes")
		assert_has(methods, info.test.get_slice(".", 1))


func _switch_on(mistake: int, preset: String) -> void:
	assert_no_refusal(_model.take(MovingPlatformsPresets.ALL[preset]))
	_model.mistake = mistake


func _kind(kind: MovingSurface.Kind) -> void:
	assert_no_refusal(_model.take(MovingPlatformsPresets.OF_KIND[kind]))
