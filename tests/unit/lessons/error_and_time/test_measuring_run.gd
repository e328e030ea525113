extends LabTest
## Tests of measuring methods in turn: order, progress, end, median.


func test_nothing_goes_before_it_is_begun() -> void:
	var run := MeasuringRun.new(_two_cases())
	assert_false(run.is_going)
	assert_eq(run.measurements().size(), 0)


func test_methods_are_run_in_turn_and_appear_one_by_one() -> void:
	var run := MeasuringRun.new(_two_cases())
	run.measure_next()
	assert_eq(_methods(run), ["slow"])
	run.measure_next()
	assert_eq(_methods(run), ["slow", "fast"])
	run.measure_next()
	assert_eq(_methods(run), ["slow", "fast"])


func test_it_ends_by_itself_after_all_rounds() -> void:
	var run := MeasuringRun.new(_two_cases())
	run.is_going = true
	for i: int in run.all_runs():
		assert_true(run.is_going)
		run.measure_next()
	assert_false(run.is_going)
	assert_true(run.is_done())
	assert_eq(run.share(), 1.0)


func test_the_share_grows_evenly() -> void:
	var run := MeasuringRun.new(_two_cases())
	for i: int in 3:
		run.measure_next()
	assert_almost_eq(run.share(), 3.0 / 10.0, 1e-12)


func test_the_median_of_the_runs_counts() -> void:
	var run := MeasuringRun.new(_two_cases())
	while not run.is_done():
		run.measure_next()
	assert_eq(run.measurements()[0].run_time_us, 30.0)
	assert_eq(run.measurements()[1].run_time_us, 3.0)


func test_each_method_is_named_once_with_whether_it_is_the_engines() -> void:
	var cases := _two_cases()
	cases.append(FakeCase.new("slow", "easy", [1.0]))
	cases[1].is_peer = true
	var run := MeasuringRun.new(cases)
	assert_eq(run.methods(), PackedStringArray(["slow", "fast"]))
	assert_eq(run.are_peers(), [false, true] as Array[bool])


func _two_cases() -> Array[MeasuredCase]:
	return [
		FakeCase.new("slow", "easy", [10.0, 90.0, 30.0, 20.0, 40.0]),
		FakeCase.new("fast", "easy", [3.0, 1.0, 900.0, 2.0, 4.0]),
	]


func _methods(run: MeasuringRun) -> Array[String]:
	var found: Array[String] = []
	for measurement in run.measurements():
		found.append(measurement.method)
	return found
