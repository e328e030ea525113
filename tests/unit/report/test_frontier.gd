extends LabTest
## Which methods are on the frontier between error and run time.


func test_the_fast_one_and_the_exact_one_are_both_on_it() -> void:
	var found := Frontier.of([_made("exact", 9.0, 1e-9), _made("fast", 1.0, 5.0)])
	assert_eq(_methods(found), ["fast", "exact"], "the fastest first")


func test_one_that_is_slower_and_less_exact_than_another_is_not() -> void:
	var rows: Array[Measurement] = [
		_made("a", 1.0, 5.0), _made("beaten", 3.0, 4.0), _made("b", 2.0, 3.0)
	]
	assert_eq(_methods(Frontier.of(rows)), ["a", "b"])


func test_equal_ones_do_not_beat_each_other() -> void:
	assert_eq(_methods(Frontier.of([_made("a", 1.0, 2.0), _made("b", 1.0, 2.0)])).size(), 2)


func test_as_exact_but_slower_is_beaten() -> void:
	assert_eq(_methods(Frontier.of([_made("a", 1.0, 0.0), _made("b", 1.5, 0.0)])), ["a"])


func test_one_without_an_answer_is_on_no_frontier() -> void:
	var rows: Array[Measurement] = [_made("lost", 0.1, Measurement.NO_ANSWER), _made("a", 1.0, 1.0)]
	assert_eq(_methods(Frontier.of(rows)), ["a"])


func test_different_situations_are_not_compared() -> void:
	var rows: Array[Measurement] = [_made("a", 1.0, 1.0), _made("b", 2.0, 2.0)]
	rows[1].situation = "faster"
	assert_eq(Frontier.of(rows).size(), 2)
	rows[1].situation = ""
	rows[1].problem = "other"
	assert_eq(Frontier.of(rows).size(), 2)


func test_one_setting_of_a_method_can_beat_another_setting() -> void:
	var rows: Array[Measurement] = [_made("a", 1.0, 1.0), _made("a", 2.0, 2.0)]
	rows[1].tuning = "60 Hz"
	assert_eq(Frontier.of(rows).size(), 1)


func _made(method: String, run_time_us: float, error: float) -> Measurement:
	var measurement := Measurement.new()
	measurement.problem = "some"
	measurement.method = method
	measurement.run_time_us = run_time_us
	measurement.error = error
	return measurement


func _methods(rows: Array[Measurement]) -> Array[String]:
	var found: Array[String] = []
	for row in rows:
		found.append(row.method)
	return found
