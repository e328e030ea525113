@abstract class_name LessonModel
extends RefCounted
## The state of a lesson: numbers that undo, reset and links keep, and all that is computed from
## them. Needs no scene.

## All that undo, reset and links have to know: numbers, texts, and arrays and dictionaries of them.
@abstract func to_dictionary() -> Dictionary

## Puts back what [method to_dictionary] returned.
@abstract func from_dictionary(stored: Dictionary) -> void


## Takes other values for a part of the state: [param changes] holds them by their names in
## [method to_dictionary]. "" if they could be taken; else the sentence of [method problem_in], and
## nothing changes. A mistake that is switched on is shown by [method show_mistake].
func take(changes: Dictionary) -> String:
	var wanted := to_dictionary().merged(changes, true)
	var problem := problem_in(wanted)
	if not problem:
		from_dictionary(wanted)
		if changes.has("mistake"):
			var number: int = changes["mistake"]
			show_mistake(number)
	return problem


## Takes a number that is typed over in the formula, by its name there. "" if it could be taken;
## else one translated sentence with the value and what is allowed, and nothing changes.
func enter(_name_in_line: String, _value: float) -> String:
	return ""


## Switches the mistake [param number] on, 0 for none: where it changes nothing, a model takes other
## numbers, such as a preset's, with which it does.
func show_mistake(_number: int) -> void:
	pass


## "" if the lesson can show the state [param stored], which has the names and kinds of
## [method link_state]; else one translated sentence with the value and what is allowed.
func problem_in(_stored: Dictionary) -> String:
	return ""


## The state to which reset goes back: [param first], the one at the start, unless a lesson has a
## nearer one, such as the start of the preset that was picked last.
func reset_state(first: Dictionary) -> Dictionary:
	return first


## What a link to the board holds: [method to_dictionary] without the past, with the kinds of values
## that [LessonLink] knows.
func link_state() -> Dictionary:
	return to_dictionary()


## The values that a link need not name, where [param wanted] is what it asks for: [param first],
## the link state at the start, unless a lesson has a nearer one.
func link_base(first: Dictionary, _wanted: Dictionary) -> Dictionary:
	return first


## The state for [method from_dictionary] that [param linked], a link state, stands for.
func state_of_link(linked: Dictionary) -> Dictionary:
	return linked
