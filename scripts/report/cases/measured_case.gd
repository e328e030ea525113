@abstract class_name MeasuredCase
extends RefCounted
## One case to measure: a method in a situation, run several times.
##
## The caller runs each case once by [method run_once], then each a second time, and so on, so that
## a slow moment of the machine affects all alike. Then it asks for [method result].

## The problem's id; see [member Measurement.problem].
var problem := ""
## See [member Measurement.method].
var method := ""
## See [member Measurement.situation].
var situation := ""
## See [member Measurement.tuning].
var tuning := ""
## [member situation] and [member tuning] in one text.
var setting: String:
	get:
		return Measurement.setting_of(situation, tuning)
## See [member Measurement.is_baseline].
var is_baseline := false
## Whether a run waits for physics frames of the engine. Its run time is right only where these come
## as fast as they can: headless with --fixed-fps.
var needs_frames := false
## See [member Measurement.error]; known after the first run.
var error := 0.0
## See [member Measurement.error_unit].
var error_unit := "px"
## See [member Measurement.note].
var note := ""
## See [member Measurement.figures].
var figures: Dictionary[String, float] = {}
## The first sentence with which a world refused what this case needs; "" if none did. Then the case
## has measured nothing, and [method result] says so.
var refusal := ""

var _run_times: PackedFloat64Array = []

## Runs the case once and keeps its time by [method keep_run]. It must be awaited if
## [member needs_frames] is set. In the quick form it takes at most about 50 ms.
@abstract func run_once() -> void


## Frees what the case holds, such as nodes; call it after the last run.
func finish() -> void:
	pass


## Keeps the time of one run, in microseconds, in the unit of [member Measurement.run_time_us].
func keep_run(run_time_us: float) -> void:
	_run_times.append(run_time_us)


## Keeps the answer of a world that must not refuse, "" or a sentence.
func keep_refusal(answer: String) -> void:
	if refusal == "":
		refusal = answer


## The number of runs that have been kept.
func runs() -> int:
	return _run_times.size()


## What has been found so far: the run time is the median of the runs, 0 before the first. A case
## whose world has refused has no answer and no run time, and its note is the refusal.
func result() -> Measurement:
	var measurement := Measurement.new()
	measurement.problem = problem
	measurement.method = method
	measurement.situation = situation
	measurement.tuning = tuning
	measurement.is_baseline = is_baseline
	measurement.run_time_us = median(_run_times)
	if runs() > 0:
		measurement.lower_quartile_us = quantile(_run_times, 0.25)
		measurement.upper_quartile_us = quantile(_run_times, 0.75)
	measurement.error = error
	measurement.error_unit = error_unit
	measurement.note = note
	measurement.figures = figures.duplicate()
	if refusal:
		measurement.run_time_us = Measurement.NO_ANSWER
		measurement.error = Measurement.NO_ANSWER
		measurement.note = refusal
		measurement.figures.clear()
	return measurement


## The median: the middle value, or the mean of the two middle values; 0 if there is none.
static func median(values: PackedFloat64Array) -> float:
	return quantile(values, 0.5)


## The value that [param share] of the values do not exceed, with 0 the least and 1 the largest of
## them; between two values their weighted mean. 0 if there is no value.
static func quantile(values: PackedFloat64Array, share: float) -> float:
	if values.is_empty():
		return 0.0
	var sorted := values.duplicate()
	sorted.sort()
	var place := share * (sorted.size() - 1)
	var below := floori(place)
	var above := mini(below + 1, sorted.size() - 1)
	if below == place:
		return sorted[below]
	return sorted[below] * (above - place) + sorted[above] * (place - below)
