class_name MoreDimensionsTexts
extends RefCounted
## The sentences and the verdict of the lesson on more dimensions.

## The steps in order.
enum Step { COMPONENTS, PRODUCTS, SUM, SIGN, ANGLE, USES }


## One sentence a step, translated.
static func sentences(model: MoreDimensionsModel) -> PackedStringArray:
	return [
		LabText.translate("A vector is a list of numbers: two, three, four of them, or more."),
		LabText.translate("Multiply the first by the first, the second by the second, and so on."),
		LabText.translate("Add the products: one number comes out, whatever the dimension."),
		_on_sign(model),
		_on_angle(model),
		LabText.translate("What the dot product is for, and in which lesson each use is shown."),
	]


## What is asked before the sign is shown, translated.
static func question() -> String:
	return LabText.translate("Is the angle between a and b below 90°, at 90° or above 90°?")


## The answers to [method question], translated.
static func choices() -> PackedStringArray:
	return [
		LabText.translate("below 90°"), LabText.translate("at 90°"), LabText.translate("above 90°")
	]


## The right one of [method choices], counted from 0; -1 where there is no angle.
static func right_choice(model: MoreDimensionsModel) -> int:
	return 1 - model.side() if model.has_angle() else -1


# The shadow is drawn where there is a picture.
static func _on_sign(model: MoreDimensionsModel) -> String:
	if not model.has_angle():
		return LabText.translate("A zero vector has no direction: there is no angle.")
	if model.is_beyond_space():
		return LabText.translate("Its sign tells whether the angle is below, at or above 90°.")
	return LabText.translate(
		"Its sign tells: below, at or above 90°. Above 90°, the shadow p of a points against b."
	)


static func _on_angle(model: MoreDimensionsModel) -> String:
	if not model.has_angle():
		return LabText.translate("A zero vector has no direction: there is no angle.")
	return LabText.translate("For the angle itself, divide by both lengths: that is its cosine.")


## What the sign of the dot product says, in two lines, translated.
static func verdict(model: MoreDimensionsModel) -> String:
	return "a · b %s 0\n%s" % [comparison(model), sign_words(model)]


## The words below the picture or the bars that replace it, translated.
static func hint(model: MoreDimensionsModel) -> String:
	if model.is_beyond_space():
		return LabText.translate("So many axes do not fit into a picture. The formula is the same.")
	return LabText.translate("Drag beside the arrows to turn the axes.")


## What the sign says of the angle, translated.
static func sign_words(model: MoreDimensionsModel) -> String:
	match model.side():
		MoreDimensionsModel.Side.OBTUSE:
			return LabText.translate("the angle is above 90°")
		MoreDimensionsModel.Side.ACUTE:
			return LabText.translate("the angle is below 90°")
	if not model.has_angle():
		return LabText.translate("a zero vector makes no angle")
	return LabText.translate("a right angle")


## The sign of the comparison with 0.
static func comparison(model: MoreDimensionsModel) -> String:
	return ["<", "=", ">"][model.side() + 1]
