class_name FakeCase
extends MeasuredCase
## A case with a known answer, whose runs take no time but say they do.

var _times: PackedFloat64Array = []


## A case that is measured to take these times, one after the other, again and again.
func _init(its_method: String, its_situation: String, times: PackedFloat64Array) -> void:
	problem = "fake"
	method = its_method
	situation = its_situation
	_times = times


func run_once() -> void:
	keep_run(_times[runs() % _times.size()])
