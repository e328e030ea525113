class_name StepHistory
extends RefCounted
## The past of one or more worlds, frame by frame, to the last bit, for stepping back.

## Frames to keep: 15 seconds at 60 frames a second. The oldest are dropped first.
const LONGEST := 900

var _frames: Array[Array] = []


## Keeps the state of the worlds; call it before a step.
func remember(worlds: Array[SteppedWorld]) -> void:
	var states: Array[PackedFloat64Array] = []
	for world in worlds:
		states.append(world.state())
	_frames.append(states)
	if _frames.size() > LONGEST:
		_frames.pop_front()


## Puts the same worlds back to the state before the latest step. False if no step is kept.
func go_back(worlds: Array[SteppedWorld]) -> bool:
	if _frames.is_empty():
		return false
	var states: Array[PackedFloat64Array] = _frames.pop_back()
	for i in worlds.size():
		Refusal.push(worlds[i].put_state(states[i]))
	return true


## The number of steps back that are possible.
func size() -> int:
	return _frames.size()


## Forgets the past.
func clear() -> void:
	_frames.clear()
