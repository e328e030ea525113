class_name PointOfImpactReadout
extends RefCounted
## Shows in the readout where point of impact and position reset are, and how far each is from the
## exact contact on the path.

var _readout: Readout
var _nanoseconds: Dictionary[String, float] = {}


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout


## Measures the run time of both calls.
func measure(model: PointOfImpactModel) -> void:
	_nanoseconds["impact"] = CallTimer.nanoseconds(model.impact)
	_nanoseconds["reset"] = CallTimer.nanoseconds(model.reset_position)


## Shows both places of [param model], their errors, and the run times that were measured last,
## when the last step has both.
func show_model(model: PointOfImpactModel, step: int) -> void:
	_readout.visible = step >= PointOfImpactTexts.Step.IMPACT
	_show_call("impact", tr("POI"), model.impact_position() if model.touches() else null, model)
	_show_call("reset", tr("reset"), model.reset_position() if model.is_reset() else null, model)


# A row with the place, which is null where there is none.
func _show_call(key: String, title: String, place: Vec2, model: PointOfImpactModel) -> void:
	var time := tr("%s ns") % NumberText.short(_nanoseconds[key], 2)
	if place == null:
		_readout.show_texts(key, [title, tr("none"), "", time])
		return
	var error := ""
	if model.frame_case() == PointOfImpactModel.Case.IN_FRAME:
		var pixels := model.error_of(place)
		error = tr("%s px") % NumberText.short(pixels, 3 if pixels > 0.001 else 2)
	_readout.show_texts(key, [title, NumberText.pair(place.x, place.y, 3), error, time])
