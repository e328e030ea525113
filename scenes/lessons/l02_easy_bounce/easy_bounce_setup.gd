class_name EasyBounceSetup
## Changes to the set-up of the lesson on the easy bounce: tilting, turning floor into wall, and
## what undo stores.


## The tilt of a line whose end, away from the pivot, is dragged to [param point]: whole degrees,
## not beyond the steepest.
static func tilt_toward(model: EasyBounceModel, point: Vec2, is_start: bool) -> float:
	var along := point.minus(model.pivot)
	if is_start:
		along = along.negated()
	var level := Vec2.unit_degrees(90.0 if model.is_wall else 180.0)
	var degrees := roundf(Vec2.rad_to_deg(level.angle_to(along)))
	return clampf(degrees, -EasyBounceModel.STEEPEST, EasyBounceModel.STEEPEST)


## Makes a wall of the floor or a floor of the wall: x and y change places, so that all that can be
## seen is the same, mirrored.
static func swap_axes(model: EasyBounceModel) -> void:
	model.is_wall = not model.is_wall
	model.tilt_degrees = -model.tilt_degrees
	for vector: Vec2 in [model.ball.position, model.ball.velocity, model.pivot]:
		vector.set_xy(vector.y, vector.x)


## "" if the number may be entered under this name; else a sentence with the value and what is
## allowed, translated.
static func problem(name_in_line: String, value: float) -> String:
	var text := NumberText.short(value)
	if name_in_line == "r" and not (value > 0.0 and value <= 200.0):
		return TranslationServer.translate("r must be above 0 and at most 200, not %s.") % text
	if name_in_line == "tilt" and not absf(value) <= EasyBounceModel.STEEPEST:
		return TranslationServer.translate("The tilt must be within −45 and 45°, not %s°.") % text
	return ""


## All of [param model] but the frame that is shown.
static func to_dictionary(model: EasyBounceModel) -> Dictionary:
	var ball := model.ball
	return {
		"ball":
		PackedFloat64Array(
			[ball.position.x, ball.position.y, ball.velocity.x, ball.velocity.y, ball.radius]
		),
		"pivot": PackedFloat64Array([model.pivot.x, model.pivot.y]),
		"tilt_degrees": model.tilt_degrees,
		"is_wall": model.is_wall,
	}


## "" if a state such as [method to_dictionary] tells can be put back; else one sentence with the
## value and what is allowed.
static func problem_of(stored: Dictionary) -> String:
	var ball: PackedFloat64Array = stored["ball"]
	var tilt: float = stored["tilt_degrees"]
	return StateCheck.first([problem("r", ball[4]), problem("tilt", tilt)])


## Puts back what [method to_dictionary] has told, and goes to frame 0.
static func from_dictionary(model: EasyBounceModel, stored: Dictionary) -> void:
	var ball: PackedFloat64Array = stored["ball"]
	var pivot: PackedFloat64Array = stored["pivot"]
	model.ball = Ball.new(Vec2.new(ball[0], ball[1]), ball[4], Vec2.new(ball[2], ball[3]))
	model.pivot.set_xy(pivot[0], pivot[1])
	model.tilt_degrees = stored["tilt_degrees"]
	model.is_wall = stored["is_wall"]
	model.rewind()
