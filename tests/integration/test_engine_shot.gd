extends LabTest
## Tests of a ball's flight by the engine's own body: where it starts, that frames can be asked for
## in any order, that it bounces, and that nothing is left of it.


func test_it_starts_where_the_ball_is() -> void:
	var shot := _shot(1.0)
	assert_vec2(shot.place_at(0.0), Vec2.new(0.0, -50.0), 0.0)
	shot.finish()


func test_frames_can_be_asked_for_in_any_order() -> void:
	var shot := _shot(1.0)
	var there := shot.place_at(40.0)
	shot.place_at(3.0)
	assert_vec2(shot.place_at(40.0), there, 0.0)
	var between := shot.place_at(39.0).lerped(there, 0.5)
	assert_vec2(shot.place_at(39.5), between, 1e-12)
	shot.finish()


func test_it_bounces_off_the_floor_as_high_as_its_bounciness_says() -> void:
	for bounciness: float in [1.0, 0.5]:
		var shot := _shot(bounciness)
		var lowest := -INF
		var highest := INF
		for frame: int in 120:
			var y := shot.place_at(frame).y
			lowest = maxf(lowest, y)
			highest = minf(highest, y) if lowest > -15.0 else INF
		# The floor is at y = 0, the radius 10: it falls 40 px, and a frame's way is then 2.6 px.
		assert_between(lowest, -10.0 - 2.6, -10.0 + 0.1)
		assert_almost_eq(-10.0 - highest, 40.0 * bounciness ** 2, 8.0, "C = %s" % bounciness)
		shot.finish()


func test_nothing_is_left_once_it_is_finished() -> void:
	var host := Node.new()
	add_child_autofree(host)
	var shot := EngineShot.new(host, Ball.new(Vec2.new(), 10.0), Surroundings.new())
	assert_eq(host.get_child_count(), 1)
	shot.finish()
	assert_eq(host.get_child_count(), 0)


func _shot(bounciness: float) -> EngineShot:
	var host := Node.new()
	add_child_autofree(host)
	var surroundings := Surroundings.new()
	assert_no_refusal(surroundings.set_gravity(Vec2.new(0.0, 300.0)))
	assert_no_refusal(surroundings.set_bounciness(bounciness))
	assert_no_refusal(
		surroundings.set_segments([LineSegment.new(Vec2.new(-100.0, 0.0), Vec2.new(100.0, 0.0))])
	)
	return EngineShot.new(host, Ball.new(Vec2.new(0.0, -50.0), 10.0), surroundings)
