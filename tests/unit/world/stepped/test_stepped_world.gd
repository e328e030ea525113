extends LabTest
## Tests of balls among lines that are stepped frame by frame: energy, rest, lost balls, stored
## states.

const FRAME := SteppedWorlds.FRAME


func test_energy_stays_for_a_minute_when_the_whole_frame_is_used() -> void:
	var world := SteppedWorlds.box(1, 5)
	var before := world.energy()
	SteppedWorlds.run(world, 3600)
	assert_gt(world.bounces, 50, "it has bounced often")
	assert_almost_eq(world.energy() / before, 1.0, 1e-9)


func test_dropping_the_rest_of_the_frame_loses_energy() -> void:
	var world := SteppedWorlds.box(1, 5)
	world.mover = SteppingMethods.mover_of(SteppingMethods.Method.POINT_OF_IMPACT)
	var before := world.energy()
	SteppedWorlds.run(world, 3600)
	assert_between(world.energy() / before, 0.5, 0.98)


func test_position_reset_gains_energy() -> void:
	var world := SteppedWorlds.box(1, 5)
	# This ball is too large to pass a line within one frame.
	assert_no_refusal(
		world.set_balls([Ball.new(Vec2.new(-200.0, -100.0), 20.0, Vec2.new(50.0, 0.0))])
	)
	world.mover = SteppingMethods.mover_of(SteppingMethods.Method.POSITION_RESET)
	var before := world.energy()
	SteppedWorlds.run(world, 3600)
	assert_between(world.energy() / before, 1.02, 2.0)


func test_free_flight_is_the_parabola_whatever_the_frame() -> void:
	var ball := Ball.new(Vec2.new(-100.0, 50.0), 5.0, Vec2.new(90.0, -120.0))
	var world := SteppedWorlds.world([], ball, Vec2.new(30.0, 240.0))
	SteppedWorlds.run(world, 60)
	assert_vec2(world.balls[0].position, Vec2.new(5.0, 50.0), 1e-9, "x + v t + g t^2 / 2, t = 1")
	assert_vec2(world.balls[0].velocity, Vec2.new(120.0, 120.0), 1e-9, "v + g t")


func test_a_ball_between_two_walls_is_on_time_after_many_bounces() -> void:
	# The centre has 76 px of room and moves 19 px a frame: there and back takes 8 frames.
	var ball := Ball.new(Vec2.new(-38.0, 0.0), 12.0, Vec2.new(1140.0, 0.0))
	var world := SteppedWorlds.world([Vector4(-50, -90, -50, 90), Vector4(50, 90, 50, -90)], ball)
	SteppedWorlds.run(world, 8 * 50 + 2)
	assert_vec2(world.balls[0].position, Vec2.new(0.0, 0.0), 1e-8)


func test_a_thin_line_is_never_passed_however_fast_the_ball() -> void:
	for speed: float in [600.0, 6000.0, 60000.0, 600000.0]:
		var ball := Ball.new(Vec2.new(-200.0, 3.0), 4.0, Vec2.new(speed, 0.0))
		var world := SteppedWorlds.world([Vector4(0, -500, 40, 500)], ball)
		SteppedWorlds.run(world, 30)
		assert_lt(world.balls[0].position.x, 0.0, "%s px/s" % speed)


func test_a_ball_comes_to_rest_on_a_level_floor() -> void:
	var ball := Ball.new(Vec2.new(0.0, -60.0), 10.0)
	var world := SteppedWorlds.world([Vector4(-90, 0, 90, 0)], ball, Vec2.new(0.0, 300.0))
	assert_no_refusal(world.surroundings.set_bounciness(0.5))
	SteppedWorlds.run(world, 600)
	assert_vec2(world.balls[0].position, Vec2.new(0.0, -10.0), 1e-6)
	assert_eq(world.balls[0].velocity.length(), 0.0)


func test_a_ball_slides_down_a_slope_as_fast_as_gravity_along_it_makes_it() -> void:
	# On a slope of the 3-4-5 triangle, 300 of the 500 px/s^2 of gravity act along it.
	var ball := Ball.new(Vec2.new(-160.0 + 6.0, -120.0 - 8.0), 10.0)
	var world := SteppedWorlds.world([Vector4(-400, -300, 400, 300)], ball, Vec2.new(0.0, 500.0))
	assert_no_refusal(world.surroundings.set_bounciness(0.0))
	SteppedWorlds.run(world, 60)
	# Rounding puts its start 1e-14 px off the slope. By v^2 = 2 g s that makes 3e-6 px/s.
	assert_vec2(world.balls[0].velocity, Vec2.new(240.0, 180.0), 1e-5)
	assert_vec2(world.balls[0].position, Vec2.new(-154.0 + 120.0, -128.0 + 90.0), 1e-5)


func test_a_ball_wedged_in_a_corner_stays_and_costs_no_bounces() -> void:
	var lines: Array[Vector4] = [Vector4(-90, -60, 0, 60), Vector4(0, 60, 110, -50)]
	var world := SteppedWorlds.world(
		lines, Ball.new(Vec2.new(5.0, -40.0), 10.0), Vec2.new(0.0, 300.0)
	)
	assert_no_refusal(world.surroundings.set_bounciness(0.6))
	SteppedWorlds.run(world, 900)
	var place := world.balls[0].position.copy()
	var bounces := world.bounces
	SteppedWorlds.run(world, 60)
	assert_vec2(world.balls[0].position, place, 0.0)
	assert_eq(world.bounces, bounces)


func test_a_resting_ball_falls_when_gravity_turns() -> void:
	var ball := Ball.new(Vec2.new(0.0, -10.0), 10.0)
	var world := SteppedWorlds.world([Vector4(-90, 0, 90, 0)], ball, Vec2.new(0.0, 300.0))
	SteppedWorlds.run(world, 30)
	assert_no_refusal(world.surroundings.set_gravity(Vec2.new(0.0, -300.0)))
	SteppedWorlds.run(world, 60)
	assert_vec2(world.balls[0].position, Vec2.new(0.0, -160.0), 1e-6)


func test_the_energy_is_that_of_height_and_speed() -> void:
	var ball := Ball.new(Vec2.new(0.0, -40.0), 5.0, Vec2.new(3.0, 4.0), 2.0)
	var world := SteppedWorlds.world([Vector4(-90, 10, 90, 60)], ball, Vec2.new(0.0, 10.0))
	assert_almost_eq(world.energy(), 2.0 * (12.5 + 10.0 * 100.0), 1e-9)


func test_a_ball_that_leaves_is_lost_once_and_can_be_brought_back() -> void:
	var ball := Ball.new(Vec2.new(700.0, 0.0), 5.0, Vec2.new(600.0, 0.0))
	var world := SteppedWorlds.world([], ball)
	SteppedWorlds.run(world, 60)
	assert_eq([world.lost_count(), world.losses], [1, 1])
	world.bring_back(0, ball)
	assert_eq([world.lost_count(), world.losses], [0, 1])
	assert_vec2(world.balls[0].position, Vec2.new(700.0, 0.0), 0.0)


func test_a_state_put_back_runs_on_to_the_same_bits() -> void:
	var world := SteppedWorlds.box(10, 3)
	SteppedWorlds.run(world, 100)
	var stored := world.state()
	SteppedWorlds.run(world, 200)
	var later := world.state()
	assert_eq(world.put_state(stored), "")
	SteppedWorlds.run(world, 200)
	assert_eq(world.state(), later)


func test_a_stored_world_put_into_another_runs_the_same() -> void:
	var world := SteppedWorlds.box(5, 4)
	SteppedWorlds.run(world, 30)
	var other := SteppedWorld.new(WholeFrameMover.new())
	assert_no_refusal(WorldState.put(WorldState.of(world), other))
	SteppedWorlds.run(world, 100)
	SteppedWorlds.run(other, 100)
	assert_eq(other.state(), world.state())


func test_a_copy_shares_nothing() -> void:
	var world := SteppedWorlds.box(2, 4)
	var before := world.state()
	var copy := world.copy()
	assert_no_refusal(copy.surroundings.set_gravity(Vec2.new(0.0, -900.0)))
	SteppedWorlds.run(copy, 60)
	assert_eq(world.state(), before)
	assert_vec2(world.surroundings.gravity, Vec2.new(0.0, 300.0), 0.0)


func test_history_goes_back_ten_seconds_to_the_same_bits() -> void:
	var world := SteppedWorlds.box(3, 8)
	var worlds: Array[SteppedWorld] = [world]
	var history := StepHistory.new()
	var first := world.state()
	for frame: int in 600:
		history.remember(worlds)
		assert_no_refusal(world.step(FRAME))
	for frame: int in 600:
		history.go_back(worlds)
	assert_eq(world.state(), first)
	assert_false(history.go_back(worlds), "nothing is left")


func test_history_forgets_the_oldest_beyond_its_length() -> void:
	var history := StepHistory.new()
	var worlds: Array[SteppedWorld] = [SteppedWorld.new(WholeFrameMover.new())]
	for frame: int in StepHistory.LONGEST + 10:
		history.remember(worlds)
	assert_eq(history.size(), StepHistory.LONGEST)
