class_name LessonHistory
extends RefCounted
## Undo and redo of a lesson: the states between complete changes, and the one that is shown.
##
## What moves by itself between two of the student's changes is one change, however often it was
## paused or stepped: undo leads back to where it began. [UndoRedo] joins only changes that are less
## than a second apart.

## What can be undone or redone has changed.
signal changed

var _lesson: Lesson
var _states: Array[Dictionary]
# The place in them of the state that is shown.
var _at := 0
# What the lesson showed when it was started.
var _first: Dictionary
# The latest change came by itself.
var _has_moved := false


## Of [param lesson], which has just been started.
func _init(lesson: Lesson) -> void:
	_lesson = lesson
	_first = lesson.state()
	_states = [_first]


## Whether there is something to undo.
func has_undo() -> bool:
	return _at > 0


## Whether there is something to redo.
func has_redo() -> bool:
	return _at < _states.size() - 1


## Takes back the last change.
func undo() -> void:
	_go(-1)


## Makes the change again that was taken back last.
func redo() -> void:
	_go(1)


## Goes back to the lesson's start; that can be undone, too.
func reset() -> void:
	store_motion()
	_lesson.show_state(_lesson.reset_state(_first))
	_lesson.ask_again()
	store()


## Keeps the present state as a change, if it differs from the last one.
func store() -> void:
	_store(false)


## The same for what has moved by itself: it goes on with a change that did so, too.
func store_motion() -> void:
	_store(true)


## Takes the present state as the one to begin from: what led to it is no change.
func begin_here() -> void:
	_states[_at] = _lesson.state()


func _store(has_moved: bool) -> void:
	var now := _lesson.state()
	if now == _states[_at]:
		return
	if not (has_moved and _has_moved and not has_redo()):
		_at += 1
	_states.resize(_at)
	_states.append(now)
	_has_moved = has_moved
	changed.emit()


func _go(way: int) -> void:
	_lesson.stop_opening()
	store_motion()
	var to := clampi(_at + way, 0, _states.size() - 1)
	if to != _at:
		_lesson.show_state(_states[to])
		_at = to
		_has_moved = false
		changed.emit()
