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
## nothing changes.
func take(changes: Dictionary) -> String:
	var wanted := to_dictionary().merged(changes, true)
	var problem := problem_in(wanted)
	if not problem:
		from_dictionary(wanted)
	return problem


## "" if the lesson can show the state [param stored], which has the names and kinds of
## [method to_dictionary]; else one translated sentence with the value and what is allowed.
func problem_in(_stored: Dictionary) -> String:
	return ""
