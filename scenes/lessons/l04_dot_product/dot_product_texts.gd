class_name DotProductTexts
extends RefCounted
## The sentences and the verdict of the lesson on the dot product.

const _UNITS: Dictionary[String, String] = {"a": "â", "b": "b\u0302"}


## The letter of the vector whose shadow is looked for.
static func shadowed_symbol(model: DotProductModel) -> String:
	return "b" if model.is_swapped else "a"


## The letter of the vector on which the shadow falls.
static func onto_symbol(model: DotProductModel) -> String:
	return "a" if model.is_swapped else "b"


## The letter with a hat: the unit vector along [method onto_symbol].
static func unit_symbol(model: DotProductModel) -> String:
	return _UNITS[onto_symbol(model)]


## One sentence a step, translated.
static func sentences(model: DotProductModel) -> PackedStringArray:
	var letters := {"u": shadowed_symbol(model), "w": onto_symbol(model), "e": unit_symbol(model)}
	var found: PackedStringArray = []
	for sentence in _right_sentences() if model.normalizes else _wrong_sentences():
		found.append(sentence.format(letters))
	return found


## Two lines on the scalar projection: its size, and what its sign says, or how much too big it is
## without normalizing.
static func verdict(model: DotProductModel) -> PackedStringArray:
	var scalar := NumberText.short(model.scalar_projection())
	return [LabText.translate("Scalar projection %s") % scalar, _verdict_on_sign(model)]


static func _verdict_on_sign(model: DotProductModel) -> String:
	if not model.normalizes:
		var times := NumberText.short(model.onto().length())
		return LabText.translate("wrong: |%s| = %s times too big") % [onto_symbol(model), times]
	var by_sign: PackedStringArray = [
		LabText.translate("negative: the angle is above 90°"),
		LabText.translate("zero: no shadow at all"),
		LabText.translate("positive: the angle is below 90°"),
	]
	return by_sign[model.side() + 1]


static func _right_sentences() -> PackedStringArray:
	return [
		LabText.translate(
			"A vector is a difference: head minus tail. Drag either; only the difference counts."
		),
		LabText.translate(
			"Divide {w} by its length: the unit vector {e} keeps the direction and has length 1."
		),
		LabText.translate(
			"The dot product with {e} is the scalar projection: how far {u} reaches along {w}."
		),
		LabText.translate(
			"So many times {e} is the vector projection p: the shadow of {u} on {w}."
		),
		LabText.translate("What is left of {u}, the rest {u} − p, is perpendicular to {w}."),
	]


static func _wrong_sentences() -> PackedStringArray:
	return [
		LabText.translate(
			"A vector is a difference: head minus tail. Drag either; only the difference counts."
		),
		LabText.translate("Here {w} is NOT divided by its length: the usual mistake."),
		LabText.translate(
			"The dot product with {w} itself is the projection times the length of {w}."
		),
		LabText.translate("So many times {w}: the arrow leaves the board. It is far too long."),
		LabText.translate(
			"The rest {u} − p is not perpendicular to {w}: that is how a test finds the mistake."
		),
	]
