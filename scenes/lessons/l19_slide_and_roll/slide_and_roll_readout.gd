class_name SlideAndRollReadout
extends RefCounted
## Shows in the readout when the ball is at the end of the line: by the formula, in frames as a game
## computes it, and as Godot's own body was measured; how late each is, and how long a call takes.
## And how fast it still slips then.

const _FRAME := 1.0 / 60.0
# Longer runs are not computed in frames: they would take too long.
const _LONGEST_IN_FRAMES := 4.0

var _readout: Readout
var _nanoseconds: Dictionary[String, float] = {}


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout


## Measures the run time of both calls.
func measure(model: SlideAndRollModel) -> void:
	_nanoseconds["formula"] = CallTimer.nanoseconds(_by_formula.bind(model))
	_nanoseconds["frames"] = 0.0
	if _can_step(model.ball()):
		_nanoseconds["frames"] = CallTimer.nanoseconds(_by_frames.bind(model))


## Shows all of them, from the race on. [param engine] is Godot's body, null where there is none.
func show_model(model: SlideAndRollModel, race: BallRace, engine: EngineRoll, step: int) -> void:
	_readout.visible = step >= SlideAndRollModel.Step.RACE
	_readout.is_the_point = step == SlideAndRollModel.Step.ERROR
	var in_frames: InclineRun = _by_frames(model) if _can_step(race.ball) else null
	_show_row("formula", tr("t, by the formula"), model, race, race.ball.end_time)
	_show_row(
		"frames", tr("t, in frames of 1/60 s"), model, race, in_frames.time if in_frames else INF
	)
	_show_slip(model, race, in_frames)
	var measured := engine.end_time if engine else INF
	_show_row("engine", tr("t, Godot's RigidBody2D"), model, race, measured)
	_readout.show_rows(5 if engine else 4)


# How the lowest point of the ball rubs at last: by frames, and how far that is from the formula.
func _show_slip(model: SlideAndRollModel, race: BallRace, in_frames: InclineRun) -> void:
	var title := tr("slip at the end, in frames")
	if not in_frames or not race.arrives():
		_readout.show_texts("slip", [title, tr("none"), "", ""])
		return
	var incline := model.incline(model.friction)
	var slip := incline.slip(model.radius, in_frames.speed, in_frames.spin)
	var right := race.ball.after(race.ball.end_time)
	var error := slip - _slip_of(right, incline, model.radius)
	var texts: PackedStringArray = [NumberText.short(slip), NumberText.size(error)]
	_readout.show_texts("slip", [title, tr("%s px/s") % texts[0], tr("%s px/s") % texts[1], ""])


func _show_row(
	key: String, title: String, model: SlideAndRollModel, race: BallRace, seconds: float
) -> void:
	if seconds == INF or not race.arrives():
		_readout.show_texts(key, [title, tr("none"), "", ""])
		return
	var error := NumberText.size(model.error_of_end(seconds, race.ball))
	var run_time := _readout.time_text(_nanoseconds[key]) if _nanoseconds.has(key) else ""
	var value := tr("%s s") % NumberText.short(seconds)
	_readout.show_texts(key, [title, value, tr("%s s") % error, run_time])


# What rolls does not slip at all.
static func _slip_of(run: InclineRun, incline: Incline, radius: float) -> float:
	if run.regime == InclineRun.Regime.ROLLS:
		return 0.0
	return incline.slip(radius, run.speed, run.spin)


static func _by_formula(model: SlideAndRollModel) -> InclineRun:
	var incline := model.incline(model.friction)
	return incline.run(model.radius, 0.0, model.speed, 0.0, Incline.LARGEST)


static func _by_frames(model: SlideAndRollModel) -> InclineRun:
	var incline := model.incline(model.friction)
	return incline.run_by_frames(
		model.radius, 0.0, model.speed, 0.0, 2.0 * _LONGEST_IN_FRAMES, _FRAME
	)


static func _can_step(ball: RacingBall) -> bool:
	return ball.end_time <= _LONGEST_IN_FRAMES
