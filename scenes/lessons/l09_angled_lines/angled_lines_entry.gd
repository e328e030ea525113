class_name AngledLinesEntry
extends RefCounted
## Takes numbers that were typed over in the formula lines of the lesson on angled lines.

const _BOUNCINESSES: Array[float] = [1.0, 0.8, 0.5, 0.0]


## Takes the next of the usual bouncinesses.
static func take_next_bounciness(model: AngledLinesModel) -> void:
	var place := _BOUNCINESSES.find(model.world.surroundings.bounciness)
	Refusal.push(model.set_bounciness(_BOUNCINESSES[(place + 1) % _BOUNCINESSES.size()]))


## Changes [param model] by the number's name in [AngledLinesTexts]. "" or one sentence with the
## value and what is allowed; then nothing has changed.
static func enter(model: AngledLinesModel, name_in_line: String, value: float) -> String:
	var gravity := model.world.surroundings.gravity.copy()
	var position := model.ball().position.copy()
	var velocity := model.ball().velocity.copy()
	match name_in_line:
		"C":
			return model.set_bounciness(value)
		"gx":
			gravity.x = value
		"gy":
			gravity.y = value
		"px":
			position.x = value
		"py":
			position.y = value
		"vx":
			velocity.x = value
		"vy":
			velocity.y = value
	if name_in_line.begins_with("g"):
		return model.set_gravity(gravity)
	return model.change_ball(position, velocity)
