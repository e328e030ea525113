class_name MoreDimensionsTexts
extends RefCounted
## The sentences and formula lines of the lesson on more dimensions, step by step.

## The steps in order.
enum Step { COMPONENTS, PRODUCTS, SUM, SIGN, ANGLE }


## One sentence a step, translated.
static func sentences() -> PackedStringArray:
	return [
		_translate("A vector is a list of numbers: two, three, four of them, or more."),
		_translate("Multiply the first with the first, the second with the second, ..."),
		_translate("... and add. One number comes out, whatever the dimension."),
		_translate("Its sign alone tells whether the angle is below or above 90°."),
		_translate("For the angle itself, divide by both lengths: that is its cosine."),
	]


## The formula lines up to [param step] for the vectors of [param model].
static func lines(model: MoreDimensionsModel, step: int) -> PackedStringArray:
	var dimension := model.dimension()
	var found: PackedStringArray = [_list("a", dimension), _list("b", dimension)]
	if step >= Step.PRODUCTS:
		found.append("{a} · {b} = " + _joined("{pa%d}·{pb%d}", dimension, " + "))
	if step >= Step.SUM:
		found.append("= " + _joined("{p%d}", dimension, " + ") + " = {dot}")
	if step >= Step.SIGN:
		found.append("{a} · {b} {sign} 0:  " + sign_words(model))
	if step >= Step.ANGLE:
		found.append("|{a}| = {length_a}     |{b}| = {length_b}")
		found.append("cos α = {dot} / (|{a}| |{b}|) = {cosine}")
		found.append("α = {angle}°")
	return found


## What the sign says of the angle, translated.
static func sign_words(model: MoreDimensionsModel) -> String:
	match model.side():
		MoreDimensionsModel.Side.OBTUSE:
			return _translate("the angle is above 90°")
		MoreDimensionsModel.Side.ACUTE:
			return _translate("the angle is below 90°")
	if model.exact_cosine() == null:
		return _translate("a zero vector makes no angle")
	return _translate("a right angle")


## The sign of the comparison with 0.
static func comparison(model: MoreDimensionsModel) -> String:
	return ["<", "=", ">"][model.side() + 1]


static func _list(letter: String, dimension: int) -> String:
	return "{%s} = ( %s )" % [letter, _joined("{%s%%d}" % letter, dimension, " , ")]


static func _joined(pattern: String, dimension: int, between: String) -> String:
	var parts: PackedStringArray = []
	for i in dimension:
		parts.append(pattern.replace("%d", str(i + 1)))
	return between.join(parts)


static func _translate(sentence: String) -> String:
	return TranslationServer.translate(sentence)
