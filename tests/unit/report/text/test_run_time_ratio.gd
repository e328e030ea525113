extends LabTest
## The run times of one report against those of another.


func test_one_report_on_each_side_has_the_spread_of_its_runs() -> void:
	var ratio := _ratio([_row(10.0, 8.0, 12.5)], [_row(20.0, 18.75, 24.0)])
	assert_eq([ratio.ratio, ratio.least, ratio.largest], [2.0, 1.5, 3.0])
	assert_true(ratio.is_clear())


func test_several_reports_have_the_spread_of_their_medians() -> void:
	var olds: Array[Measurement] = [_row(10.0), _row(8.0), _row(16.0)]
	var news: Array[Measurement] = [_row(20.0), _row(4.0)]
	var ratio := _ratio(olds, news)
	assert_eq([ratio.ratio, ratio.least, ratio.largest], [1.2, 0.25, 2.5])
	assert_false(ratio.is_clear())


func test_without_quartiles_there_is_no_spread() -> void:
	var ratio := _ratio([_row(10.0)], [_row(20.0, 18.0, 24.0)])
	assert_eq(ratio.ratio, 2.0)
	assert_true(is_nan(ratio.least) and is_nan(ratio.largest))
	assert_false(ratio.is_clear())


func test_only_rows_that_are_in_all_reports_are_compared() -> void:
	var other := _row(3.0)
	other.method = "another"
	assert_eq(RunTimeRatio.of([[_row(1.0)]], [[other, _row(2.0)]]).size(), 1)
	assert_eq(RunTimeRatio.of([[_row(1.0)], [other]], [[_row(2.0)]]).size(), 0)
	assert_eq(RunTimeRatio.of([[_row(0.0)]], [[_row(2.0)]]).size(), 0)
	assert_eq(RunTimeRatio.of([], [[_row(2.0)]]).size(), 0)


func test_the_lab_and_its_baselines_have_separate_medians() -> void:
	var baselines: Array[Measurement] = [_row(5.0), _row(6.0)]
	for baseline in baselines:
		baseline.method = "engine"
		baseline.is_baseline = true
	var ratios := RunTimeRatio.of([[_row(1.0), baselines[0]]], [[_row(3.0), baselines[1]]])
	assert_eq(RunTimeRatio.median_of(ratios, false), 3.0)
	assert_almost_eq(RunTimeRatio.median_of(ratios, true), 1.2, 1e-15)
	assert_true(is_nan(RunTimeRatio.median_of([], true)))


func test_the_text_marks_what_differs_by_more_than_its_spread() -> void:
	var clear := RunTimeRatio.of([[_row(10.0, 8.0, 12.5)]], [[_row(20.0, 18.75, 24.0)]])
	var text := ComparisonText.of(clear, 1, 1)
	assert_string_contains(text, "| box | way, 300 px/s | **2.000** (1.500 to 3.000) |")
	assert_string_contains(text, "the lab's own methods 2.000, baselines none.")
	var unknown := ComparisonText.of(RunTimeRatio.of([[_row(10.0)]], [[_row(20.0)]]), 1, 1)
	assert_string_contains(unknown, "| 2.000 (spread unknown) |")
	assert_string_contains(ComparisonText.of([], 1, 1), "No row is in all of these reports.")


func _ratio(olds: Array[Measurement], news: Array[Measurement]) -> RunTimeRatio:
	return RunTimeRatio.of(_reports(olds), _reports(news))[0]


## A report for each row.
func _reports(rows: Array[Measurement]) -> Array[Array]:
	var reports: Array[Array] = []
	for row in rows:
		reports.append([row])
	return reports


func _row(time: float, lower: float = NAN, upper: float = NAN) -> Measurement:
	var row := Measurement.new()
	row.problem = "box"
	row.method = "way"
	row.situation = "300 px/s"
	row.run_time_us = time
	row.lower_quartile_us = lower
	row.upper_quartile_us = upper
	return row
