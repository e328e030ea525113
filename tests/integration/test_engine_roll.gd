extends LabTest
## Godot's own body on a line with friction: where it starts, that its frames are kept, when it
## comes to the end, and that nothing is left of it.

# So many frames at most until a run is over.
const _FRAMES := 400

var _host: Node


func before_each() -> void:
	_host = Node.new()
	add_child_autofree(_host)


func test_it_starts_where_the_ball_is() -> void:
	var roll := _slope(0.5)
	assert_vec2(roll.place_at(0.0), Vec2.new(6.0, -8.0), 0.0)
	assert_null(roll.place_at(0.1), "no frame has come yet")
	roll.finish()


func test_each_frame_is_kept_and_the_end_is_found() -> void:
	for friction: float in [0.0, 0.125, 0.5]:
		var roll := _slope(friction)
		await _wait_for(roll)
		var exact := Incline.new(_line(), Vec2.new(0, 600), friction).run(10, 0, 0, 0, 9).time
		gut.p("µ %s: ends after %.4f s, exactly %.4f s" % [friction, roll.end_time, exact])
		# In each of its frames the engine changes the speed first: so it is half a frame early.
		assert_almost_eq(roll.end_time, exact - 0.5 / 60.0, 0.004, "µ = %s" % friction)
		var there := roll.place_at(0.3)
		assert_vec2(roll.place_at(0.1).lerped(there, 1.0), there, 0.0)
		assert_gt(there.x, 6.0)
		assert_null(roll.place_at(9.0), "behind its last frame")
		roll.finish()


func test_nothing_is_left_once_it_is_finished() -> void:
	var roll := _slope(0.5)
	assert_eq(_host.get_child_count(), 1)
	roll.finish()
	assert_eq(_host.get_child_count(), 0)
	await wait_physics_frames(3)
	assert_null(roll.place_at(0.02), "and no frame is kept any more")


func test_a_body_that_does_not_come_to_the_end_is_not_waited_for() -> void:
	var floor_line := LineSegment.new(Vec2.new(), Vec2.new(100, 0))
	var ball := Ball.new(Vec2.new(0, -10), 10.0)
	var roll := EngineRoll.new(_host, ball, floor_line, 600.0, 0.5)
	watch_signals(roll)
	for frame: int in 700:
		if roll.has_ended():
			break
		await get_tree().physics_frame
	assert_true(roll.has_ended())
	assert_eq(roll.end_time, INF)
	assert_signal_emit_count(roll, "ended", 1)
	roll.finish()


func _line() -> LineSegment:
	return LineSegment.new(Vec2.new(), Vec2.new(96, 72))


func _slope(friction: float) -> EngineRoll:
	return EngineRoll.new(_host, Ball.new(Vec2.new(6, -8), 10.0), _line(), 600.0, friction)


func _wait_for(roll: EngineRoll) -> void:
	for frame: int in _FRAMES:
		if roll.has_ended():
			return
		await get_tree().physics_frame
