class_name LineDistanceReadout
extends RefCounted
## Shows in the readout the distance as measured from p and from the start of the line, and how far
## each is from the exact one.

var _readout: Readout
var _nanoseconds: Dictionary[String, float] = {}


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout


## Measures the run time of both calls.
func measure(model: LineDistanceModel) -> void:
	_nanoseconds["from_p"] = CallTimer.nanoseconds(model.distance)
	_nanoseconds["from_start"] = CallTimer.nanoseconds(model.distance_from_start)


## Shows both distances of [param model], their errors, and the run times that were measured last,
## from the step of the distance on, but not while the ball flies.
func show_model(model: LineDistanceModel, step: int) -> void:
	var is_detected := step == LineDistanceTexts.Step.DETECTION
	_readout.visible = step >= LineDistanceTexts.Step.DISTANCE and not is_detected
	_show_call("from_p", tr("from p"), model.distance(), model)
	_show_call("from_start", tr("from the start"), model.distance_from_start(), model)


func _show_call(key: String, title: String, value: float, model: LineDistanceModel) -> void:
	var error := ExactLineDistance.error_of(value, model.ball.position, model.line)
	_readout.show_result(key, title, value, error, _nanoseconds[key])
