class_name SlideAndRollCode
extends RefCounted
## The lines of GDScript that compute what each step of the lesson on sliding and rolling shows.


## The lines of [param step]; none where there is nothing to compute.
static func lines(model: SlideAndRollModel, race: BallRace, step: int) -> PackedStringArray:
	match step:
		SlideAndRollModel.Step.SLIDE:
			return ["var along := end.minus(start)", "var length := along.length()"]
		SlideAndRollModel.Step.PULL:
			return [
				"var pull := gravity * along.y / length",
				"var pressure := gravity * along.x / length",
			]
		SlideAndRollModel.Step.SLIP:
			return ["var grip := friction * pressure", "var slip_growth := pull - 3.0 * grip"]
		SlideAndRollModel.Step.MARK:
			return ["var can_roll := 3.0 * friction * pressure >= pull"]
		SlideAndRollModel.Step.ROLL:
			return _lines_on_roll(race)
	if race.arrives() and model.speed == 0.0:
		return ["var t := sqrt(2.0 * length / acceleration)"]
	return []


static func _lines_on_roll(race: BallRace) -> PackedStringArray:
	match race.run_case:
		SlideAndRollModel.Case.RESTS:
			return []
		SlideAndRollModel.Case.ROLLS:
			return ["var acceleration := pull * 2.0 / 3.0"]
		SlideAndRollModel.Case.ROLLS_LATER:
			return [
				"var change := speed / (3.0 * grip - pull)",
				"var speed_then := speed + (pull - grip) * change",
				"var acceleration := pull * 2.0 / 3.0",
			]
	return ["var acceleration := pull - grip"]


## The values of the names in the lines.
static func inputs(model: SlideAndRollModel, race: BallRace) -> Dictionary[String, Variant]:
	var incline := model.incline(model.friction)
	var grip := model.friction * incline.pressure
	return {
		"start": model.start,
		"end": model.end,
		"along": model.segment().along(),
		"length": incline.length,
		"gravity": model.gravity,
		"friction": model.friction,
		"speed": model.speed,
		"pull": incline.pull,
		"pressure": incline.pressure,
		"grip": grip,
		"acceleration": model.last_acceleration(race.run_case),
	}
