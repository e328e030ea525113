class_name ErrorAndTimeReadout
extends RefCounted
## The readout of the lesson on error and run time: both ends of the frontier, and the measurement
## that is pointed at.

var _readout: Readout


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout
	_readout.is_the_point = true
	_readout.show_headings(["", tr("error"), tr("run time"), tr("× fastest")] as PackedStringArray)


## Shows the measurement at [param place], -1 for none, beside the ends of [param frontier].
func show_point(measurements: Array[Measurement], frontier: PackedInt32Array, place: int) -> void:
	var fastest := measurements[frontier[0]] if frontier else null
	var closest := measurements[frontier[-1]] if frontier else null
	var pointed := measurements[place] if place >= 0 and frontier else null
	_show_row(tr("fastest"), fastest, fastest)
	_show_row(tr("closest"), closest, fastest)
	_show_row(tr("pointed at"), pointed, fastest)


func _show_row(title: String, measurement: Measurement, fastest: Measurement) -> void:
	var row: PackedStringArray = [title, "–", "–", "–"]
	if measurement:
		var error := NumberText.size(measurement.error) if measurement.has_answer() else "∞"
		var times := measurement.run_time_us / fastest.run_time_us
		var run_time := ErrorAndTimeTexts.run_time(measurement.run_time_us)
		row = [title, error, run_time, NumberText.short(times, 3)]
	_readout.show_texts(title, row)
