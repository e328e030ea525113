extends LabTest
## Tests of the lesson on error and run time: what is chosen, what is kept, frontier and order.

const CollectTexts := preload("res://tools/texts/collect_texts.gd")


## A problem with two situations and known answers.
class FakeProblem:
	extends ReportProblem

	func _init(its_id: String) -> void:
		id = its_id

	func cases(_is_quick: bool) -> Array[MeasuredCase]:
		return [
			FakeCase.new("one", "easy", [1.0]),
			FakeCase.new("one", "hard", [2.0]),
			FakeCase.new("two", "hard", [3.0]),
		]


func test_only_the_situation_that_is_chosen_is_measured() -> void:
	var model := _model()
	assert_eq(model.situations(), PackedStringArray(["easy", "hard"]))
	assert_eq(model.run().methods(), PackedStringArray(["one", "engine"]))
	model.situation_place = 1
	assert_eq(model.run().methods(), PackedStringArray(["one", "two"]))


func test_cases_that_wait_for_frames_are_left_out() -> void:
	var model := _model()
	assert_does_not_have(model.run().methods(), "engine by frames")


func test_what_was_measured_is_kept_while_another_problem_is_looked_at() -> void:
	var model := _model()
	model.run().do_next()
	model.choose_problem(1)
	assert_eq(model.run().done_count(), 0)
	model.choose_problem(0)
	assert_eq(model.run().done_count(), 1)


func test_begin_goes_on_after_a_stop_and_starts_again_after_the_end() -> void:
	var model := _model()
	model.run().do_next()
	model.begin()
	assert_eq(model.run().done_count(), 1)
	while not model.run().is_done():
		model.run().do_next()
	model.begin()
	assert_eq(model.run().done_count(), 0)
	assert_eq(model.run().measurements().size(), 0)
	assert_true(model.run().is_going)


func test_a_stored_choice_is_put_back() -> void:
	var model := _model()
	model.choose_problem(1)
	model.situation_place = 1
	var other := _model()
	other.from_dictionary(model.to_dictionary())
	assert_eq(other.problem().id, "second")
	assert_eq(other.situation_place, 1)
	assert_eq(other.to_dictionary(), model.to_dictionary())


func test_the_frontier_has_who_is_not_beaten_the_fastest_first() -> void:
	var all: Array[Measurement] = [
		_measured("a", 30.0, 0.5), _measured("b", 10.0, 9.0), _measured("c", 40.0, 0.6)
	]
	assert_eq(ErrorAndTimeModel.frontier(all), PackedInt32Array([1, 0]))


func test_the_closest_is_ranked_by_its_run_time_once_all_is_measured() -> void:
	var model := _model()
	model.situation_place = 1
	assert_eq(model.rank_of_closest(), -1)
	while not model.run().is_done():
		model.run().do_next()
	assert_eq(model.rank_of_closest(), -1, "two methods have no middle")


func test_the_neighbour_is_the_next_slower_setting_of_the_same_method() -> void:
	var all: Array[Measurement] = [
		_measured("a", 10.0, 4.0),
		_measured("b", 15.0, 4.0),
		_measured("a", 40.0, 1.0),
		_measured("a", 20.0, 2.0),
	]
	assert_eq(ErrorAndTimeModel.neighbour(all, 0), 3)
	assert_eq(ErrorAndTimeModel.neighbour(all, 2), 3, "the slowest looks back")
	assert_eq(ErrorAndTimeModel.neighbour(all, 1), -1)


func test_the_order_is_the_power_of_the_run_time_in_the_error() -> void:
	for order: int in [1, 2, 4]:
		var one := _measured("a", 7.0, 5.0 / 7.0 ** order)
		var other := _measured("a", 28.0, 5.0 / 28.0 ** order)
		assert_almost_eq(ErrorAndTimeModel.order(one, other), 1.0 * order, 1e-3)
		assert_almost_eq(ErrorAndTimeModel.order(other, one), 1.0 * order, 1e-3)


func test_a_measurement_with_an_order_is_one_whose_error_falls_with_more_time() -> void:
	assert_eq(ErrorAndTimeModel.place_with_order([]), -1)
	var grows: Array[Measurement] = [_measured("a", 1.0, 1.0), _measured("a", 2.0, 3.0)]
	assert_eq(ErrorAndTimeModel.place_with_order(grows), -1)
	var falls: Array[Measurement] = [_measured("b", 1.0, 4.0), _measured("b", 2.0, 1.0)]
	assert_eq(ErrorAndTimeModel.place_with_order(grows + falls), 2)


func test_the_order_fits_the_ratios_as_they_are_shown() -> void:
	var one := _measured("a", 100.0, 3.0)
	var other := _measured("a", 101.2345, 1.0)
	assert_almost_eq(ErrorAndTimeModel.order(one, other), log(3.0) / log(1.012), 1e-12)


func test_there_is_no_order_without_an_error_or_an_answer() -> void:
	var one := _measured("a", 10.0, 1.0)
	for other: Measurement in [
		_measured("a", 20.0, 0.0), _measured("a", 20.0, INF), _measured("a", 10.0, 0.5)
	]:
		assert_true(is_nan(ErrorAndTimeModel.order(one, other)))


func test_every_name_of_every_problem_is_known_to_the_translation() -> void:
	var known := CollectTexts.messages()
	var unknown: Array[String] = []
	for text in _all_names():
		if not text in unknown and RegEx.create_from_string("\\p{L}{3}").search(text):
			if not known.has(MeasuredTexts.pattern(text)):
				unknown.append(text)
	assert_eq(unknown, [] as Array[String], "these texts are missing in measured_texts.gd")


# As the cases make them, with their numbers.
func test_what_is_said_beside_a_measurement_is_known_to_the_translation() -> void:
	var known := CollectTexts.messages()
	for note: String in [
		"never 1 px off in 33 bounces, 2.50 s",
		"never 1 px off in 1 bounce, 0.50 s",
		"1 px off after 1 bounce, 0.50 s",
		"1 px off after 33 bounces, 2.50 s",
		"after 12 bounces",
		"energy off by 2e-9 of itself; reversed, never 1 px off its own way in all of 2.0 s",
		"energy off by 0 of itself; reversed, 1 px off its own way after 0.25 s of 2.0 s",
		"energy off by 0.01 of itself; 7 collisions a second",
		"no finite answer for 3 of 1000 pairs",
		"not flown to the end yet",
		"31 impacts, 31 are right",
	]:
		for part in note.split("; "):
			assert_has(known, MeasuredTexts.pattern(part))
		assert_eq(MeasuredTexts.of(note), note)


func test_names_of_problems_are_no_texts() -> void:
	var known := CollectTexts.messages()
	for problem in LiveProblems.all():
		assert_does_not_have(known, problem.id)


func test_numbers_in_a_name_stay_as_they_are() -> void:
	for text: String in ["240 steps a second", "1e-30 to 1e30 px", "m 1:2.5, 100 % of it"]:
		assert_eq(MeasuredTexts.of(text), text)
	assert_eq(MeasuredTexts.pattern("1e-30 to 1e30 px"), "%s to %s px")


func _model() -> ErrorAndTimeModel:
	var model := ErrorAndTimeModel.new(
		func(_id: String) -> Array[MeasuredCase]:
			var slow := FakeCase.new("engine by frames", "easy", [1.0])
			slow.needs_frames = true
			return [FakeCase.new("engine", "easy", [4.0]), slow]
	)
	model.problems = [FakeProblem.new("first"), FakeProblem.new("second")]
	model.choose_problem(0)
	return model


func _measured(method: String, run_time_us: float, error: float) -> Measurement:
	var measurement := Measurement.new()
	measurement.problem = "fake"
	measurement.method = method
	measurement.run_time_us = run_time_us
	measurement.error = error
	return measurement


# The lesson with the real problems of the report.
func _all_names() -> PackedStringArray:
	var host := Node.new()
	add_child_autofree(host)
	var names: PackedStringArray = []
	for problem in LiveProblems.all():
		names.append_array([problem.run_time_axis, problem.error_axis])
		assert_ne(MeasuredTexts.title(problem.id), problem.id, "a title for " + problem.id)
		for case in problem.cases(true) + EngineCases.of(problem.id, true, host):
			names.append_array([case.method, case.situation, case.tuning, case.error_unit])
			case.finish()
	return names
