class_name FrameMeter
extends RefCounted
## Measures how much of a frame's time the lesson's own script takes; gives a result twice a second.

# Microseconds between two results.
const _PERIOD := 500_000

## Milliseconds of script per drawn frame, in the latest period in which the script did any work.
var milliseconds := 0.0

var _spent := 0
var _frames := 0
var _period_start := 0
var _start := 0


## The script starts its work.
func start() -> void:
	_start = Time.get_ticks_usec()


## The script has done the work that began with [method start].
func stop() -> void:
	_spent += Time.get_ticks_usec() - _start


## A frame has been drawn. Returns true twice a second: when there is a new result.
func end_frame() -> bool:
	_frames += 1
	var now := Time.get_ticks_usec()
	if now - _period_start < _PERIOD:
		return false
	if _spent > 0:
		milliseconds = _spent / 1000.0 / _frames
	_spent = 0
	_frames = 0
	_period_start = now
	return true
