class_name DotProductTexts
extends RefCounted
## The sentences and the verdict of the lesson on the dot product.

## The steps, counted from 0.
enum Step { VECTORS, UNIT, SCALAR, PROJECTION, REJECTION, SURE, BOTH, ANGLE, PRIMITIVE }

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


## The same along [method shadowed_symbol].
static func shadowed_unit_symbol(model: DotProductModel) -> String:
	return _UNITS[shadowed_symbol(model)]


## One sentence a step, translated.
static func sentences(model: DotProductModel) -> PackedStringArray:
	var found := _first_sentences()
	if not model.onto().length():
		found.resize(Step.size())
		found.fill(
			LabText.translate("{w} is zero: it has no direction, and no shadow falls on it.")
		)
		found[0] = _first_sentences()[0]
	else:
		found.append_array(_right_sentences(model) if model.normalizes else _wrong_sentences(model))
		found.append(_on_both(model))
		found.append_array(_angle_sentences(model))
	for i in found.size():
		found[i] = _with_letters(found[i], model)
	return found


## What is asked before the shadow is shown, translated.
static func question(model: DotProductModel) -> String:
	return _with_letters(
		LabText.translate(
			"Light falls straight onto {w}. Where does the shadow of {u} end? Drag the “?” there."
		),
		model
	)


## What is asked before the second shadow is shown, translated.
static func question_on_both(model: DotProductModel) -> String:
	return _with_letters(
		LabText.translate("Now the shadow of {w} on {u}: is it longer or shorter than p?"), model
	)


## The answers to [method question_on_both], translated.
static func choices_on_both() -> PackedStringArray:
	return [
		LabText.translate("longer"), LabText.translate("shorter"), LabText.translate("as long as p")
	]


## Two lines on the scalar projection: its size, and what its sign says, or what is wrong without
## normalizing.
static func verdict(model: DotProductModel) -> PackedStringArray:
	if not model.onto().length():
		return [
			LabText.translate("No projection"),
			_with_letters(LabText.translate("{w} is zero: it has no direction"), model),
		]
	var scalar := 0.0 if model.is_dot_zero() else model.scalar_projection()
	return [
		LabText.translate("Scalar projection %s") % NumberText.short(scalar), _what_it_says(model)
	]


static func _what_it_says(model: DotProductModel) -> String:
	if not model.shadowed().length():
		return _with_letters(LabText.translate("zero: {u} is zero, and so is its shadow"), model)
	if model.is_wrong():
		var sentence := _with_letters(
			LabText.translate("wrong: |{w}| = %s times the right one"), model
		)
		return sentence % _not_one(model.onto().length())
	var by_sign: PackedStringArray = [
		LabText.translate("negative: the angle is above 90°"),
		LabText.translate("zero: the angle is 90°"),
		LabText.translate("positive: the angle is below 90°"),
	]
	return by_sign[model.side() + 1]


# With as many digits as tell the length from 1.
static func _not_one(length: float) -> String:
	for digits in range(4, 17):
		if NumberText.rounded(length, digits) != 1.0:
			return NumberText.short(length, digits)
	return NumberText.all_digits(length)


static func _first_sentences() -> PackedStringArray:
	# A finger has no right button.
	if DisplayServer.is_touchscreen_available():
		return [
			LabText.translate(
				"A vector is a difference: head minus tail. Drag a and b, or tap where a is to end."
			)
		]
	return [
		(
			LabText
			. translate(
				"A vector is a difference: head minus tail. Drag a and b, or click: left for a, right for b."
			)
		)
	]


static func _right_sentences(model: DotProductModel) -> PackedStringArray:
	return [
		LabText.translate(
			"Divide {w} by its length: the unit vector {e} keeps the direction and has length 1."
		),
		LabText.translate(
			"The dot product with {e} is the scalar projection: how far {u} reaches along {w}."
		),
		_on_projection(model),
		_on_rest(model),
		(
			LabText
			. translate(
				"Be sure of it. Try: drag {u}. Measure p, as here. Prove it: see “Proof of the projection”."
			)
		),
	]


# The lecture's numbers, b on a, would seem to say that p is always a.
static func _on_projection(model: DotProductModel) -> String:
	if model.ends_at_head():
		return LabText.translate(
			"{e} times the scalar projection is p. Here it is {w} itself, by chance: drag {u}."
		)
	return LabText.translate(
		"{e} times the scalar projection is the vector projection p: the shadow of {u} on {w}."
	)


static func _on_rest(model: DotProductModel) -> String:
	if model.leaves_nothing():
		return LabText.translate("Nothing is left of {u} here: the rest {u} − p is zero.")
	return LabText.translate("What is left of {u}, the rest {u} − p, is perpendicular to {w}.")


static func _wrong_sentences(model: DotProductModel) -> PackedStringArray:
	return [
		LabText.translate("Here {w} is NOT divided by its length: the usual mistake."),
		LabText.translate(
			"The dot product with {w} itself is the scalar projection times the length of {w}."
		),
		LabText.translate("That times {w} is |{w}|² times the shadow: the length comes in twice."),
		_on_wrong_rest(model),
		_on_wrong_length(model),
	]


static func _on_wrong_rest(model: DotProductModel) -> String:
	if model.is_wrong():
		return LabText.translate(
			"The rest {u} − p is not perpendicular to {w}: that is how a test finds the mistake."
		)
	return LabText.translate("With these numbers the mistake changes nothing: a test needs others.")


static func _on_wrong_length(model: DotProductModel) -> String:
	if model.is_wrong():
		return (
			LabText
			. translate(
				"Try, measure or prove: each of the three finds the mistake. Measured, p has a wrong length."
			)
		)
	return LabText.translate("With these numbers the mistake changes nothing: a test needs others.")


static func _on_both(model: DotProductModel) -> String:
	if not model.shadowed().length():
		return LabText.translate("{u} is zero: it has no direction, and no shadow falls on it.")
	if not model.normalizes:
		return LabText.translate(
			"Without dividing, both are {u} · {w}: one number for two shadows."
		)
	if model.is_dot_zero():
		return LabText.translate("At a right angle both shadows are zero: drag {u} away from it.")
	if model.has_equal_lengths():
		return LabText.translate("Both shadows are equally long here, because {u} and {w} are.")
	if model.other_ends_at_head():
		return LabText.translate(
			"{u} · {e} is not {w} · {v}. Here the shadow q is {u} itself, by chance: drag {u}."
		)
	return LabText.translate(
		"{u} · {e} is not {w} · {v}: the same dot product, divided by another length."
	)


static func _angle_sentences(model: DotProductModel) -> PackedStringArray:
	if not model.shadowed().length():
		var no_angle := LabText.translate(
			"{u} is zero: it has no direction, and there is no angle."
		)
		return [no_angle, no_angle]
	return [
		(
			LabText
			. translate(
				"The scalar projection is |{u}| cos φ, so a · b is |a| |b| cos φ. Of unit vectors it is cos φ."
			)
		),
		LabText.translate(
			"The primitive way: both angles by atan2, their difference, its cosine, times |{u}|."
		),
	]


static func _with_letters(sentence: String, model: DotProductModel) -> String:
	return (
		sentence
		. format(
			{
				"u": shadowed_symbol(model),
				"w": onto_symbol(model),
				"e": unit_symbol(model),
				"v": shadowed_unit_symbol(model),
			}
		)
	)
