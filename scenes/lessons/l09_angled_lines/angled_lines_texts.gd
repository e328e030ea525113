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


## The kinds of line: those that end come first.
static func kinds_of_line() -> PackedStringArray:
	return [
		LabText.translate("Lines that end, two sides"),
		LabText.translate("Endless lines, one side"),
	]


## The titles of the presets, each with its key if it has one.
static func scenes() -> PackedStringArray:
	var titles: PackedStringArray = []
	for key in AngledLinesPresets.TITLES.size():
		var title := LabText.translate(AngledLinesPresets.TITLES[key])
		titles.append("%d  %s" % [key, title] if key <= 9 else title)
	return titles


## What the steps say of [param model], where [param forecast] is the path to come; null while it is
## not shown, because time runs.
static func steps(model: AngledLinesModel, forecast: BallForecast) -> PackedStringArray:
	if model.has_endless_lines:
		return [
			LabText.translate("Week 4: lines are endless and work on the side to which n̂ points."),
			_bounce_step(model, forecast),
			LabText.translate(
				"A ball behind a line is put before it. Next time: lines end, and have two sides."
			),
		]
	var texts: PackedStringArray = [
		(
			LabText
			. translate(
				"Drag on the board to draw a line. Drag ball, v, g or a line. To delete one, click it, then ✕."
			)
		),
		_bounce_step(model, forecast),
		(
			LabText
			. translate(
				"The same minute, stepped in four ways. The energy E must never grow; with C = 1 it must stay."
			)
		),
	]
	for step in texts.size():
		texts[step] = (texts[step] + " " + _growth(model)).strip_edges()
	return texts


# Why the card shows too much energy; "" where it does not. Only dropping the rest needs words: by
# position reset the ball is seen to be lifted.
static func _growth(model: AngledLinesModel) -> String:
	if model.method != SteppingMethods.Method.POINT_OF_IMPACT:
		return ""
	if not _is_too_much(model.energy_share(model.world)):
		return ""
	return LabText.translate("A ball on a line stays there while gravity adds to v: E grows.")


static func _bounce_step(model: AngledLinesModel, forecast: BallForecast) -> String:
	if model.world.is_lost[model.selected] == 1:
		return LabText.translate("The ball is lost: it has left the board.")
	if not forecast and model.last_bounce:
		return LabText.translate(
			"At its last bounce v₁ turned into v₂. Pause to see the path to come."
		)
	if not forecast:
		return LabText.translate("It has not bounced yet. Pause to see the path to come.")
	if not forecast.next_bounce:
		return LabText.translate("The dots show its path in the next 1.5 s: no bounce.")
	return LabText.translate(
		"The dots show its path. At the ring the ball touches a line: v₁ turns into v₂."
	)


## What is asked before the path is shown.
static func touch_prompt() -> String:
	return LabText.translate(
		"Where is the ball's centre at its next touch? Drag the “?” there, then step forward."
	)


## What is asked before the comparison is shown.
static func energy_prompt() -> String:
	return LabText.translate(
		"With gravity and C = 1: which way of stepping lets a ball jump higher and higher?"
	)


## The place of the right one of [method ways] for [method energy_prompt]; -1 with endless lines,
## where nothing is compared.
static func right_way(model: AngledLinesModel) -> int:
	return -1 if model.has_endless_lines else SteppingMethods.Method.POSITION_RESET


## The headings of the comparison after [param frames] frames. It goes on only while time stands
## still.
static func headings(frames: int) -> PackedStringArray:
	var seconds := roundi(frames * AngledLinesModel.FRAME)
	var after := LabText.translate("after %d s") % seconds
	return [
		after if frames > 0 else LabText.translate("pause first"),
		LabText.translate("E / E₀"),
		LabText.translate("error"),
		LabText.translate("run time"),
	]


## A row of the comparison: the energy that is left in one way of stepping, its error, and the run
## time of a frame. Nothing is told before the first frame. Where a ball bounced too often to be
## moved on, or was lost, the row says so.
static func comparison(of: MethodComparison, method: SteppingMethods.Method) -> PackedStringArray:
	if of.frames() == 0:
		return [ways()[method], "–", "–", "–"]
	var share := of.energy_share(method)
	var run_time := NumberText.short(of.microseconds_per_frame(method), 2)
	var row: PackedStringArray = [
		ways()[method], _share(share, 4), "–", LabText.translate("%s µs") % run_time
	]
	if of.refusal(method):
		row[1] = LabText.translate("stopped")
	elif of.lost_count(method):
		row[1] = LabText.translate("%d lost") % of.lost_count(method)
	elif is_finite(share):
		row[2] = _energy_error(share, of.keeps_energy())
	return row


# With C below 1 energy must be lost, and so only what is too much is an error.
static func _energy_error(share: float, keeps_energy: bool) -> String:
	if keeps_energy:
		return NumberText.size(share - 1.0)
	return "≥ " + NumberText.size(share - 1.0) if _is_too_much(share) else "–"


## The ways of stepping as the comparison names them, in the order of
## [enum SteppingMethods.Method].
static func ways() -> PackedStringArray:
	return [
		LabText.translate("position reset"),
		LabText.translate("rest dropped"),
		LabText.translate("rest used"),
		LabText.translate("event world"),
	]


## The note at the point of impact.
static func impact_label(bounce: BounceRecord) -> String:
	return "t = %s" % NumberText.short(bounce.fraction, 3)


## The lines of the status card: time, bounces, lost balls, energy, and how much of a frame's 1/60 s
## the script takes.
static func status(model: AngledLinesModel, milliseconds: float) -> String:
	var world := model.world
	var counters := [world.frames, model.elapsed_seconds(), world.bounces, world.losses]
	return (
		LabText.translate("Frame %d, %.2f s    bounces %d    lost %d") % counters
		+ "\n"
		+ _energy(model)
		+ "    "
		+ LabText.translate("script %.2f of 16.67 ms") % milliseconds
	)


static func _energy(model: AngledLinesModel) -> String:
	var right := "E / E₀ = " + _share(model.energy_share(model.world), 5)
	if not model.wrong_world:
		return right
	var wrong := _share(model.energy_share(model.wrong_world), 5)
	return right + ", " + LabText.translate("mistake: %s") % wrong


# A share of the energy at the start, "–" where there is none. No way of stepping may make energy.
static func _share(value: float, digits: int) -> String:
	if is_nan(value):
		return "–"
	var text := NumberText.short(value, digits)
	return text + " > 1" if _is_too_much(value) else text


# So much that it is seen in what is shown.
static func _is_too_much(share: float) -> bool:
	return share > 1.001
