class_name TimedShotReadout
extends RefCounted
## Shows in the readout when to fire and how long the bullet flies, with their errors.

var _readout: Readout
var _nanoseconds := 0.0


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout


## Measures the run time of the call.
func measure(model: TimedShotModel) -> void:
	_nanoseconds = CallTimer.nanoseconds(model.solved)


## Shows the moment and the flight of [param model], from the step on that shows the moment.
func show_model(model: TimedShotModel, step: TimedShotModel.Step) -> void:
	_readout.visible = step >= TimedShotModel.Step.WAIT
	_show_row(model, "fire", LabText.translate("fire"), model.shot().fire)
	_show_row(model, "flight", LabText.translate("flight f"), model.shot().flight)


func _show_row(model: TimedShotModel, key: String, title: String, seconds: float) -> void:
	var time := _readout.time_text(_nanoseconds)
	if not model.has_shot():
		_readout.show_texts(key, [title, LabText.translate("none"), "", time])
		return
	# Angles have no exact answer here.
	var error := ""
	if model.kind == TimedShotModel.Kind.LINE:
		var exact := ExactTimedShot.new(model.muzzle, model.bullet, model.target, model.velocity)
		var off := exact.error_of_fire(seconds) if key == "fire" else exact.error_of_flight(seconds)
		error = NumberText.size(off)
	_readout.show_texts(key, [title, NumberText.short(seconds), error, time])
