class_name AngledLinesTexts
extends RefCounted
## The words of the lesson on angled lines.


## The ways of stepping, in the order of [enum SteppingMethods.Method].
static func methods() -> PackedStringArray:
	return [
		LabText.translate("Position reset"),
		LabText.translate("Rest dropped"),
		LabText.translate("Rest used"),
		LabText.translate("Event world"),
	]


## The headings of the comparison after [param frames] frames.
static func headings(frames: int) -> PackedStringArray:
	var seconds := roundi(frames * AngledLinesModel.FRAME)
	return [
		LabText.translate("after %d s") % seconds,
		LabText.translate("E / E₀"),
		LabText.translate("error"),
		LabText.translate("run time"),
	]


## A row of the comparison: the energy that is left in one way of stepping, its error, and the run
## time of a frame. With C below 1 energy must be lost, and so there is no error to show. Where a
## ball bounced too often to be moved on, the row says so.
static func comparison(of: MethodComparison, method: SteppingMethods.Method) -> PackedStringArray:
	var share := of.energy_share(method)
	var text := NumberText.short(share)
	if of.lost_count(method):
		text = LabText.translate("%s, %d lost") % [text, of.lost_count(method)]
	if of.refusal(method):
		text = LabText.translate("stopped")
	return [
		_row_title(method),
		text,
		NumberText.size(share - 1.0) if of.keeps_energy() and not of.refusal(method) else "–",
		LabText.translate("%s µs") % NumberText.short(of.microseconds_per_frame(method), 2),
	]


static func _row_title(method: SteppingMethods.Method) -> String:
	match method:
		SteppingMethods.Method.POSITION_RESET:
			return LabText.translate("reset")
		SteppingMethods.Method.POINT_OF_IMPACT:
			return LabText.translate("rest dropped")
		SteppingMethods.Method.WHOLE_FRAME:
			return LabText.translate("rest used")
	return LabText.translate("event world")


## The note at the point of impact.
static func impact_label(bounce: BounceRecord) -> String:
	return "t = %s" % NumberText.short(bounce.fraction, 3)


## The lines of the status card: time, bounces, lost balls, energy, and the script's share of a
## frame of 1/60 s.
static func status(model: AngledLinesModel, milliseconds: float) -> String:
	var world := model.world
	var counters := [world.frames, model.elapsed_seconds(), world.bounces, world.losses]
	var cost := [milliseconds, milliseconds / AngledLinesModel.FRAME / 10.0]
	return (
		LabText.translate("Frame %d = %.2f s    bounces %d    lost %d") % counters
		+ "\n"
		+ _energy(model)
		+ "    "
		+ LabText.translate("script %.2f ms = %.1f %%") % cost
	)


static func _energy(model: AngledLinesModel) -> String:
	var right := LabText.translate("E / E₀ = %s") % _share(model.energy_share(model.world))
	if not model.wrong_world:
		return right
	return right + "    ✗ " + _share(model.energy_share(model.wrong_world))


static func _share(value: float) -> String:
	return NumberText.short(value, 5)
