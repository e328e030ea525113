@abstract class_name LessonModel
extends RefCounted
## The state of a lesson: numbers that undo, reset and links keep, and all that is computed from
## them. Needs no scene.

## All that undo, reset and links have to know: numbers, texts, and arrays and dictionaries of them.
@abstract func to_dictionary() -> Dictionary

## Puts back what [method to_dictionary] returned.
@abstract func from_dictionary(stored: Dictionary) -> void


## "" if the lesson can show the state [param stored], which has the names and kinds of
## [method to_dictionary]; else one translated sentence with the value and what is allowed.
func problem_in(_stored: Dictionary) -> String:
	return ""
