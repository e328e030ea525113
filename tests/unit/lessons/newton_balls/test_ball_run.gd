extends LabTest
## The balls of the lesson as they fly: forwards, back to the last bit at any C, with and without
## Newton's laws.


func test_two_balls_leave_with_the_numbers_of_the_course() -> void:
	var wanted := {1.0: [-2.0, 4.0], 0.5: [0.0, 3.0], 0.0: [2.0, 2.0]}
	for bounciness: float in wanted:
		var model := NewtonBallsModel.new()
		model.bounciness = bounciness
		var run := model.run()
		run.go_to(run.end)
		var numbers: PackedFloat64Array = wanted[bounciness]
		assert_vec2(run.balls()[0].velocity, Vec2.new(numbers[0], 0.0), 1e-13)
		assert_vec2(run.balls()[1].velocity, Vec2.new(numbers[1], 0.0), 1e-13)
		assert_eq(run.bounce_count(), 1)


func test_it_flies_what_the_formula_says() -> void:
	for preset: String in NewtonBallsPresets.all():
		var model := _preset(preset)
		var run := model.run()
		var meeting := run.meeting
		assert_not_null(meeting, preset)
		run.go_to(meeting.time + 1e-9)
		var after := meeting.velocities_after()
		if preset != "Cradle":
			assert_vec2(run.balls()[meeting.first].velocity, after[0], 1e-12)
			assert_vec2(run.balls()[meeting.second].velocity, after[1], 1e-12)


func test_the_cradle_hands_its_speed_on_to_the_last_ball() -> void:
	var run := _preset("Cradle").run()
	run.go_to(run.end)
	var balls := run.balls()
	for index: int in 4:
		assert_vec2(balls[index].velocity, Vec2.new(), 1e-12)
	assert_vec2(balls[4].velocity, Vec2.new(5.0, 0.0), 1e-12)


func test_a_moment_comes_back_to_the_last_bit_at_any_bounciness() -> void:
	for bounciness: float in [1.0, 0.7, 0.5, 0.0]:
		for newton: bool in [true, false]:
			var model := _preset("50 balls")
			model.bounciness = bounciness
			model.has_newton = newton
			var run := model.run()
			var seen: Dictionary[int, PackedFloat64Array] = {}
			for frame: int in 150:
				run.go_to(frame / 60.0)
				seen[frame] = _numbers(run)
			for frame: int in [149, 130, 121, 120, 119, 61, 60, 59, 3, 0, 100]:
				run.go_to(frame / 60.0)
				assert_eq(_numbers(run), seen[frame], "C = %s, frame %d" % [bounciness, frame])
			assert_eq(run.refusal, "")


func test_50_balls_keep_energy_and_stay_in_the_box() -> void:
	var run := _preset("50 balls").run()
	var energy := run.energy()
	run.go_to(10.0)
	assert_almost_eq(run.energy(), energy, 1e-10 * energy)
	assert_gt(run.bounce_count(), 100)
	for ball in run.balls():
		assert_lt(absf(ball.position.x), BallRun.HALF_BOX[0] - ball.radius + 1e-9)
		assert_lt(absf(ball.position.y), BallRun.HALF_BOX[1] - ball.radius + 1e-9)


func test_without_newton_each_ball_bounces_as_off_a_wall() -> void:
	var model := NewtonBallsModel.new()
	model.has_newton = false
	var run := model.run()
	run.go_to(run.end)
	assert_vec2(run.balls()[0].velocity, Vec2.new(-6.0, 0.0), 1e-13)
	assert_vec2(run.balls()[1].velocity, Vec2.new(), 1e-13)
	assert_vec2(run.momentum(), Vec2.new(-6.0, 0.0), 1e-12)


func test_balls_that_touch_at_the_start_bounce_at_once() -> void:
	for newton: bool in [true, false]:
		var model := NewtonBallsModel.new()
		model.has_newton = newton
		var balls: Array[PackedFloat64Array] = [[-1, 0, 2, 0, 1], [1, 0, 0, 0, 1]]
		assert_no_refusal(model.take({"balls": balls}))
		var run := model.run()
		assert_eq(run.meeting.time, 0.0)
		run.go_to(0.5)
		var wanted := Vec2.new() if newton else Vec2.new(-2.0, 0.0)
		assert_vec2(run.balls()[0].velocity, wanted, 1e-13)


func test_balls_that_part_do_not_meet() -> void:
	var model := NewtonBallsModel.new()
	assert_no_refusal(model.set_velocity(0, Vec2.new(-1.0, 0.0)))
	assert_null(model.run().meeting)


func _preset(title: String) -> NewtonBallsModel:
	var model := NewtonBallsModel.new()
	assert_no_refusal(model.take(NewtonBallsPresets.all()[title]))
	return model


static func _numbers(run: BallRun) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	for ball in run.balls():
		found.append_array(NewtonBallsModel.list_of(ball))
	return found
