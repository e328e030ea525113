class_name AimShots
extends RefCounted
## The shots of a state, computed once for each change.

# Where nothing ends by itself time runs so long.
const _END_OF_VIEW := 1.5

## Along the barrel as it stands.
var current: AimShot
## Along the aimed barrel.
var right: AimShot
## Along the barrel as it stands after the time at which it fires early.
var early: AimShot
## Along the barrel as the mistake leaves it.
var wrong: AimShot
# The same as the first, in gravity.
var _falling: FiredShot
var _model: AimAtModel


## Those of [param model] as it is now.
func _init(model: AimAtModel) -> void:
	_model = model
	current = AimShot.new(model, model.current_degrees())
	right = AimShot.new(model, model.target_degrees())
	early = AimShot.new(model, model.degrees_after(model.fire))
	wrong = AimShot.new(model, model.wrong_degrees())
	_falling = FiredShot.new(model.nozzle_at(current.degrees), _velocity(), _gravity())


## Where the falling bullet is after [param seconds], in pixels.
func falling_place(seconds: float) -> Vec2:
	return _falling.place_after(seconds)


## How fast it is then, in pixels per second.
func falling_velocity(seconds: float) -> Vec2:
	return _velocity().plus(_gravity().scaled(seconds))


func _velocity() -> Vec2:
	return Vec2.unit_degrees(current.degrees).scaled(_model.speed)


func _gravity() -> Vec2:
	return Vec2.new(0.0, AimAtModel.GRAVITY)


## Until when time runs at [param step], in seconds.
func end(step: int) -> float:
	match step:
		AimAtModel.Step.SPRITE:
			return AimAtModel.POSES[-1] * 1.2
		AimAtModel.Step.TURN:
			return _model.end_of_turn()
		AimAtModel.Step.EARLY:
			return _model.fire + early.end()
		AimAtModel.Step.FIRE:
			return maxf(right.end(), wrong.end()) if _model.shows_mistake() else right.end()
	return _END_OF_VIEW
