class_name ErrorAndTimeTexts
extends RefCounted
## The sentences of the lesson on error and run time.

## The unit of an error that is 1 over the number of bounces which were right.
const BOUNCES := "1/bounces"


## What the steps say.
static func steps() -> PackedStringArray:
	return [
		(
			LabText
			. translate(
				"Each mark is a method at one setting: further left is faster, lower is closer to the truth."
			)
		),
		LabText.translate(
			"The dashed frontier joins the best: no other mark is both faster and closer."
		),
		(
			LabText
			. translate(
				"Point at a mark on a line to see its order p. p = 2: twice the time leaves 1/4 of the error."
			)
		),
	]


## What is asked before the frontier is shown.
static func closest_prompt() -> String:
	return LabText.translate("Read the plot: which mark has the smallest error?")


## The answers to that, in the order of [method ErrorAndTimeModel.rank_of_closest].
static func ranks() -> PackedStringArray:
	return [
		LabText.translate("the fastest"),
		LabText.translate("one in between"),
		LabText.translate("the slowest"),
	]


## What is asked before the order is shown.
static func order_prompt() -> String:
	return LabText.translate(
		"A method of order 2 gets twice the time. How much of its error is left?"
	)


## The answers to that.
static func remainders() -> PackedStringArray:
	return ["1/2", "1/4", "1/8"]


## The lines of the card beside a point that is pointed at.
static func words(measurement: Measurement, is_best: bool) -> PackedStringArray:
	var found: PackedStringArray = [MeasuredTexts.of(measurement.method)]
	if measurement.tuning:
		found.append(MeasuredTexts.of(measurement.tuning))
	found.append(
		(
			LabText.translate("error %s, run time %s")
			% [error(measurement), run_time(measurement.run_time_us)]
		)
	)
	if measurement.note:
		found.append(MeasuredTexts.of(measurement.note))
	if is_best:
		found.append(LabText.translate("on the frontier"))
	return found


## An error with its unit.
static func error(measurement: Measurement) -> String:
	if not measurement.has_answer():
		return LabText.translate("no answer")
	var size := NumberText.size(measurement.error)
	if measurement.error_unit == BOUNCES:
		return LabText.translate("%s = 1 / bounces") % size
	return "%s %s" % [size, MeasuredTexts.of(measurement.error_unit)]


## A time in the unit that suits it.
static func run_time(microseconds: float) -> String:
	if microseconds < 1.0:
		return LabText.translate("%s ns") % NumberText.short(microseconds * 1000.0, 3)
	if microseconds < 1000.0:
		return LabText.translate("%s µs") % NumberText.short(microseconds, 3)
	return LabText.translate("%s ms") % NumberText.short(microseconds / 1000.0, 3)


## How far the work that [param model] shows is.
static func progress(model: ErrorAndTimeModel) -> String:
	if model.is_stability_open:
		return _progress_of_stability(model.stability)
	return _progress_of_run(model.run())


static func _progress_of_stability(run: StabilityRun) -> String:
	var counts: Array[int] = [run.done_count(), run.size(), run.passed_count()]
	var sentence := LabText.translate("Tried %d of %d: %d hold.") % counts
	if run.is_done():
		sentence += " " + LabText.translate("%d more take too long here.") % run.left_out.size()
	return sentence


static func _progress_of_run(run: MeasuringRun) -> String:
	if run.is_done():
		if run.methods().size() == 1:
			return LabText.translate("Only one method can be measured here; ./lab report has more.")
		var done := LabText.translate(
			"Done: the median of %d runs of each method, on this machine."
		)
		return done % MeasuringRun.ROUNDS
	var counts: Array[int] = [run.done_count(), run.size()]
	if run.is_going:
		var method := MeasuredTexts.of(run.method_in_turn())
		return LabText.translate("Run %d of %d: ") % counts + method
	return LabText.translate("Stopped after %d of %d runs.") % counts
