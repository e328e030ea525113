extends LabTest
## What has happened, in order.


func test_an_event_holds_the_ball_before_and_after() -> void:
	var events := EventLog.new()
	var event := events.begin(2.5, 3, Vec2.new(10, 2), 7.0)
	var after := Ball.new(Vec2.new(25, 5), 5, Vec2.new(-10, 2), 1.0, 4.0)
	events.finish(event, WorldEvent.Kind.WALL, 1, Vec2.new(-1, 0), after)
	assert_eq(events.events, [event] as Array[WorldEvent])
	assert_eq([event.time, event.ball, event.kind, event.other], [2.5, 3, WorldEvent.Kind.WALL, 1])
	assert_vec2(event.velocity_before, Vec2.new(10, 2), 0.0)
	assert_vec2(event.velocity_after, Vec2.new(-10, 2), 0.0)
	assert_eq([event.spin_before, event.spin_after], [7.0, 4.0])
	assert_vec2(event.point, Vec2.new(30, 5), 0.0)
