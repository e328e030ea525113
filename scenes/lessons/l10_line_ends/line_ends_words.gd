class_name LineEndsWords
## What stands on the fields of the lesson on line ends, in words.


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
static func sentence(model: LineEndsModel, field: LineEndsModel.Field) -> String:
	var words := _of_result(model.result_in(field))
	if _is_wrong_line(model, field):
		words = "✗ " + words
	var impact := model.impact_in(field)
	if not impact.hit:
		return words
	return words + ", t\u00a0=\u00a0" + NumberText.short(impact.fraction, 3)


## What the wrong ball of a mistake does, translated: its [param wrong] flight beside the right one.
static func wrong_sentence(model: LineEndsModel, wrong: BallFlight) -> String:
	if not LineEndsMistakes.shows(model.mistake, model):
		return _translate("the wrong ball does the same here")
	if not wrong.impact.hit:
		return _translate("✗ the wrong ball passes")
	return _translate("✗ the wrong ball: t = %s") % NumberText.short(wrong.impact.fraction, 5)


# Mistake 23 is one of the other lines in the place of the right one.
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


static func _translate(sentence_to_translate: String) -> String:
	return TranslationServer.translate(sentence_to_translate)
