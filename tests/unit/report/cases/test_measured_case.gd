extends LabTest
## A case keeps its runs, and its result is what can stand in the report.


func test_the_run_time_is_the_median_of_the_runs() -> void:
	var case := _Still.new()
	for time: float in [5.0, 1.0, 400.0, 2.0, 3.0]:
		case.keep_run(time)
	assert_eq(case.result().run_time_us, 3.0)
	assert_eq(case.runs(), 5)


func test_the_median_of_an_even_number_is_between_the_middle_two() -> void:
	assert_eq(MeasuredCase.median([4.0, 1.0, 2.0, 9.0]), 3.0)


func test_the_median_of_nothing_is_zero() -> void:
	assert_eq(MeasuredCase.median([]), 0.0)


func test_the_result_tells_problem_method_setting_and_error() -> void:
	var case := _Still.new()
	case.problem = "a problem"
	case.method = "a method"
	case.situation = "300 px/s"
	case.tuning = "60 Hz"
	case.is_peer = true
	case.error = 0.25
	case.figures["drift"] = 2.0
	var result := case.result()
	assert_eq([result.problem, result.method, result.error], ["a problem", "a method", 0.25])
	assert_eq([result.setting, case.setting], ["300 px/s, 60 Hz", "300 px/s, 60 Hz"])
	assert_true(result.is_peer)
	assert_eq(result.figures, {"drift": 2.0} as Dictionary[String, float])


func test_a_result_does_not_change_with_later_runs() -> void:
	var case := _Still.new()
	case.keep_run(1.0)
	var early := case.result()
	case.keep_run(100.0)
	case.figures["drift"] = 1.0
	assert_eq(early.run_time_us, 1.0)
	assert_eq(early.figures.size(), 0)


func test_a_setting_without_tuning_is_the_situation() -> void:
	assert_eq(Measurement.setting_of("10 balls", ""), "10 balls")


class _Still:
	extends MeasuredCase

	func run_once() -> void:
		keep_run(1.0)
