class_name PhysicsFrames
extends RefCounted
## Runs physics frames of the engine at a rate, as fast as they come, and says what they take.

const _USUAL_RATE := 60
const _EMPTY_FRAMES := 120

var _tree: SceneTree


## Waits for frames of this tree, which has to be started with --fixed-fps.
func _init(tree: SceneTree) -> void:
	_tree = tree


## Sets the rate, and waits until a step is about to be made: what is put into the tree then is
## there from its first step on.
func begin(rate: int) -> void:
	Engine.physics_ticks_per_second = rate
	Engine.max_physics_steps_per_frame = maxi(8, ceili(2.0 * rate / _USUAL_RATE))
	await _tree.physics_frame
	await _tree.physics_frame


## Sets the rate back to the usual.
func end() -> void:
	Engine.physics_ticks_per_second = _USUAL_RATE
	Engine.max_physics_steps_per_frame = 8


## Makes so many steps, and calls [param read] after each; microseconds of all of it.
func pass_by(steps: int, read: Callable) -> float:
	var start := Time.get_ticks_usec()
	for i in steps:
		await _tree.physics_frame
		read.call()
	return Time.get_ticks_usec() - start


## Microseconds of one step at this rate in which nothing moves: to be measured before anything is
## put into the tree, and to be taken off.
func empty_step() -> float:
	return await pass_by(_EMPTY_FRAMES, _nothing) / _EMPTY_FRAMES


static func _nothing() -> void:
	pass
