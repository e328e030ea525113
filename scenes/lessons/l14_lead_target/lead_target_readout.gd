class_name LeadTargetReadout
extends RefCounted
## Shows in the readout when the bullet hits, by the careful formula and by that of the slide, how
## late each is, and how long each call takes.

var _readout: Readout
var _nanoseconds: Dictionary[String, float] = {}


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout


## Measures the run time of both calls.
func measure(model: LeadTargetModel) -> void:
	_nanoseconds["careful"] = CallTimer.nanoseconds(model.aim)
	_nanoseconds["slide"] = CallTimer.nanoseconds(model.aim_by_the_slide)


## Shows both, from the step with the moment of the hit on.
func show_model(model: LeadTargetModel, step: int) -> void:
	_readout.visible = step >= LeadTargetModel.Step.TIME
	_show_call("careful", tr("t, careful"), model.aim(), model)
	_show_call("slide", tr("t, as on the slide"), model.aim_by_the_slide(), model)


func _show_call(key: String, title: String, aim: Aim, model: LeadTargetModel) -> void:
	var run_time := _readout.time_text(_nanoseconds[key])
	if not aim.hit:
		_readout.show_texts(key, [title, tr("none"), "", run_time])
		return
	var error := ""
	if model.can_hit():
		var seconds := 0.0 if aim.time == 0.0 else model.error_of_time(aim.time)
		error = tr("%s s") % NumberText.size(seconds)
	_readout.show_texts(key, [title, tr("%s s") % NumberText.short(aim.time), error, run_time])
