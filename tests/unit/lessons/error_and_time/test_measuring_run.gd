extends LabTest
## Tests of measuring methods one after the other: progress, end, median.


func test_nothing_goes_before_it_is_begun() -> void:
	var run := MeasuringRun.new(_two_cases())
	run.advance(1000)
	assert_eq(run.done_count(), 0)
	assert_eq(run.measurements().size(), 0)


func test_a_method_appears_once_all_its_runs_are_made() -> void:
	var run := MeasuringRun.new(_two_cases())
	for i: int in 4:
		run.do_next()
	assert_eq(_methods(run), [] as Array[String])
	run.do_next()
	assert_eq(_methods(run), ["slow"] as Array[String])
	assert_eq(run.method_in_turn(), "fast")
	for i: int in 5:
		run.do_next()
	assert_eq(_methods(run), ["slow", "fast"] as Array[String])


func test_it_makes_one_run_at_least_and_ends_by_itself() -> void:
	var run := MeasuringRun.new(_two_cases())
	run.is_going = true
	run.advance(0)
	assert_eq(run.done_count(), 1)
	for i: int in run.size():
		run.advance(0)
	assert_eq(run.done_count(), 10)
	assert_true(run.is_done())
	assert_false(run.is_going)


func test_the_share_grows_evenly() -> void:
	var run := MeasuringRun.new(_two_cases())
	for i: int in 3:
		run.do_next()
	assert_almost_eq(run.share(), 3.0 / 10.0, 1e-12)


func test_the_median_of_the_runs_counts() -> void:
	var run := MeasuringRun.new(_two_cases())
	while not run.is_done():
		run.do_next()
	assert_eq(run.measurements()[0].run_time_us, 30.0)
	assert_eq(run.measurements()[1].run_time_us, 3.0)


func test_each_method_is_named_once_with_whether_it_is_the_engines() -> void:
	var cases := _two_cases()
	cases.append(FakeCase.new("slow", "easy", [1.0]))
	cases[1].is_baseline = true
	var run := MeasuringRun.new(cases)
	assert_eq(run.methods(), PackedStringArray(["slow", "fast"]))
	assert_eq(run.are_baselines(), [false, true] as Array[bool])


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
