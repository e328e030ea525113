class_name ErrorAndTimeTexts
extends RefCounted
## The sentences and formula lines of the lesson on error and run time.


## What stands beside a point that is pointed at, a line each.
static func words(measurement: Measurement, is_best: bool) -> PackedStringArray:
	var found: PackedStringArray = [MeasuredWords.of(measurement.method)]
	if measurement.tuning:
		found.append(MeasuredWords.of(measurement.tuning))
	found.append(
		(
			_translate("error %s, run time %s")
			% [error(measurement), run_time(measurement.run_time_us)]
		)
	)
	if measurement.note:
		found.append(MeasuredWords.of(measurement.note))
	if is_best:
		found.append(_translate("on the frontier"))
	return found


## An error with its unit.
static func error(measurement: Measurement) -> String:
	if not measurement.has_answer():
		return _translate("no answer")
	var unit := MeasuredWords.of(measurement.error_unit)
	return "%s %s" % [NumberText.size(measurement.error), unit]


## A time in the unit that suits it.
static func run_time(microseconds: float) -> String:
	if microseconds < 1.0:
		return _translate("%s ns") % NumberText.short(microseconds * 1000.0, 3)
	if microseconds < 1000.0:
		return _translate("%s µs") % NumberText.short(microseconds, 3)
	return _translate("%s ms") % NumberText.short(microseconds / 1000.0, 3)


## How far the measuring is.
static func progress(run: MeasuringRun) -> String:
	if run.is_done():
		var done := _translate("Done: the middle one of %d runs each, on this machine.")
		return done % MeasuringRun.ROUNDS
	var counts: Array[int] = [run.done_count(), run.size()]
	if run.is_going:
		var method := MeasuredWords.of(run.method_in_turn())
		return _translate("Run %d of %d: ") % counts + method
	return _translate("Stopped after %d of %d runs.") % counts


## How far the table of stability is.
static func stability_progress(run: StabilityRun) -> String:
	var counts: Array[int] = [run.passed_count(), run.done_count(), run.size()]
	return _translate("%d of %d tried hold; %d in all.") % counts


## The headings of the readout.
static func headings() -> PackedStringArray:
	return ["", _translate("error"), _translate("run time"), _translate("× time")]


## A row of the readout on [param measurement]; null where there is none.
static func row(title: String, measurement: Measurement, fastest: Measurement) -> PackedStringArray:
	if not measurement:
		return [title, "–", "–", "–"]
	var error_text := "∞" if not measurement.has_answer() else NumberText.size(measurement.error)
	var times := measurement.run_time_us / fastest.run_time_us
	return [title, error_text, run_time(measurement.run_time_us), NumberText.short(times, 3)]


## The formula lines on the order of the method that is pointed at. [param has_settings] where it
## has two settings to compare, [param has_order] where their errors can be compared, too.
static func formula_lines(has_settings: bool, has_order: bool) -> PackedStringArray:
	var order := "{p} = log( {e1} / {e2} ) / log( {t2} / {t1} )"
	if has_order:
		return [
			order + " = {p_number}",
			"{e1} / {e2} = {e1_number} / {e2_number}",
			"{t2} / {t1} = {t2_number} / {t1_number}",
		]
	if has_settings:
		return [order, _translate("An error of 0, or no answer,"), _translate("has no order.")]
	return [
		order,
		_translate("Point at a method with several settings:"),
		_translate("its slope is the order p."),
	]


static func _translate(sentence: String) -> String:
	return TranslationServer.translate(sentence)
