extends LabTest
## The model of the lesson on balls that meet: its mistakes, its refusals, its drags.

var _model: NewtonBallsModel


func before_each() -> void:
	_model = NewtonBallsModel.new()


func test_masses_ignored_gives_minus_6() -> void:
	_assert_wrong(NewtonBallsMistakes.AS_OFF_A_WALL, Vec2.new(-6.0, 0.0), Vec2.new())
	_assert_loses_momentum(NewtonBallsMistakes.AS_OFF_A_WALL)


func test_exchanged_velocities_need_equal_masses() -> void:
	_assert_wrong(NewtonBallsMistakes.SWAPPED, Vec2.new(), Vec2.new(6.0, 0.0))
	_assert_loses_momentum(NewtonBallsMistakes.SWAPPED)
	_take("Equal masses")
	_model.mistake = NewtonBallsMistakes.SWAPPED
	assert_false(_model.mistake_shows(_model.run().meeting))


func test_c_on_all_loses_momentum() -> void:
	_take("C = 0.5")
	_assert_wrong(NewtonBallsMistakes.C_ON_ALL, Vec2.new(-1.0, 0.0), Vec2.new(2.0, 0.0))
	_assert_loses_momentum(NewtonBallsMistakes.C_ON_ALL)


func test_the_whole_velocity_turns_the_part_across() -> void:
	_take("Oblique")
	var meeting := _model.run().meeting
	var wrong := NewtonBallsMistakes.velocities_after(NewtonBallsMistakes.WHOLE_VELOCITY, meeting)
	assert_vec2(wrong[0], Vec2.new(), 1e-12)
	assert_vec2(meeting.momentum_of(wrong), meeting.momentum(), 1e-12)
	assert_vec2(meeting.velocities_after()[0], Vec2.new(1.8, -2.4), 1e-12)


func test_own_shares_give_2_and_8() -> void:
	_assert_wrong(NewtonBallsMistakes.OWN_SHARE, Vec2.new(2.0, 0.0), Vec2.new(8.0, 0.0))
	_assert_loses_momentum(NewtonBallsMistakes.OWN_SHARE)


func test_already_changed_gives_minus_4_thirds() -> void:
	var number := NewtonBallsMistakes.ALREADY_CHANGED
	_assert_wrong(number, Vec2.new(-2.0, 0.0), Vec2.new(-4.0 / 3.0, 0.0))
	_assert_loses_momentum(number)


func test_a_mistake_that_changes_nothing_shows_a_preset_in_which_it_does() -> void:
	for info in NewtonBallsMistakes.infos():
		for preset: String in NewtonBallsPresets.all():
			_take(preset)
			_model.show_mistake(info.number)
			assert_true(_model.mistake_shows(_model.run().meeting), "%s, %s" % [info.title, preset])


func test_newton_off_is_the_mistake_of_the_ignored_masses() -> void:
	_model.has_newton = false
	assert_eq(_model.shown_mistake(), NewtonBallsMistakes.AS_OFF_A_WALL)
	_model.mistake = NewtonBallsMistakes.SWAPPED
	assert_eq(_model.shown_mistake(), NewtonBallsMistakes.SWAPPED)


func test_what_cannot_be_is_refused() -> void:
	assert_eq(_problem(_two(0.0, 1.5)), "Ball 1 and ball 2 must not overlap.")
	assert_eq(_problem(_two(0.0, 200.0)).left(30), "place and velocity of ball 2 m")
	var heavy := _two(-5.0, 5.0)
	heavy[1][4] = 0.0
	assert_string_starts_with(_problem(heavy), "m of ball 2 must be within 0.01..100, not 0.")
	var one: Array[PackedFloat64Array] = [_two(0.0, 5.0)[0]]
	assert_eq(_problem(one), "There must be 2 to 50 balls, not 1.")
	assert_eq(_model.take({"bounciness": 1.5}), "C must be within 0..1, not 1.5.")
	_model.has_box = true
	assert_eq(_problem(_two(-5.0, 11.5)), "Ball 2 must be in the box.")
	assert_eq(_model.balls.size(), 2)


func test_a_dragged_ball_stops_where_it_touches() -> void:
	assert_no_refusal(_model.move_ball(0, Vec2.new(1.5, -2.0)))
	assert_almost_eq(_model.balls[0][0], 2.0 - 1.0 - sqrt(2.0), 1e-4)
	_take("Rack")
	assert_no_refusal(_model.move_ball(0, Vec2.new(-50.0, 0.0)))
	assert_eq(_model.balls[0][0], -11.5)


func test_a_typed_number_belongs_to_ball_1_or_2() -> void:
	assert_no_refusal(_model.enter_of_pair("m2", 3.0, 0, 1))
	assert_no_refusal(_model.enter_of_pair("vx1", 4.0, 0, 1))
	assert_no_refusal(_model.enter_of_pair("vy2", -1.0, 0, 1))
	assert_no_refusal(_model.enter_of_pair("C", 0.25, 0, 1))
	assert_eq(_model.balls[1], PackedFloat64Array([2, -2, 0, -1, 3]))
	assert_eq(_model.balls[0][2], 4.0)
	assert_eq(_model.bounciness, 0.25)
	assert_ne(_model.enter_of_pair("m1", 100.5, 0, 1), "")
	assert_eq(_model.balls[0][4], 1.0)


func test_the_key_goes_through_the_usual_bouncinesses() -> void:
	var seen: PackedFloat64Array = []
	for press: int in 3:
		_model.take_next_bounciness()
		seen.append(_model.bounciness)
	assert_eq(seen, PackedFloat64Array([0.5, 0.0, 1.0]))


func test_the_balls_as_they_fly_can_be_the_new_start() -> void:
	var run := _model.run()
	run.go_to(run.end)
	_model.start_from(run.balls())
	assert_almost_eq(_model.balls[1][2], 4.0, 1e-13)
	assert_null(_model.run().meeting)


func _assert_wrong(number: int, one: Vec2, two: Vec2) -> void:
	var wrong := NewtonBallsMistakes.velocities_after(number, _model.run().meeting)
	assert_vec2(wrong[0], one, 1e-13)
	assert_vec2(wrong[1], two, 1e-13)


func _assert_loses_momentum(number: int) -> void:
	var meeting := _model.run().meeting
	var wrong := NewtonBallsMistakes.velocities_after(number, meeting)
	assert_gt(meeting.momentum_of(wrong).distance_to(meeting.momentum()), 0.1)


func _take(preset: String) -> void:
	assert_no_refusal(_model.take(NewtonBallsPresets.all()[preset]))


func _problem(balls: Array[PackedFloat64Array]) -> String:
	return _model.take({"balls": balls})


static func _two(x_one: float, x_two: float) -> Array[PackedFloat64Array]:
	return [[x_one, 0, 1, 0, 1], [x_two, 0, 0, 0, 1]]
