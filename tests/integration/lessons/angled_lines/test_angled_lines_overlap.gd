extends LessonTest
## A line that is dragged into a ball at rest carries it, in each way of stepping.


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"angled_lines"))


func test_a_resting_ball_stays_above_a_line_that_is_dragged_up() -> void:
	for method: SteppingMethods.Method in SteppingMethods.Method.values():
		_lay_ball_on_line()
		frame().lesson.services[&"options"].emit_signal(&"chosen", "method", method)
		for step: int in 20:
			await student.press(&"lab_next_frame")
		await drag(Vec2.new(60, 0), Vec2.new(60, -20))
		for step: int in 20:
			await student.press(&"lab_next_frame")
		var ball := _model().ball()
		assert_almost_eq(_model().lines()[0].start.y, -20.0, 1e-6, "way %d" % method)
		assert_almost_eq(ball.position.y, -30.0, 0.1, "way %d" % method)


func _lay_ball_on_line() -> void:
	var line := LineSegment.new(Vec2.new(-100, 0), Vec2.new(100, 0))
	assert_no_refusal(_model().set_lines([line] as Array[LineSegment]))
	assert_no_refusal(_model().world.surroundings.set_bounciness(0.5))
	assert_no_refusal(_model().world.set_balls([Ball.new(Vec2.new(0, -10), 10.0)]))
	_model().selected = 0
	frame().lesson.finish_edit()


func _model() -> AngledLinesModel:
	return frame().lesson.get(&"_model")
