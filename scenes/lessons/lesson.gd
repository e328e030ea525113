@abstract class_name Lesson
extends Board
## What every lesson is to the frame around it: a board with a state that can be stored, put back
## and undone.
##
## The frame adds the services that the lesson's [LessonInfo] needs and then calls [method start].
## A lesson tells every complete change by the student with [@warning_ignore("unused_signal")
## signal edited]; the frame then stores [method state] for undo.

## The student has changed something, and the change is complete: a drag has ended, a number was
## entered.
@warning_ignore("unused_signal")
signal edited
## A sentence for the notice line: what could not be taken and why; "" takes it away.
@warning_ignore("unused_signal")
signal noticed(message: String)

## The services that the frame has brought, by the names in [member LessonInfo.needs].
var services: Dictionary[StringName, Control] = {}

## Called once, after the services are there and before the lesson is seen.
@abstract func start() -> void

## All that undo, reset and links have to know: numbers, texts, arrays and dictionaries of them
## only.
@abstract func state() -> Dictionary

## Puts back what [method state] has told. Shows it at once; emits nothing.
@abstract func show_state(stored: Dictionary) -> void


## The state to which reset goes back: [param first], the one at the start, unless a lesson has a
## nearer one, such as the start of the situation that was picked.
func reset_state(first: Dictionary) -> Dictionary:
	return first


## What a link to the board holds: [method state] without the past, of the kinds of values that
## [LessonLink] knows.
func link_state() -> Dictionary:
	return state()


## What the values are that a link does not name, where [param wanted] is what it wants:
## [param first], the link state at the start, unless a lesson has a nearer one.
func link_base(first: Dictionary, _wanted: Dictionary) -> Dictionary:
	return first


## "" if the lesson can show [param linked], a link state with the right names and kinds; else one
## sentence with the value and what is allowed, translated.
func link_problem(_linked: Dictionary) -> String:
	return ""


## Shows a link state that has no [method link_problem]; emits nothing but a notice.
func show_link(linked: Dictionary) -> void:
	show_state(linked)
