class_name LineEndsTexts
## The sentences of the lesson on line ends: one a step, and what happens in each field.

## The steps in order.
enum Step { ONE_SIDE, TWO_SIDES, SEGMENT, CAP, QUADRATIC, ROOTS, BOUNCE }


## One sentence a step, translated.
static func sentences() -> PackedStringArray:
	return [
		_translate("So far: an infinite line with one good side. From behind, balls pass."),
		_translate("Turn n to the ball's side, and both sides work. Still infinite."),
		_translate("With ends: the foot of the ball at impact lies between them, 0 ≤ s ≤ 1."),
		_translate("Round caps: the ball touches an end when its centre is r away."),
		_translate("|d + t v| = r, squared, is a quadratic: a t² + b t + c = 0."),
		_translate("D < 0: no touch. Else t₁ is the first touch; it counts if in 0..1."),
		_translate("n points from the end to the centre. Reflect v on it as ever."),
	]


## The name of the end that the quadratic is about.
static func end_name(model: LineEndsModel) -> String:
	return "A" if model.nearest_cap() == Impact.Feature.START else "B"


## The heading of a field, translated.
static func title(field: LineEndsModel.Field) -> String:
	match field:
		LineEndsModel.Field.INFINITE_ONE_SIDED:
			return _translate("Infinite, one side")
		LineEndsModel.Field.INFINITE_TWO_SIDED:
			return _translate("Infinite, two sides")
		LineEndsModel.Field.SEGMENT_ONE_SIDED:
			return _translate("Segment, one side")
		LineEndsModel.Field.SEGMENT_TWO_SIDED:
			return _translate("Segment, two sides")
	return _translate("Segment, two sides, round caps")


## What happens in a field, translated.
static func event_in(field: LineEndsModel.Field, model: LineEndsModel) -> String:
	var words := _of_result(model.result_in(field))
	if _is_wrong_line(model, field):
		words = "✗ " + words
	var impact := model.impact_in(field)
	if not impact.hit:
		return words
	return words + ", t\u00a0=\u00a0" + NumberText.short(impact.fraction, 3)


## What the ball of a mistake does on its [param wrong] flight, translated.
static func wrong_event(model: LineEndsModel, wrong: BallFlight) -> String:
	if not LineEndsMistakes.shows(model.mistake, model):
		return _translate("the wrong ball does the same here")
	if not wrong.impact.hit:
		return _translate("✗ the wrong ball passes")
	return _translate("✗ the wrong ball: t = %s") % NumberText.short(wrong.impact.fraction, 5)


# Mistake 23 takes one of the other lines for the right one.
static func _is_wrong_line(model: LineEndsModel, field: LineEndsModel.Field) -> bool:
	if model.mistake != 23:
		return false
	var right := model.flight_in(LineEndsModel.Field.ROUND_CAPS).position_at(1.0)
	return not model.flight_in(field).position_at(1.0).equals_approx(right, 1e-6)


static func _of_result(result: LineEndsModel.Result) -> String:
	match result:
		LineEndsModel.Result.BOUNCES:
			return _translate("bounces on the line")
		LineEndsModel.Result.BOUNCES_IN_THE_AIR:
			return _translate("bounces in the air")
		LineEndsModel.Result.BOUNCES_ON_THE_END:
			return _translate("bounces on the end")
		LineEndsModel.Result.PASSES_THROUGH:
			return _translate("passes through from behind")
		LineEndsModel.Result.CUTS_THROUGH_THE_END:
			return _translate("passes beside, cuts the end")
	return _of_miss(result)


static func _of_miss(result: LineEndsModel.Result) -> String:
	match result:
		LineEndsModel.Result.PASSES_BESIDE:
			return _translate("passes beside")
		LineEndsModel.Result.FALLS_SHORT:
			return _translate("does not get there")
		LineEndsModel.Result.MOVES_AWAY:
			return _translate("moves away")
		LineEndsModel.Result.MOVES_ALONG:
			return _translate("moves along the line")
	return _translate("does not move")


static func _translate(sentence: String) -> String:
	return TranslationServer.translate(sentence)
