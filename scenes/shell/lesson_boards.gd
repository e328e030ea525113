class_name LessonBoards
extends RefCounted
## The boards of the lessons that were left, each with its step: they are there again when a lesson
## is opened anew, as long as the lab runs. Reset leads to the lesson's own start all the same.

## More steps than any lesson has: stands for its last one.
const LAST_STEP := 1000

# Of each lesson that was left, by its id: its state, its step and what was asked before steps.
# Without a state it is at its start.
static var _boards: Dictionary[StringName, Dictionary] = {}
# Whether answers were shown in the lesson that was left last: a class sees none in the next one.
static var _shows_answers := true


## Keeps what [param view] shows of the lesson [param id]. A lesson in which nothing was done yet is
## at its start; of one that could not be opened there is nothing to keep.
static func keep(id: StringName, view: FrameView) -> void:
	if not view.lesson:
		return
	_shows_answers = view.shows_answers
	_boards.erase(id)
	if not view.lesson.is_opening():
		_boards[id] = {
			"state": view.lesson.state(),
			"step": view.lesson.step,
			"asked_before": view.lesson.asked_before,
		}


## Shows in [param view] the board that was kept of its lesson [param id], which has just been
## started.
static func bring_back(id: StringName, view: FrameView) -> void:
	view.shows_answers = _shows_answers
	var board: Dictionary = _boards.get(id, {})
	if board.has("state"):
		var state: Dictionary = board["state"]
		view.lesson.show_state(state)
	if board.has("step"):
		var step: int = board["step"]
		view.lesson.show_step(step)
	if board.has("asked_before"):
		var asked_before: PackedInt32Array = board["asked_before"]
		view.lesson.asked_before = asked_before


## From now on the lesson [param id] is brought back at this step, counted from 0; its board stays
## as it was kept. Does nothing for the first step of a lesson of which nothing was kept.
static func keep_step(id: StringName, step: int) -> void:
	if step > 0 or has(id):
		_boards.get_or_add(id, {})["step"] = step


## Whether something of the lesson [param id] is kept.
static func has(id: StringName) -> bool:
	return _boards.has(id)


## The lesson [param id] starts anew when it is opened next.
static func forget(id: StringName) -> void:
	_boards.erase(id)


## All lessons start anew.
static func forget_all() -> void:
	_boards.clear()
	_shows_answers = true
