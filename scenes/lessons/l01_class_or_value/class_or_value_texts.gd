class_name ClassOrValueTexts
extends RefCounted
## The sentences of the lesson on objects and values, step by step.


## One sentence a step, translated.
static func sentences(copies: bool) -> PackedStringArray:
	var second := LabText.translate(
		"A second name: old = position. For a Vec2 it is the same object."
	)
	var third := LabText.translate(
		"Drag position: the Vec2 moves under both names. The Vector2 leaves old behind."
	)
	if copies:
		second = LabText.translate("A copy: old = position.copy(). Now there are two Vec2.")
		third = LabText.translate(
			"Drag position: now the old Vec2 stays behind, as the Vector2 does."
		)
	return [
		LabText.translate(
			"A place as a Vec2, our object, and as a Vector2, Godot's value. Drag either."
		),
		second,
		third,
		LabText.translate("Why Vec2 at all? It has 64 bits. Add 0.1 a million times and compare."),
	]


## What is said of the Vec2 and of the Vector2 at [param step], counted from 0: how many names it
## has, and whether they share one object.
static func sharing(is_shared: bool, step: int) -> PackedStringArray:
	if step == 0:
		return [LabText.translate("one name, one object"), LabText.translate("one name, one value")]
	var of_objects := LabText.translate("two names, two objects")
	if is_shared:
		of_objects = LabText.translate("two names, one object")
	return [of_objects, LabText.translate("two names, two values")]
