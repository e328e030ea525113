class_name ClassOrValueTexts
extends RefCounted
## The sentences of the lesson on objects and values, step by step.

## The steps, counted from 0.
enum Step { PLACES, SECOND_NAME, CHANGE, SUMS }


## One sentence a step, translated.
static func sentences(copies: bool) -> PackedStringArray:
	var second := LabText.translate(
		"old = position gives the Vec2 a second name. old_value = value copies the Vector2."
	)
	var third := LabText.translate(
		"set_xy changes the one Vec2, so old changes, too. old_value stays. Drag position!"
	)
	if copies:
		second = LabText.translate(
			"old = position.copy() makes a second Vec2 with the same numbers."
		)
		third = LabText.translate(
			"set_xy changes only the first Vec2. old is a copy and stays, just like old_value."
		)
	return [
		LabText.translate(
			"The same place, stored twice: in a Vec2, an object, and in a Vector2, a value."
		),
		second,
		third,
		LabText.translate("Why Vec2? It keeps 64 bits of each number, Vector2 only 32."),
	]


## What is asked before the change, translated.
static func question() -> String:
	return LabText.translate(
		"Now position.set_xy(…) moves position. Which place does old hold then?"
	)


## The answers to [method question], translated.
static func choices() -> PackedStringArray:
	return [LabText.translate("the new place"), LabText.translate("the old place")]


## What is said of the Vec2 and of the Vector2 at [param step]: how many names it has, and whether
## they share one object.
static func sharing(is_shared: bool, step: int) -> PackedStringArray:
	if step < Step.SECOND_NAME:
		return [LabText.translate("one name, one object"), LabText.translate("one name, one value")]
	var of_objects := LabText.translate("two names, two objects")
	if is_shared:
		of_objects = LabText.translate("two names, one object")
	return [of_objects, LabText.translate("two names, two values")]


## Fills [param boxes] with what the names in [param model] stand for at [param step].
static func fill(boxes: NameBoxes, model: ClassOrValueModel, step: int) -> void:
	var is_changed := step >= Step.CHANGE
	var first := model.first_place()
	var place := model.position if is_changed else first
	var objects: PackedStringArray = [_pair(place)]
	var values: PackedStringArray = [_pair(Vec2.from_vector2(place.to_vector2()))]
	if step >= Step.SECOND_NAME:
		objects.append(_pair(model.old if is_changed else first))
		values.append(_pair(Vec2.from_vector2(model.old_value)))
	boxes.show_boxes(objects, values, model.is_shared())


# Short enough for a box.
static func _pair(place: Vec2) -> String:
	return NumberText.pair(place.x, place.y, 3)
