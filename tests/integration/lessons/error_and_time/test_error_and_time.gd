extends ScreenTest
## Drives the lesson on error and run time: measuring, stopping, choosing, pointing at points with
## mouse, finger, keys and gamepad, undo and reset.


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"error_and_time"))


func test_it_measures_by_itself_and_gives_no_answer_at_the_first_step() -> void:
	assert_gt(_run().done_count(), 0)
	await _finish_measuring()
	assert_reads("Done")
	assert_reads("Each mark is a method")
	assert_eq(_plot().chosen(), -1)
	assert_does_not_read("frontier")
	assert_does_not_read("closest")
	assert_does_not_read("log(")


func test_the_second_step_shows_the_frontier_and_tells_of_the_closest_point() -> void:
	await _finish_measuring()
	_steps().go_to(1)
	await student.settle()
	assert_reads("on the frontier")
	assert_reads("closest")
	assert_eq(_plot().chosen(), _frontier()[-1])
	assert_does_not_read("log(")


func test_the_key_that_hides_answers_hides_the_frontier_and_the_card() -> void:
	await _finish_measuring()
	_steps().go_to(1)
	await student.settle()
	for alpha: float in [0.0, 1.0]:
		await student.press(&"lab_hide_answers")
		await student.settle()
		for part: String in ["%Frontier", "%Card"]:
			assert_eq((_plot().get_node(part) as Control).modulate.a, alpha, part)


func test_it_asks_before_the_frontier_and_before_the_order() -> void:
	await _finish_measuring()
	await student.press(&"lab_next_step")
	assert_reads("which mark has the smallest error?")
	await click_button("the slowest")
	var is_slowest := _model().rank_of_closest() == 2
	assert_eq(Screen.reads(screen(), "Right: the slowest"), is_slowest)
	await student.press(&"lab_next_step")
	await click_button("1/2")
	assert_reads("No, 1/4")
	assert_eq(frame().lesson.step, 2)


func test_what_is_said_of_each_point_is_true_in_several_problems() -> void:
	_steps().go_to(1)
	for problem: int in [0, 1, 2, 6]:
		await _pick("What is measured", problem)
		await _finish_measuring()
		var there := _run().measurements()
		for place in there.size():
			_plot().call(&"_choose", place)
			await student.settle()
			var beaten := there.any(
				func(other: Measurement) -> bool: return _beats(other, there[place])
			)
			var title := "%s of problem %d" % [there[place].method, problem]
			assert_ne(Screen.reads(screen(), "on the frontier"), beaten, title)
			var fastest: float = there.map(_time_of).min()
			var times := NumberText.short(there[place].run_time_us / fastest, 3)
			assert_eq(_readout_text(3, 3), times, title)
			var judge := LessonJudge.of(&"error_and_time")
			assert_eq(judge.problem(SeenLesson.of(frame())), "", title)
		assert_eq(_model().rank_of_closest(), _rank_of_closest(there), "problem %d" % problem)


func test_the_last_step_shows_the_order_of_the_method_pointed_at() -> void:
	await _finish_measuring()
	_steps().go_to(2)
	var place := _place_with_an_order()
	student.move_to(_pixel(place))
	await student.settle()
	var lines := Screen.lines(frame().lesson.services[&"formula"] as Formula)
	assert_string_contains(lines[0], "p = log( e₁ / e₂ ) / log( t₂ / t₁ )")
	assert_string_contains(lines[3], "p = log( ")
	var shown := lines[3].get_slice(" = ", 2).replace("\u2212", "-").to_float()
	var there := _run().measurements()
	var order := ErrorAndTimeModel.order(
		there[place], there[ErrorAndTimeModel.neighbour(there, place)]
	)
	assert_almost_eq(shown, order, absf(order) * 1e-3)


func test_the_last_step_begins_with_a_mark_that_has_an_order() -> void:
	await _finish_measuring()
	_steps().go_to(2)
	await student.settle()
	assert_eq(_plot().chosen(), ErrorAndTimeModel.place_with_order(_run().measurements()))
	assert_eq(Screen.lines(frame().lesson.services[&"formula"] as Formula).size(), 4)


func test_the_card_beside_a_mark_is_as_high_as_its_words() -> void:
	for problem: int in [4, 5, 6]:
		_steps().go_to(0)
		await _pick("What is measured", problem)
		await _finish_measuring()
		await student.settle()
		_steps().go_to(1)
		await student.settle()
		var card := _plot().get_node("%Card") as Control
		var words := _plot().get_node("%Words") as Label
		var height := words.get_line_count() * words.get_line_height()
		assert_between(card.size.y, 1.0 * height, height + 40.0, "problem %d" % problem)


func test_where_there_is_no_order_the_formula_says_why() -> void:
	await _finish_measuring()
	_steps().go_to(2)
	for place in _run().measurements().size():
		student.move_to(_pixel(place))
		await student.settle()
		var there := _run().measurements()
		var other := ErrorAndTimeModel.neighbour(there, place)
		var has_order := (
			other >= 0 and not is_nan(ErrorAndTimeModel.order(there[place], there[other]))
		)
		assert_eq(
			Screen.lines(frame().lesson.services[&"formula"] as Formula).size() == 4,
			has_order,
			there[place].method
		)
		assert_does_not_read("NaN")


func test_the_scene_says_which_problem_is_measured_first() -> void:
	var ids: PackedStringArray = []
	for problem: ReportProblem in _model().problems:
		ids.append(problem.id)
	var offered := ""
	for property: Dictionary in frame().lesson.get_property_list():
		if property["name"] == "first_problem":
			offered = property["hint_string"]
	assert_eq(offered, ",".join(ids), "the editor offers every problem")
	assert_eq(_model().problem().id, "ball_in_box")


func test_points_appear_one_by_one_while_the_window_stays_alive() -> void:
	var counts: Array[int] = []
	while _run().is_going:
		if not _run().measurements().size() in counts:
			counts.append(_run().measurements().size())
		await get_tree().process_frame
	assert_gt(counts.size(), 3, "%s points were seen" % [counts])


func test_p_stops_where_it_is_and_goes_on() -> void:
	await _measure_again()
	await student.press(&"lab_pause")
	var runs := _run().done_count()
	await student.settle()
	assert_eq(_run().done_count(), runs)
	assert_reads("Stopped after %d of" % runs)
	await student.press(&"lab_pause")
	assert_gt(_run().done_count(), runs)


func test_the_button_stops_and_measures_again() -> void:
	await _measure_again()
	await click_button("Stop")
	assert_false(_run().is_going)
	await click_button("Measure")
	await _finish_measuring()
	await click_button("Measure")
	assert_lt(_run().share(), 1.0)


func test_the_mouse_on_a_point_tells_method_error_and_run_time() -> void:
	await _finish_measuring()
	for place in _run().measurements().size():
		student.move_to(_pixel(place))
		await student.settle()
		var measured := _run().measurements()[place]
		assert_reads(ErrorAndTimeTexts.run_time(measured.run_time_us))
		assert_reads(MeasuredTexts.of(measured.method))
		assert_eq(_plot().chosen(), place)


func test_a_finger_points_too_and_a_touch_beside_all_points_takes_it_back() -> void:
	await _finish_measuring()
	await student.touch(_pixel(0))
	assert_eq(_plot().chosen(), 0)
	await student.touch(_plot().get_global_rect().position + Vector2(4.0, 4.0))
	assert_eq(_plot().chosen(), -1)
	assert_does_not_read("on the frontier")


func test_arrow_keys_and_the_pad_go_from_point_to_point_by_run_time() -> void:
	await _finish_measuring()
	_plot().grab_focus()
	for i: int in 20:
		await student.press(&"ui_left")
	var times: PackedFloat64Array = [_pointed().run_time_us]
	for i: int in 2:
		await student.press_pad(JOY_BUTTON_DPAD_RIGHT)
		times.append(_pointed().run_time_us)
	var sorted := times.duplicate()
	sorted.sort()
	assert_eq(times, sorted)
	assert_lt(times[0], times[2])


func test_the_tab_key_reaches_the_plot() -> void:
	Screen.button(screen(), "View").grab_focus()
	await student.press_key(KEY_TAB)
	assert_true(_plot().has_focus())


func test_another_situation_is_measured_at_once_and_undo_comes_back_to_what_was_found() -> void:
	await _finish_measuring()
	await _pick("The situation", 1)
	assert_eq(_model().situation_place, 1)
	await _finish_measuring()
	await student.press(&"lab_undo")
	assert_eq(_model().situation_place, 0)
	assert_true(_run().is_done())


func test_a_link_to_a_situation_measures_it_at_once() -> void:
	await _finish_measuring()
	frame().follow_link("#error_and_time?situation=1")
	assert_eq(_model().situation_place, 1)
	assert_true(_run().is_going)


func test_reset_measures_again() -> void:
	await _finish_measuring()
	await student.press(&"lab_reset")
	assert_true(_run().is_going)
	await _finish_measuring()
	assert_reads("Done")


func test_the_table_of_stability_is_tried_case_by_case_and_shows_what_holds() -> void:
	await _open_stability()
	assert_false(_plot().is_visible_in_tree())
	assert_true(_table().is_visible_in_tree())
	while _model().stability.is_going:
		await get_tree().process_frame
	await student.settle()
	var run := _model().stability
	assert_gt(run.size(), 20)
	assert_reads("Tried %d of %d: %d hold." % [run.size(), run.size(), run.passed_count()])
	assert_reads("%d more take too long here." % run.left_out.size())
	for place in run.left_out.size():
		var row := _table().row(run.size() + place)
		assert_eq(row.outcome(), StabilityMark.Outcome.LEFT_OUT, run.left_out[place].title)
	for place in run.size():
		var holds := _table().row(place).outcome() == StabilityMark.Outcome.PASSED
		assert_eq(holds, run.results[place].passed, run.cases[place].title)
		assert_reads(run.results[place].figure)
	var judge := LessonJudge.of(&"error_and_time")
	assert_eq(judge.problem(SeenLesson.of(frame())), "")


func test_no_row_says_that_more_was_tried_than_was() -> void:
	await _open_stability()
	await student.settle()
	for place in _model().stability.size():
		var case: StabilityCase = _model().stability.cases[place]
		if case.is_long:
			assert_reads(case.quick_title)
			assert_does_not_read(case.title)


func test_trying_can_be_stopped_and_the_first_page_comes_back_by_undo() -> void:
	await _open_stability()
	await click_button("Stop")
	var done := _model().stability.done_count()
	await student.settle()
	assert_eq(_model().stability.done_count(), done)
	assert_eq(_table().row(done).outcome(), StabilityMark.Outcome.WAITING)
	await student.press(&"lab_undo")
	assert_true(_plot().is_visible_in_tree())


func test_the_table_fits_at_every_size() -> void:
	await _open_stability()
	for size: Vector2i in [
		Vector2i(1280, 720), Vector2i(1920, 1080), Vector2i(800, 600), Vector2i(720, 1280)
	]:
		await resize(size)
		assert_eq(", ".join(Layout.problems(screen())), "", str(size))


func test_a_problem_chosen_from_the_table_leads_back_to_the_plot() -> void:
	await _open_stability()
	await _pick("What is measured", 0)
	assert_true(_plot().is_visible_in_tree())
	assert_eq(_model().problem().id, "scalar_projection")


func test_a_question_names_the_mistake() -> void:
	(frame().lesson.services[&"question"] as FoldableContainer).folded = false
	await student.settle()
	await student.enter(Screen.named(screen(), "p =") as LineEdit, "-2")
	assert_true(Screen.reads(screen(), "positive order") or Screen.reads(screen(), "is not it yet"))


func _model() -> ErrorAndTimeModel:
	return frame().lesson.get(&"_model")


func _steps() -> Steps:
	return frame().lesson.services[&"steps"] as Steps


# Faster and not worse, or closer and not slower.
func _beats(one: Measurement, other: Measurement) -> bool:
	if one.run_time_us > other.run_time_us or not one.error <= other.error:
		return false
	return one.run_time_us < other.run_time_us or one.error < other.error


func _time_of(one: Measurement) -> float:
	return one.run_time_us


# 0 if the smallest error is the fastest one's, 2 if it is the slowest one's, else 1.
func _rank_of_closest(all: Array[Measurement]) -> int:
	if all.size() < 3:
		return -1
	var times: Array = all.map(_time_of)
	var closest := all[0]
	for one in all:
		var is_faster := one.error == closest.error and one.run_time_us < closest.run_time_us
		closest = one if one.error < closest.error or is_faster else closest
	if closest.run_time_us == times.min():
		return 0
	return 2 if closest.run_time_us == times.max() else 1


func _readout_text(row: int, column: int) -> String:
	var readout := frame().lesson.services[&"readout"] as Readout
	return readout.cell(row, column).text


# The last entry in the list of problems.
func _open_stability() -> void:
	await _pick("What is measured", _model().problems.size())


# A measurement that has an order together with its neighbour.
func _place_with_an_order() -> int:
	var there := _run().measurements()
	for place in there.size():
		var other := ErrorAndTimeModel.neighbour(there, place)
		if other >= 0 and not is_nan(ErrorAndTimeModel.order(there[place], there[other])):
			return place
	return -1


func _run() -> MeasuringRun:
	return _model().run()


func _plot() -> LogPlot:
	return frame().lesson.get_node("%Plot") as LogPlot


func _table() -> StabilityTable:
	return frame().lesson.get_node("%Table") as StabilityTable


func _pointed() -> Measurement:
	return _run().measurements()[_plot().chosen()]


func _frontier() -> PackedInt32Array:
	return ErrorAndTimeModel.frontier(_run().measurements())


func _pixel(place: int) -> Vector2:
	return _plot().get_global_transform() * _plot().pixel_of(place)


func _measure_again() -> void:
	await _finish_measuring()
	await click_button("Measure")


func _finish_measuring() -> void:
	while _run().is_going:
		await get_tree().process_frame
	await student.settle()


# Picks an entry of a list by the keyboard.
func _pick(title: String, place: int) -> void:
	var list := Screen.named(screen(), title) as OptionButton
	list.grab_focus()
	await student.press(&"ui_accept")
	for i: int in list.item_count + 1:
		if list.get_popup().get_focused_item() != place:
			await student.press(&"ui_down")
	await student.press(&"ui_accept")
