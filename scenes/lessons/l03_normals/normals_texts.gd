class_name NormalsTexts
extends RefCounted
## The sentences of the lesson on normals, step by step.

## The steps: the vector of a line, its normal, the opposite one, both unit normals.
enum Step { VECTOR, NORMAL, OPPOSITE, UNIT, SCALED }

# A double has no more.
const _MOST_DIGITS := 17


## One sentence a step, translated. Where a mistake is on, all steps show it.
static func sentences(model: NormalsModel) -> PackedStringArray:
	if model.mistake != 0:
		var told: PackedStringArray = []
		told.resize(Step.size())
		told.fill(_mistake_sentence(model))
		return told
	return _sentences() if model.has_direction() else _sentences_for_zero()


## What is asked before the normal is shown.
static func question() -> String:
	var asked := LabText.translate(
		"Turn v by +90°, %s on screen. Where does its head go? Drag the “?” there."
	)
	return asked % clockwise_text()


## The way in which +90 degrees turns on the screen, as one word.
static func clockwise_text() -> String:
	if Conventions.is_y_up():
		return LabText.translate("counter-clockwise")
	return LabText.translate("clockwise")


## [param length] with as many digits as show what int() makes of it: 0.99999 and not 1.
static func uncut_text(length: float) -> String:
	for digits in range(4, _MOST_DIGITS):
		if floorf(NumberText.rounded(length, digits)) == floorf(length):
			return NumberText.short(length, digits)
	return NumberText.all_digits(length)


static func _sentences() -> PackedStringArray:
	var turned := (
		LabText
		. translate(
			"Turn v and its triangle by +90°, %s: x now runs along y, y against x. The normal n is (−y, x)."
		)
	)
	return [
		LabText.translate("A line has a direction: v = end − start. Drag its ends, or all of it."),
		turned % clockwise_text(),
		LabText.translate("(y, −x) is the opposite normal. Choose one of the two and keep to it."),
		(
			LabText
			. translate(
				"Divide by the length: v̂ is v normalized, n̂ is n normalized. “The normal” often means n̂."
			)
		),
		LabText.translate("In pixels, length 1 is too short to see. So draw a multiple of n̂."),
	]


static func _sentences_for_zero() -> PackedStringArray:
	return [
		LabText.translate("v is zero: a point has no direction. Drag its end away."),
		LabText.translate("v is zero: (−y, x) is (0, 0), which is no normal."),
		LabText.translate("v is zero: (y, −x) is (0, 0), too."),
		LabText.translate("v is zero: never divide by its length. Zero stays zero."),
		LabText.translate("v is zero: there is no n̂ to draw."),
	]


static func _mistake_sentence(model: NormalsModel) -> String:
	if model.mistake == NormalsMistakes.WRONG_NORMAL:
		return LabText.translate("Mistake 9 is on: n, and what two wrong formulas make of v.")
	if model.mistake == NormalsMistakes.ZERO_VECTOR:
		if model.has_direction():
			return LabText.translate(
				"Mistake 6 is on. It shows only if v is zero: drag the end to the start."
			)
		return LabText.translate("Mistake 6 is on: it divides by a length of 0.")
	if model.is_mistaken():
		return LabText.translate("Mistake 7 is on: int() cuts the length to 0.")
	return LabText.translate("Mistake 7 is on. It shows only if v is shorter than 1, but not zero.")
