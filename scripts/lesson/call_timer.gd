class_name CallTimer
extends RefCounted
## How long a call takes, for readouts: a median, so that one interruption does not show.

const _BATCHES := 7
const _MIDDLE := 3
const _CALLS := 40


## Nanoseconds for one call of [param function], which takes no argument: the median of several
## batches, less what calling an empty function costs. Never below 0.
static func nanoseconds(function: Callable) -> float:
	return maxf(_median_of(function) - _median_of(_do_nothing), 0.0)


static func _median_of(function: Callable) -> float:
	var times: PackedFloat64Array = []
	for batch in _BATCHES:
		var start := Time.get_ticks_usec()
		for i in _CALLS:
			function.call()
		times.append((Time.get_ticks_usec() - start) * 1000.0 / _CALLS)
	times.sort()
	return times[_MIDDLE]


static func _do_nothing() -> void:
	pass
