class_name AngledLinesTexts
extends RefCounted
## The words and formula lines of the lesson on angled lines.


## The ways of stepping, in the order of [enum SteppingMethods.Method].
static func methods() -> PackedStringArray:
	return [
		_translate("Position reset"),
		_translate("Rest dropped"),
		_translate("Rest used"),
		_translate("Event world"),
	]


## The headings of the comparison after so many frames.
static func headings(frames: int) -> PackedStringArray:
	var seconds := roundi(frames * AngledLinesModel.FRAME)
	return [
		_translate("after %d s") % seconds,
		_translate("E / E₀"),
		_translate("error"),
		_translate("run time"),
	]


## A row of the comparison: what is left of the energy in one way of stepping, how far that is from
## right, and what a frame costs. With C below 1 energy is to be lost, so there is no error to tell.
## Where a ball bounced too often to be moved on, the row says so.
static func comparison(of: MethodComparison, method: SteppingMethods.Method) -> PackedStringArray:
	var share := of.energy_share(method)
	var text := NumberText.short(share)
	if of.lost_count(method):
		text = _translate("%s, %d lost") % [text, of.lost_count(method)]
	if of.refusal(method):
		text = _translate("stopped")
	return [
		_row_title(method),
		text,
		NumberText.size(share - 1.0) if of.keeps_energy() and not of.refusal(method) else "–",
		_translate("%s µs") % NumberText.short(of.microseconds_per_frame(method), 2),
	]


static func _row_title(method: SteppingMethods.Method) -> String:
	match method:
		SteppingMethods.Method.POSITION_RESET:
			return _translate("reset")
		SteppingMethods.Method.POINT_OF_IMPACT:
			return _translate("rest dropped")
		SteppingMethods.Method.WHOLE_FRAME:
			return _translate("rest used")
	return _translate("event world")


## The formula lines; [param has_bounce] where there is a bounce to show.
static func formula_lines(has_bounce: bool) -> PackedStringArray:
	var lines: PackedStringArray = [
		"{g} = ( {gx} , {gy} )    C = {C}",
		"{x} = ( {px} , {py} )   {v} = ( {vx} , {vy} )",
	]
	if has_bounce:
		lines.append("{w} = {v} − (1 + C) ({v} · {n}) {n} = {w_pair}")
		lines.append("   = {v_pair} − {factor} · {vn} {n_pair}")
	return lines


## What stands at the point of impact.
static func impact_label(bounce: BounceRecord) -> String:
	return "t = %s" % NumberText.short(bounce.fraction, 3)


## What the status card says: time, bounces, lost balls, energy, and the script's share of a frame
## of 1/60 s.
static func status(model: AngledLinesModel, milliseconds: float) -> String:
	var world := model.world
	var counters := [world.frames, model.elapsed_seconds(), world.bounces, world.losses]
	var cost := [milliseconds, milliseconds / AngledLinesModel.FRAME / 10.0]
	return (
		_translate("Frame %d = %.2f s    bounces %d    lost %d") % counters
		+ "\n"
		+ _energy(model)
		+ "    "
		+ _translate("script %.2f ms = %.1f %%") % cost
	)


static func _energy(model: AngledLinesModel) -> String:
	var right := _translate("E / E₀ = %s") % _share(model.energy_share(model.world))
	if not model.wrong_world:
		return right
	return right + "    ✗ " + _share(model.energy_share(model.wrong_world))


static func _share(value: float) -> String:
	return NumberText.short(value, 5)


static func _translate(sentence: String) -> String:
	return TranslationServer.translate(sentence)
