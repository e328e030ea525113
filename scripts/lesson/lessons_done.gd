class_name LessonsDone
extends RefCounted
## What the student has done in the lessons: kept for the next time, until it is to be forgotten.

## Of a lesson the last step has been shown.
const SEEN := "lessons_seen"
## A question of a lesson has been answered rightly.
const ANSWERED := "lessons_answered"


## Whether [param what], [constant SEEN] or [constant ANSWERED], is true of the lesson [param id].
static func has(what: String, id: StringName) -> bool:
	return _ids(what).has(String(id))


## Keeps that [param what] is true of the lesson [param id].
static func note(what: String, id: StringName) -> void:
	if not has(what, id):
		var known := _ids(what)
		known.append(id)
		KeptChoices.keep(what, known)


## Whether anything has been done.
static func is_any() -> bool:
	return _ids(SEEN).size() + _ids(ANSWERED).size() > 0


## From now on nothing has been done.
static func forget() -> void:
	KeptChoices.forget(SEEN)
	KeptChoices.forget(ANSWERED)


# What a file holds that somebody has changed may be of another kind.
static func _ids(what: String) -> PackedStringArray:
	var kept: Variant = KeptChoices.value(what, PackedStringArray())
	return kept if kept is PackedStringArray else PackedStringArray()
