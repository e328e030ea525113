class_name OpeningMotion
extends Node
## Moves a lesson from its first frame until the student does anything: what moves by itself once is
## seen to be movable.

## It ends by itself after so many seconds.
const LONGEST := 20.0
# A frame counts for no more seconds than this: the first ones may take long.
const _LONGEST_FRAME := 0.1

## False where a lesson has to stay as it starts, as in tests and pictures.
static var is_allowed := true
## True while one runs.
static var is_running := false

var _seconds := 0.0
var _move: Callable
var _go_back: Callable


## Calls [param move] with the seconds since the first frame, and [param go_back] after
## [constant LONGEST].
func _init(move: Callable, go_back: Callable) -> void:
	_move = move
	_go_back = go_back
	is_running = true


## Where a swing is after [param seconds] that goes there and back so many [param times] until
## [constant LONGEST]: from 0 to 1, to -1 and to 0 again.
static func swing(seconds: float, times: float) -> float:
	return sin(TAU * times * seconds / LONGEST)


## The same for a way that is gone from 0 to 1 and back.
static func to_and_fro(seconds: float, times: float) -> float:
	return 0.5 - 0.5 * cos(TAU * times * seconds / LONGEST)


## Leaves everything where it is.
func stop() -> void:
	set_process(false)
	set_process_input(false)
	is_running = false


func _exit_tree() -> void:
	stop()


func _process(delta: float) -> void:
	if _seconds > LONGEST:
		stop()
		_go_back.call()
		return
	_move.call(_seconds)
	_seconds += minf(delta, _LONGEST_FRAME)


# Comes before whatever the press does: it finds things where they are seen.
func _input(event: InputEvent) -> void:
	if event.is_pressed():
		stop()
