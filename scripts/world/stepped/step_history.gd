class_name StepHistory
extends RefCounted
## The past of one or more worlds, frame by frame, to the last bit: what a step back needs.

## So many frames are kept: 15 seconds at 60 a second. The oldest go first.
const LONGEST := 900

var _frames: Array[Array] = []


## Keeps what the worlds are like before a step.
func remember(worlds: Array[SteppedWorld]) -> void:
	var states: Array[PackedFloat64Array] = []
	for world in worlds:
		states.append(world.state())
	_frames.append(states)
	if _frames.size() > LONGEST:
		_frames.pop_front()


## Puts the same worlds back to before the latest step that is kept. False where none is.
func go_back(worlds: Array[SteppedWorld]) -> bool:
	if _frames.is_empty():
		return false
	var states: Array[PackedFloat64Array] = _frames.pop_back()
	for i in worlds.size():
		Refusal.push(worlds[i].put_state(states[i]))
	return true


## How many steps can be gone back.
func size() -> int:
	return _frames.size()


## Forgets the past.
func clear() -> void:
	_frames.clear()
