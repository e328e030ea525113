class_name RunTimeRatio
extends RefCounted
## How many times as long one row of the report takes now as in an older report.
##
## The spread says how far the ratio can be trusted. Where a side has several reports, it goes from
## the least to the largest of their run times. Where it has one, it goes from the lower to the
## upper quartile of the runs in that report. A report from before the quartiles were kept has no
## spread of its own.

## The id of the problem.
var problem := ""
## The method and its setting.
var title := ""
## See [member Measurement.is_baseline].
var is_baseline := false
## The new run time over the old one; both are the medians of the reports on their side.
var ratio := 0.0
## The least ratio within the spread; NAN where a side has no spread.
var least := NAN
## The largest ratio within the spread; NAN where a side has no spread.
var largest := NAN


## Whether the whole spread is on one side of 1. False where there is no spread.
func is_clear() -> bool:
	return least > 1.0 or largest < 1.0


## A ratio for each row that is in every report of both sides, in the order of the first new one.
## Rows without a run time are left out.
static func of(olds: Array[Array], news: Array[Array]) -> Array[RunTimeRatio]:
	var found: Array[RunTimeRatio] = []
	if olds.is_empty() or news.is_empty():
		return found
	for row: Measurement in news[0]:
		var old_rows := _same_row(row, olds)
		var new_rows := _same_row(row, news)
		if old_rows.size() == olds.size() and new_rows.size() == news.size():
			found.append(_of_rows(old_rows, new_rows))
	return found


## The middle one of the ratios of the lab's own methods, or of its baselines; NAN if there is none.
static func median_of(ratios: Array[RunTimeRatio], baselines: bool) -> float:
	var values: PackedFloat64Array = []
	for one in ratios:
		if one.is_baseline == baselines:
			values.append(one.ratio)
	return MeasuredCase.median(values) if values.size() > 0 else NAN


static func _of_rows(olds: Array[Measurement], news: Array[Measurement]) -> RunTimeRatio:
	var made := RunTimeRatio.new()
	made.problem = news[0].problem
	made.title = "%s, %s" % [news[0].method, news[0].setting]
	made.is_baseline = news[0].is_baseline
	var old := _spread(olds)
	var new := _spread(news)
	made.ratio = new[1] / old[1]
	made.least = new[0] / old[2]
	made.largest = new[2] / old[0]
	return made


## The lower end of the spread, the run time, and the upper end.
static func _spread(rows: Array[Measurement]) -> PackedFloat64Array:
	if rows.size() == 1:
		return [rows[0].lower_quartile_us, rows[0].run_time_us, rows[0].upper_quartile_us]
	var times: PackedFloat64Array = []
	for row in rows:
		times.append(row.run_time_us)
	times.sort()
	return [times[0], MeasuredCase.median(times), times[-1]]


static func _same_row(row: Measurement, reports: Array[Array]) -> Array[Measurement]:
	var found: Array[Measurement] = []
	for report in reports:
		for other: Measurement in report:
			if _key(other) == _key(row) and _has_time(other):
				found.append(other)
				break
	return found


static func _has_time(row: Measurement) -> bool:
	return row.run_time_us > 0.0 and is_finite(row.run_time_us)


static func _key(row: Measurement) -> Array:
	return [row.problem, row.method, row.setting]
