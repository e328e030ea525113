class_name WorkshopRunTime
extends RefCounted
## The run time of a student's method beside the lab's own, measured in turns in one process.

const _TURNS := 9
const _CALLS := 20

## Nanoseconds for a call of the student's method, a median.
var nanoseconds := 0.0
## The same for the lab's own.
var reference_nanoseconds := 0.0
## The median of the ratios of all turns.
var ratio := 0.0


## Measures both ways to call [param task] on its first probe.
func _init(task: WorkshopTask, timed: WorkshopCall) -> void:
	var own: PackedFloat64Array = []
	var of_lab: PackedFloat64Array = []
	var ratios: PackedFloat64Array = []
	var numbers := task.probes[0].numbers
	var prepared := timed.prepared(numbers)
	var lab_call := WorkshopCall.of_lab(task)
	var reference_prepared := lab_call.prepared(numbers)
	for turn in _TURNS:
		own.append(_time_of(prepared))
		of_lab.append(_time_of(reference_prepared))
		ratios.append(own[-1] / maxf(of_lab[-1], 1.0))
	nanoseconds = _median(own)
	reference_nanoseconds = _median(of_lab)
	ratio = _median(ratios)


static func _time_of(prepared: Callable) -> float:
	var begun := Time.get_ticks_usec()
	for i in _CALLS:
		prepared.call()
	return (Time.get_ticks_usec() - begun) * 1000.0 / _CALLS


static func _median(values: PackedFloat64Array) -> float:
	values.sort()
	return values[values.size() >> 1]
