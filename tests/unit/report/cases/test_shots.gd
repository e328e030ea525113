extends LabTest
## The shots of the report, and what the lab's own methods make of them.


func test_the_event_world_is_right_in_the_box_at_every_speed() -> void:
	for speed in BallInBoxProblem.SPEEDS:
		for form: EventFlight.Form in [EventFlight.Form.WALLS, EventFlight.Form.GRID]:
			var case := EventFlight.new(form, "event world", BoxShot.new(speed, 10.0), 60)
			case.run_once()
			assert_lt(case.error, 1e-9, "%s px/s" % speed)


func test_following_the_flights_gives_the_places_of_the_event_world() -> void:
	for shot: Shot in [BoxShot.new(3000.0, 10.0), ManySegmentsShot.new(64)]:
		var case := FollowedFlight.new(EventFlight.Form.GRID, "", shot, 240)
		case.run_once()
		assert_lt(case.error, 1e-9)
		case.finish()


func test_dropping_the_rest_of_a_frame_ends_elsewhere_and_using_it_does_not() -> void:
	var shot := BoxShot.new(300.0, 10.0)
	assert_gt(_flown(SteppingMethods.Method.POINT_OF_IMPACT, shot).error, 1.0)
	assert_lt(_flown(SteppingMethods.Method.WHOLE_FRAME, shot).error, 1e-9)


func test_a_position_reset_loses_a_fast_ball() -> void:
	var case := _flown(SteppingMethods.Method.POSITION_RESET, BoxShot.new(30000.0, 10.0))
	assert_eq(case.error, Measurement.NO_ANSWER)
	assert_string_contains(case.note, "left the box")


func test_five_runs_make_one_stepped_flight() -> void:
	var case := SteppedFlight.new(SteppingMethods.Method.WHOLE_FRAME, BoxShot.new(300.0, 10.0), 60)
	for run: int in 4:
		case.run_once()
	assert_false(case.result().has_answer(), "not yet known")
	case.run_once()
	assert_between(case.error, 1e-15, 1e-9)
	assert_eq(case.note, "")


func test_a_ball_among_lines_follows_the_exact_path_for_many_bounces() -> void:
	var shot := LinesShot.new()
	var case := EventFlight.new(EventFlight.Form.GRID, "event world", shot, 60)
	case.run_once()
	assert_gt(case.figures["bounces"], 12.0)
	assert_almost_eq(case.error, 1.0 / case.figures["bounces"], 1e-15)


func test_the_bounces_until_a_path_is_lost_are_counted() -> void:
	var shot := LinesShot.new()
	var path: PackedFloat64Array = []
	for frame in 240:
		var place := shot.exact_path().position_at((frame + 1) / 60.0)
		path.append_array([place.x + (1.1 if frame >= 119 else 0.9), place.y])
	var case := EventFlight.new(EventFlight.Form.GRID, "", shot, 60)
	shot.judge(case, Vec2.new(), path)
	assert_eq(case.figures["bounces"], float(shot.bounces_until(2.0)))
	assert_string_contains(case.note, "1 px off after %d bounces, 2.00 s" % shot.bounces_until(2.0))


func test_bounces_are_counted_from_the_first_flight_on() -> void:
	var shot := LinesShot.new()
	var flights := shot.exact_path().flights
	assert_eq(shot.bounces_until(0.0), 0)
	assert_eq(shot.bounces_until(flights[3].start.to_float() + 1e-9), 3)


func test_the_ball_among_lines_starts_free() -> void:
	var shot := LinesShot.new()
	for segment in shot.segments():
		var gap := segment.closest_point(shot.ball.position).distance_to(shot.ball.position)
		assert_gt(gap, shot.ball.radius)


func test_there_are_as_many_segments_as_said_none_near_the_start_and_all_inside() -> void:
	for count in ManySegmentsProblem.COUNTS.slice(0, 3):
		var shot := ManySegmentsShot.new(count)
		assert_eq(shot.segments().size(), count)
		var half := 40.0 * sqrt(count)
		for segment in shot.segments():
			var gap := segment.closest_point(shot.ball.position).distance_to(shot.ball.position)
			assert_gt(gap, shot.ball.radius)
			assert_lte(maxf(absf(segment.start.x), absf(segment.end.y)), half)


func test_the_density_stays() -> void:
	# Each segment but the walls has 80 x 80 px of room.
	var small := ManySegmentsShot.new(64)
	var large := ManySegmentsShot.new(1024)
	assert_almost_eq(large.segments()[0].length() / small.segments()[0].length(), 4.0, 1e-12)


func test_grid_and_scan_both_follow_the_exact_path_among_many_segments() -> void:
	for form: EventFlight.Form in [EventFlight.Form.GRID, EventFlight.Form.SCAN]:
		var case := EventFlight.new(form, "", ManySegmentsShot.new(64), 60)
		case.run_once()
		assert_gt(case.figures["bounces"], 2.0)
		assert_lt(case.error, 1e-9)


func test_a_shot_that_goes_on_is_set_up_once() -> void:
	var case := Counting.new(EventFlight.Form.GRID, "", ManySegmentsShot.new(64), 60)
	case.run_once()
	case.run_once()
	assert_eq([case.runs(), case.set_ups], [2, 1])
	case.finish()


func test_growth_is_the_slope_between_two_numbers_of_segments() -> void:
	var rows: Array[Measurement] = []
	for count: int in [64, 16384]:
		var row := Measurement.new()
		row.method = "some"
		row.situation = ManySegmentsShot.situation_of(count)
		row.run_time_us = sqrt(count)
		rows.append(row)
	assert_almost_eq(ManySegmentsProblem.growth("some", rows), 0.5, 1e-12)
	assert_true(is_nan(ManySegmentsProblem.growth("other", rows)))


func test_the_ceiling_of_the_box_is_measured_in_each_situation_and_solves_nothing() -> void:
	var situations: PackedStringArray = []
	for case in BallInBoxProblem.new().ceilings():
		case.run_once()
		var row := case.result()
		assert_eq([row.method, row.tuning, row.has_answer()], [EmptyCall.METHOD, "60 Hz", false])
		assert_gt(row.run_time_us, 0.0)
		situations.append(row.situation)
	for shot in BallInBoxProblem.shots():
		assert_has(situations, shot.situation)


func test_a_world_that_stops_on_the_way_is_no_answer() -> void:
	var case := Stopping.new(EventFlight.Form.WALLS, "stops", BoxShot.new(300000.0, 1.0 / 60.0), 60)
	case.run_once()
	assert_push_error_count(1)
	assert_string_contains(case.result().note, "more than 0 impacts within a second")


func _flown(way: SteppingMethods.Method, shot: Shot) -> MeasuredCase:
	var case := SteppedFlight.new(way, shot, 60)
	for run: int in 5:
		case.run_once()
	return case


class Counting:
	extends EventFlight

	var set_ups := 0

	func _prepare() -> void:
		set_ups += 1
		super()


class Stopping:
	extends EventFlight

	func _prepare() -> void:
		super()
		_world.most_impacts_per_second = 0
