class_name LineEndsTexts
## The sentences of the lesson on line ends: one a step, and what happens in each field.

## The steps in order.
enum Step { ONE_SIDE, TWO_SIDES, SEGMENT, CAP, QUADRATIC, ROOTS, BOUNCE }


## One sentence a step, translated.
static func sentences(model: LineEndsModel) -> PackedStringArray:
	return [
		LabText.translate(
			"As before: an infinite line with one good side. A ball from behind passes through."
		),
		LabText.translate("Turn n̂ to the ball's side: now both sides work. Still infinite."),
		LabText.translate(
			"With ends, 0 ≤ s ≤ 1 must hold: the ball's centre F is beside the line at the touch."
		),
		LabText.translate("Round caps: the ball touches an end when its centre is r away."),
		LabText.translate("|d + t v| = r, squared, is a quadratic: a t² + b t + c = 0."),
		LabText.translate(
			"D < 0: the ball misses. D > 0: t₁ is the first touch; it counts within 0..1."
		),
		_on_bounce(model),
	]


static func _on_bounce(model: LineEndsModel) -> String:
	if model.bounces_on_the_end():
		return LabText.translate(
			"n̂ points from the end to the ball's centre. Reflect v on it as before."
		)
	if model.impact_in(LineEndsModel.Field.ROUND_CAPS).hit:
		return LabText.translate(
			"This ball bounces on the line, with the line's normal, as before."
		)
	return LabText.translate("This ball touches neither the line nor an end: v stays as it is.")


## What is asked before the round caps, translated.
static func question_on_end() -> String:
	return LabText.translate("The line ends, but the ball is wide. Does it touch an end?")


## The answers to [method question_on_end], translated.
static func choices_on_end() -> PackedStringArray:
	return [LabText.translate("it touches an end"), LabText.translate("it passes")]


## What is asked before the bounce, translated.
static func question_on_normal() -> String:
	return LabText.translate("The ball touches the end. Which way does its normal n̂ point?")


## The answers to [method question_on_normal]; the first is right.
static func choices_on_normal() -> PackedStringArray:
	return [
		LabText.translate("from the end to the ball's centre"),
		LabText.translate("perpendicular to the line"),
		LabText.translate("against v")
	]


## The name of the end that the quadratic is about.
static func end_name(model: LineEndsModel) -> String:
	return "A" if model.nearest_cap() == Impact.Feature.START else "B"


## The heading of a field, translated.
static func title(field: LineEndsModel.Field) -> String:
	match field:
		LineEndsModel.Field.INFINITE_ONE_SIDED:
			return LabText.translate("Infinite, one side")
		LineEndsModel.Field.INFINITE_TWO_SIDED:
			return LabText.translate("Infinite, two sides")
		LineEndsModel.Field.SEGMENT_ONE_SIDED:
			return LabText.translate("Segment, one side")
		LineEndsModel.Field.SEGMENT_TWO_SIDED:
			return LabText.translate("Segment, two sides")
	return LabText.translate("Segment, two sides, round caps")


## What happens in a field as far as [param step] tells it, translated: the time at an end comes
## with the roots, the bounce there at the end.
static func event_in(
	field: LineEndsModel.Field, model: LineEndsModel, step: int = Step.BOUNCE
) -> String:
	var impact := model.impact_in(field)
	var words := _of_result(model.result_in(field))
	var is_on_end := field == LineEndsModel.Field.ROUND_CAPS and model.bounces_on_the_end()
	if is_on_end and step < Step.BOUNCE:
		words = LabText.translate("touches the end")
	if _is_wrong_line(model, field):
		words = "✗ " + words
	if not impact.hit or is_on_end and step < Step.ROOTS:
		return words
	return words + ", t\u00a0=\u00a0" + NumberText.short(impact.fraction)


## What the ball of a mistake does on its [param wrong] flight, translated.
static func wrong_event(model: LineEndsModel, wrong: BallFlight) -> String:
	if not LineEndsMistakes.shows(model.mistake, model):
		return LabText.translate("the wrong ball does the same here")
	if not wrong.impact.hit:
		return LabText.translate("✗ the wrong ball passes")
	return (
		LabText.translate("✗ the wrong ball: t = %s") % NumberText.short(wrong.impact.fraction, 5)
	)


# Mistake 23 takes one of the other lines for the right one.
static func _is_wrong_line(model: LineEndsModel, field: LineEndsModel.Field) -> bool:
	if model.mistake != 23:
		return false
	var right := model.flight_in(LineEndsModel.Field.ROUND_CAPS).position_at(1.0)
	return not model.flight_in(field).position_at(1.0).equals_approx(right, 1e-6)


static func _of_result(result: LineEndsModel.Result) -> String:
	match result:
		LineEndsModel.Result.BOUNCES:
			return LabText.translate("bounces on the line")
		LineEndsModel.Result.BOUNCES_IN_THE_AIR:
			return LabText.translate("bounces in the air")
		LineEndsModel.Result.BOUNCES_ON_THE_END:
			return LabText.translate("bounces on the end")
		LineEndsModel.Result.PASSES_THROUGH:
			return LabText.translate("passes through from behind")
		LineEndsModel.Result.CUTS_THROUGH_THE_END:
			return LabText.translate("finds no hit, cuts through the end")
		LineEndsModel.Result.DRIVES_IN_LENGTHWISE:
			return LabText.translate("finds no hit, drives in lengthwise")
	return _of_miss(result)


static func _of_miss(result: LineEndsModel.Result) -> String:
	match result:
		LineEndsModel.Result.PASSES_BESIDE:
			return LabText.translate("passes beside")
		LineEndsModel.Result.FALLS_SHORT:
			return LabText.translate("does not get there")
		LineEndsModel.Result.MOVES_AWAY:
			return LabText.translate("moves away")
		LineEndsModel.Result.MOVES_ALONG:
			return LabText.translate("moves along the line")
	return LabText.translate("does not move")
