extends LabTest
## What report.md says: sentences, ratios and goals, all worked out from the measurements.


func test_numbers_have_two_or_three_digits() -> void:
	var texts: Array[String] = []
	for value: float in [0.0, 12.345, 0.4512, 1234.6, 3.14159e-13, 2.5e9, 0.001]:
		texts.append(FigureText.short(value))
	assert_eq(texts, ["0", "12.3", "0.451", "1235", "3.1e-13", "2.5e9", "0.001"])


func test_a_ratio_needs_something_to_be_divided_by() -> void:
	assert_eq(FigureText.ratio(5.0, 2.0), "2.5")
	assert_eq(FigureText.ratio(5.0, 0.0), "-")
	assert_eq(FigureText.ratio(Measurement.NO_ANSWER, 2.0), "-")


func test_a_situation_names_the_frontier_and_the_ratios() -> void:
	var rows := _rows()
	var text := SituationText.of("300 px/s", rows, "")
	assert_string_starts_with(
		text, "- **300 px/s**: on the frontier quick baseline (60 Hz) 10.0 µs, 4.0 px;"
	)
	assert_string_contains(text, "own 40.0 µs, 2.0e-9 px.")
	assert_string_contains(
		text,
		"fastest baseline, quick baseline (60 Hz), takes 0.25 times as long as own and is 2.0e9 times"
	)
	assert_string_contains(text, "most exact baseline, fine baseline, takes 5.0 times as long")


func test_the_champion_is_put_in_relation_even_if_another_is_more_exact() -> void:
	var rows := _rows()
	rows.append(_row("more exact", "", false, 100.0, 1e-12))
	assert_string_contains(SituationText.of("", rows, "own"), "as long as own and")
	assert_string_contains(SituationText.of("", rows, ""), "as long as more exact and")


func test_those_without_an_answer_are_named_with_their_settings() -> void:
	var rows := _rows()
	for tuning: String in ["60 Hz", "240 Hz"]:
		rows.append(_row("lost", tuning, false, 1.0, Measurement.NO_ANSWER))
		rows[-1].note = "it has left"
	assert_string_contains(
		SituationText.of("", rows, "own"), " No answer: lost (60 Hz, 240 Hz): it has left."
	)
	rows.append(_row("not tuned", "", false, 1.0, Measurement.NO_ANSWER))
	rows[-1].note = "100 % lost"
	assert_string_contains(SituationText.of("", rows, "own"), "; not tuned: 100 % lost.")


func test_the_text_has_a_section_for_each_problem_that_was_measured() -> void:
	var text := ReportText.of(ReportProblems.all(), _rows(), "Measured here.")
	assert_string_contains(text, "\n## One ball in a box\n")
	assert_string_contains(text, "](ball_in_box.svg)")
	assert_false(text.contains("](dropped_ball.svg)"))
	assert_string_contains(text, "Measured here.")


func test_goals_are_not_judged_without_measurements() -> void:
	for goal in ReportGoals.of([]):
		assert_false(goal.is_judged, goal.what)
		assert_eq(goal.verdict(), "-")


func test_a_ratio_of_the_box_is_the_worst_of_all_forms_and_lengths() -> void:
	var goal := "box, 300 px/s: times faster than move_and_collide at 60 Hz, called"
	var rows: Array[Measurement] = []
	for seconds: String in ["10 s", "100 s"]:
		rows.append(_box("event world", "300 px/s, " + seconds, 20.0, 1e-13))
		rows.append(_box("move_and_collide, segments", "300 px/s, " + seconds, 60.0, 1.0))
		rows.append(_box("move_and_collide, concave shape", "300 px/s, " + seconds, 80.0, 1.0))
	assert_eq(_goal(rows, goal).measured, "3.0")
	assert_eq(_goal(rows, goal).verdict(), "reached")
	rows[4].run_time_us = 28.0
	assert_eq(_goal(rows, goal).measured, "1.4")
	assert_eq(_goal(rows, goal).verdict(), "**not reached**")


func test_the_ceiling_stands_beside_the_ratio_of_the_world_that_is_called() -> void:
	var rows: Array[Measurement] = []
	for seconds: String in ["10 s", "100 s"]:
		rows.append(_box("event world", "300 px/s, " + seconds, 25.0, 1e-13))
		rows.append(_box("move_and_collide, segments", "300 px/s, " + seconds, 40.0, 1.0))
		rows.append(_box("move_and_collide, concave shape", "300 px/s, " + seconds, 50.0, 1.0))
		rows.append(_box(EmptyCall.METHOD, "300 px/s, " + seconds, 16.0, Measurement.NO_ANSWER))
	var goal := _goal(rows, "box, 300 px/s: times faster than move_and_collide at 60 Hz, called")
	assert_eq([goal.wanted, goal.measured], ["at least 1.5", "1.6 (an empty call: 2.5)"])
	assert_true(goal.is_reached)


func test_the_event_world_is_judged_in_one_call_too() -> void:
	var situation := "300 px/s, 10 s"
	var rows: Array[Measurement] = [
		_box("event world, one call", situation, 10.0, 1e-13),
		_box("move_and_collide, segments", situation, 60.0, 1.0),
		_box("move_and_collide, concave shape", situation, 80.0, 1.0),
		_box("event world, one call", "300 px/s, 100 s", 10.0, 1e-13),
		_box("move_and_collide, segments", "300 px/s, 100 s", 60.0, 1.0),
		_box("move_and_collide, concave shape", "300 px/s, 100 s", 80.0, 1.0),
	]
	rows[0].tuning = OneCallFlight.TUNING
	rows[3].tuning = OneCallFlight.TUNING
	assert_eq(_goal(rows, "at 60 Hz, in one call").measured, "6.0")


func test_the_error_after_the_long_flight_is_the_worst_one() -> void:
	var rows: Array[Measurement] = [
		_box("event world", "300 px/s, 100 s", 1.0, 1e-12),
		_box("event world", "30000 px/s, 100 s", 1.0, 2e-9),
		_box("event world", "300 px/s, 10 s", 1.0, 1.0),
	]
	assert_eq(_goal(rows, "after 100 s").measured, "2.0e-9")
	assert_false(_goal(rows, "after 100 s").is_reached)


func test_the_frontier_is_counted_by_situation() -> void:
	var rows: Array[Measurement] = [
		_box("event world", "300 px/s, 10 s", 10.0, 1e-12),
		_box("move_and_collide, segments", "300 px/s, 10 s", 5.0, 1.0),
		_box("event world", "300 px/s, 100 s", 10.0, 1e-12),
		_box("impact, rest used", "300 px/s, 100 s", 9.0, 1e-13),
	]
	assert_eq(_goal(rows, "frontier").measured, "1 of 2")
	assert_false(_goal(rows, "frontier").is_reached)


func test_the_goals_of_many_balls_compare_with_the_engine_at_both_rates() -> void:
	var rows: Array[Measurement] = [
		_balls("event world", 60, 100.0), _balls("RigidBody2D", 60, 90.0)
	]
	rows.append(_balls("RigidBody2D", 240, 400.0))
	rows[0].figures["energy drift"] = 2e-13
	assert_eq(_goal(rows, "RigidBody2D at 60 Hz").verdict(), "**not reached**")
	assert_eq(_goal(rows, "RigidBody2D at 240 Hz").verdict(), "reached")
	assert_eq(_goal(rows, "drift").verdict(), "reached")
	assert_eq(_goal(rows, "overlap").verdict(), "reached")


func test_a_library_wins_where_it_is_faster_and_nowhere_else() -> void:
	var rows := _rows()
	rows[1].method = "event world"
	var problems: Array[ReportProblem] = [BallInBoxProblem.new()]
	assert_eq(LibraryText.of(problems, rows), "", "no library was measured")
	rows.append(_row("Chipmunk", "60 Hz", true, 8.0, 25.0))
	var text := LibraryText.of(problems, rows)
	assert_string_contains(
		text, "Chipmunk (60 Hz) is 5.0 times as fast as event world; error 25.0 px"
	)
	rows[-1].run_time_us = 50.0
	assert_string_contains(LibraryText.of(problems, rows), "Nowhere in this run.")


func _goal(rows: Array[Measurement], words: String) -> ReportGoal:
	for goal in ReportGoals.of(rows):
		if goal.what.contains(words):
			return goal
	return null


func _rows() -> Array[Measurement]:
	return [
		_row("quick baseline", "60 Hz", true, 10.0, 4.0),
		_row("own", "", false, 40.0, 2e-9),
		_row("fine baseline", "", true, 200.0, 2e-3),
	]


func _box(method: String, situation: String, time: float, error: float) -> Measurement:
	var row := _row(method, "60 Hz", method.begins_with("move"), time, error)
	row.situation = situation
	return row


func _balls(method: String, rate: int, time: float) -> Measurement:
	var row := _row(method, "%d Hz" % rate, method == "RigidBody2D", time, 0.0)
	row.problem = "many_balls"
	row.situation = "1000 balls"
	return row


func _row(
	method: String, tuning: String, is_baseline: bool, time: float, error: float
) -> Measurement:
	var row := Measurement.new()
	row.problem = "ball_in_box"
	row.situation = "300 px/s"
	row.method = method
	row.tuning = tuning
	row.is_baseline = is_baseline
	row.run_time_us = time
	row.error = error
	return row
