class_name LineEndsReadout
extends RefCounted
## The fractions of the frame before the impacts, with their errors against about 100 bits, and what
## the calls cost.

var _readout: Readout


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout


## Shows the fractions for the shot of [param model], from the step of the roots on.
func show_model(model: LineEndsModel, step: int) -> void:
	_readout.visible = step >= LineEndsTexts.Step.ROOTS
	if not _readout.visible:
		return
	var facing := SegmentImpact.facing_segment(model.start, model.segment)
	_show(
		"line",
		tr("t, infinite line"),
		PointOfImpact.with_line.bind(model.start, model.motion, model.radius, facing),
		ExactImpactFraction.with_line(model.start, model.motion, model.radius, facing)
	)
	var feature := model.nearest_cap()
	var point := model.cap_point()
	_show(
		"cap",
		tr("t, end %s") % LineEndsTexts.end_name(model),
		CapImpact.with_point.bind(model.start, model.motion, model.radius, point, feature),
		ExactImpactFraction.with_point(model.start, model.motion, model.radius, point)
	)


func _show(key: String, title: String, find: Callable, exact: DoubleDouble) -> void:
	var impact: Impact = find.call()
	var nanoseconds := CallTimer.nanoseconds(find)
	# A ball that overlaps at the start touches at once: there 0 is exact.
	if impact.hit and exact:
		var error := 0.0 if impact.fraction == 0.0 else exact.error_of(impact.fraction)
		_readout.show_result(key, title, impact.fraction, error, nanoseconds)
	else:
		var none := tr("none")
		_readout.show_texts(key, [title, none, "–", _readout.time_text(nanoseconds)])
