class_name BankShotReadout
extends RefCounted
## Shows in the readout the direction of the shot, its error and the run time of the search.

var _readout: Readout
var _nanoseconds := 0.0


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout


## Measures the run time of the search for the way that arrives first.
func measure(model: BankShotModel) -> void:
	_nanoseconds = CallTimer.nanoseconds_of_slow(model.board.first_way)


## Shows the direction of [param model], with the run time that was measured last, from the step on
## that has it.
func show_model(model: BankShotModel, step: BankShotModel.Step) -> void:
	_readout.visible = step >= BankShotModel.Step.BOUNCE
	var way := model.answer().way
	if not way.hit:
		_readout.show_texts("direction", [tr("direction"), tr("none"), "", ""])
		return
	_readout.show_vector(
		"direction", tr("direction"), way.direction, model.board.error_of(way), _nanoseconds
	)
