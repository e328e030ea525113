extends LabTest
## Tests of the timeline of the lesson on angled lines: moments gone to in any order, impacts to
## come and before, what is refused.


func test_a_moment_is_the_same_however_one_gets_there() -> void:
	var model := _model(0)
	assert_no_refusal(model.go_to(7.25))
	var there := _moving(model)
	assert_no_refusal(model.go_to(0.5))
	assert_no_refusal(model.go_to(3.0))
	assert_no_refusal(model.go_to(7.25))
	assert_eq(_moving(model), there)


func test_frames_forward_and_back_come_to_the_same_bits() -> void:
	var model := _model(7)
	var first := model.world.state()
	for frame: int in 100:
		model.step()
	for frame: int in 100:
		assert_true(model.step_back())
	assert_eq(model.world.state(), first)
	assert_false(model.step_back())


func test_the_next_impact_is_where_the_ball_touches() -> void:
	var model := _model(0)
	for impact: int in 12:
		assert_no_refusal(model.go_to(model.timeline.impact_time(0, 1)))
		var ball := model.ball()
		var gaps: PackedFloat64Array = []
		for line: LineSegment in model.lines():
			gaps.append(line.closest_point(ball.position).distance_to(ball.position))
		gaps.sort()
		assert_almost_eq(gaps[0], ball.radius, 1e-9)


func test_the_previous_impact_is_the_one_before() -> void:
	var model := _model(0)
	var times: PackedFloat64Array = []
	for impact: int in 5:
		times.append(model.timeline.impact_time(0, 1))
		assert_no_refusal(model.go_to(times[-1]))
	for impact: int in [3, 2, 1, 0]:
		assert_eq(model.timeline.impact_time(0, -1), times[impact])
		assert_no_refusal(model.go_to(times[impact]))
	assert_eq(model.timeline.impact_time(0, -1), -1.0)


func test_impacts_to_come_are_those_that_come() -> void:
	var model := _model(0)
	var known := model.timeline.impacts(0, 5.0).filter(
		func(event: WorldEvent) -> bool: return event.time <= 5.0
	)
	var bounces := 0
	for frame: int in 300:
		model.step()
		bounces += model.world.latest_bounces.size()
	assert_eq(bounces, known.size())
	assert_eq(model.world.bounces, bounces)


func test_the_energy_is_the_same_at_every_moment() -> void:
	var model := _model(0)
	for moment: int in 40:
		assert_no_refusal(model.go_to(0.83 * (moment % 7) * moment))
		assert_almost_eq(model.energy_share(model.world), 1.0, 1e-12)


func test_the_formula_shows_the_latest_bounce_of_the_moment() -> void:
	var model := _model(0)
	assert_null(model.last_bounce)
	assert_no_refusal(model.go_to(model.timeline.impact_time(0, 1)))
	assert_vec2(model.last_bounce.position, model.ball().position, 1e-9)
	assert_vec2(model.last_bounce.velocity_after, model.ball().velocity, 1e-9)
	assert_no_refusal(model.go_to(0.0))
	assert_null(model.last_bounce)


func test_a_ball_that_flies_away_is_lost_and_back_in_time_it_is_not() -> void:
	var model := _model(0)
	assert_no_refusal(model.set_lines([model.lines()[4]] as Array[LineSegment]))
	assert_no_refusal(model.go_to(9.0))
	assert_eq(model.world.lost_count(), 1)
	assert_no_refusal(model.go_to(0.5))
	assert_eq(model.world.lost_count(), 0)


func test_a_lost_ball_that_is_fetched_begins_a_new_timeline() -> void:
	var model := _model(0)
	assert_no_refusal(model.set_lines([model.lines()[4]] as Array[LineSegment]))
	assert_no_refusal(model.go_to(9.0))
	model.fetch_balls()
	assert_vec2(model.ball().position, Vec2.new(-200.0, -120.0), 0.0)
	assert_eq(model.timeline.time, 0.0)
	model.step()
	assert_eq(model.world.lost_count(), 0)


func test_a_jammed_ball_is_told_instead_of_hanging() -> void:
	var model := _model(0)
	var narrow: Array[LineSegment] = [
		LineSegment.new(Vec2.new(-300.0, -132.0), Vec2.new(0.0, -132.0)),
		LineSegment.new(Vec2.new(-300.0, -108.0), Vec2.new(0.0, -108.0)),
	]
	assert_no_refusal(model.set_lines(narrow))
	assert_no_refusal(model.set_gravity(Vec2.new()))
	assert_no_refusal(model.change_ball(Vec2.new(-200.0, -120.0), Vec2.new(0.0, 100.0)))
	assert_string_contains(model.go_to(1.0), "impacts within a second")
	assert_true(model.ball().position.is_finite())


func test_the_page_turns_after_ten_seconds() -> void:
	var model := _model(0)
	assert_eq(model.timeline.page_start(), 0.0)
	assert_no_refusal(model.go_to(10.0))
	assert_eq(model.timeline.page_start(), 10.0)
	assert_gt(model.timeline.impact_time(0, 1), 10.0)


func test_the_event_world_switches_mistakes_off_and_a_mistake_the_event_world() -> void:
	var model := AngledLinesModel.new()
	model.set_mistake(24)
	assert_eq(model.set_method(SteppingMethods.Method.EVENT_WORLD), "")
	assert_eq(model.mistake, 0)
	assert_not_null(model.timeline)
	model.set_mistake(21)
	assert_null(model.timeline)


func test_a_stored_moment_is_put_back() -> void:
	var model := _model(7)
	assert_no_refusal(model.go_to(2.6))
	var other := AngledLinesModel.new()
	other.from_dictionary(model.to_dictionary())
	assert_eq(other.world.state(), model.world.state())
	assert_not_null(other.timeline)


func _model(preset: int) -> AngledLinesModel:
	var model := AngledLinesModel.new()
	model.set_up(preset)
	assert_eq(model.set_method(SteppingMethods.Method.EVENT_WORLD), "")
	return model


func _moving(model: AngledLinesModel) -> PackedFloat64Array:
	return model.world.state()
