class_name BallisticAimReadout
extends RefCounted
## Shows in the readout when the bullet hits by the careful formula and by that of the slide, with
## their errors and run times.

var _readout: Readout
var _nanoseconds: Dictionary[String, float] = {}


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout


## Measures the run time of both calls.
func measure(model: BallisticAimModel) -> void:
	var find := BallisticShots.aims.bind(model.aim_target(), model.pull(), model.speed)
	_nanoseconds["careful"] = CallTimer.nanoseconds(find)
	_nanoseconds["slide"] = CallTimer.nanoseconds(_by_the_slide.bind(model))


## Shows the time of the aim of [param model] that is flown, from the step on that shows the arcs.
func show_model(model: BallisticAimModel, step: BallisticAimModel.Step) -> void:
	_readout.visible = step >= BallisticAimModel.Step.ARCS
	if not model.has_shot():
		_show(
			"careful",
			[LabText.translate("t of hit"), LabText.translate("none"), "", _time("careful")]
		)
		_show("slide", [LabText.translate("by tangents"), LabText.translate("none"), "", ""])
		return
	_show_time("careful", LabText.translate("t of hit"), model.shot().time, model)
	if not model.is_fixed():
		_show(
			"slide", [LabText.translate("by tangents"), LabText.translate("only at rest"), "", ""]
		)
	elif model.gravity == 0.0 or model.target.x == 0.0:
		_show(
			"slide", [LabText.translate("by tangents"), LabText.translate("divides by 0"), "", ""]
		)
	else:
		var aims := _by_the_slide(model)
		# At the edge rounding alone can take them away.
		if aims.is_empty():
			_show(
				"slide",
				[LabText.translate("by tangents"), LabText.translate("none"), "", _time("slide")]
			)
		else:
			_show_time(
				"slide", LabText.translate("by tangents"), aims[model.arc_flown()].time, model
			)


func _show_time(key: String, title: String, seconds: float, model: BallisticAimModel) -> void:
	var error := NumberText.size(model.error_of_time(seconds))
	_show(key, [title, NumberText.short(seconds), error, _time(key)])


func _show(key: String, texts: PackedStringArray) -> void:
	_readout.show_texts(key, texts)


func _time(key: String) -> String:
	return _readout.time_text(_nanoseconds[key])


static func _by_the_slide(model: BallisticAimModel) -> Array[Aim]:
	return BallisticAim.at_fixed_by_the_slide(Vec2.zero(), model.target, model.gravity, model.speed)
