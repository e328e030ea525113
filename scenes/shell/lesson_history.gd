class_name LessonHistory
extends Node
## Undo and redo of a lesson: the states between complete changes.
##
## A node, because [UndoRedo] would keep a [RefCounted] alive for ever through its methods.

## What can be undone or redone has changed.
signal changed

var _lesson: Lesson
var _first: Dictionary
var _last: Dictionary
var _history := UndoRedo.new()


## Of [param lesson], which has just been started.
func _init(lesson: Lesson) -> void:
	_lesson = lesson
	_first = lesson.state()
	_last = _first
	_history.version_changed.connect(changed.emit)


func _exit_tree() -> void:
	_history.version_changed.disconnect(changed.emit)
	_history.free()


## Whether there is something to undo.
func has_undo() -> bool:
	return _history.has_undo()


## Whether there is something to redo.
func has_redo() -> bool:
	return _history.has_redo()


## Takes back the last change.
func undo() -> void:
	_history.undo()


## Makes the change again that was taken back last.
func redo() -> void:
	_history.redo()


## Goes back to the lesson's start; that can be undone, too.
func reset() -> void:
	_lesson.show_state(_lesson.reset_state(_first))
	store()


## Keeps the present state as a change, if it differs from the last one.
func store() -> void:
	var now := _lesson.state()
	if now == _last:
		return
	_history.create_action("edit")
	_history.add_do_method(_show.bind(now))
	_history.add_undo_method(_show.bind(_last))
	_history.commit_action(false)
	_last = now


## Takes the present state as the one to begin from: what led to it is no change.
func begin_here() -> void:
	_last = _lesson.state()


func _show(stored: Dictionary) -> void:
	_last = stored
	_lesson.show_state(stored)
