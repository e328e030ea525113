class_name PhysicsFrames
extends RefCounted
## Runs physics frames of the engine at a rate, as fast as they come, and measures their run time.
## The run time of a step in which nothing moves is subtracted.

const _USUAL_RATE := 60
const _USUAL_MOST_STEPS := 8
const _EMPTY_STEPS := 120

var _tree: SceneTree
# The run time of a step in which nothing moves, in microseconds.
var _empty := 0.0


## Waits for frames of this tree. Godot must have been started with --fixed-fps.
func _init(tree: SceneTree) -> void:
	_tree = tree


## Sets the rate and waits until just before a step: nodes that are added then take part in that
## step. Nothing that moves may be in the tree before.
func begin(rate: int) -> void:
	Engine.physics_ticks_per_second = rate
	Engine.max_physics_steps_per_frame = maxi(_USUAL_MOST_STEPS, ceili(2.0 * rate / _USUAL_RATE))
	await _tree.physics_frame
	await _tree.physics_frame
	_empty = 0.0
	_empty = await pass_by(_EMPTY_STEPS, _nothing) / _EMPTY_STEPS


## Sets the rate back to the usual one.
func end() -> void:
	Engine.physics_ticks_per_second = _USUAL_RATE
	Engine.max_physics_steps_per_frame = _USUAL_MOST_STEPS


## Makes this many steps and calls [param read] after each. Returns their run time in microseconds.
func pass_by(steps: int, read: Callable) -> float:
	var start := Time.get_ticks_usec()
	for i in steps:
		await _tree.physics_frame
		read.call()
	return maxf(Time.get_ticks_usec() - start - _empty * steps, 1.0)


static func _nothing() -> void:
	pass
