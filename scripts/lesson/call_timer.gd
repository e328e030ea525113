class_name CallTimer
extends RefCounted
## How long a call takes, for readouts: a median, so that one interruption does not show.

const _BATCHES := 7
const _MIDDLE := 3
const _CALLS := 40
# Browsers round the time to about 0.1 ms: measuring this many microseconds keeps the error below
# 10 %.
const _LONG_ENOUGH := 1000
# The fastest of this many runs counts: interruptions make a call slower, never faster.
const _TRIES := 3
# Measuring ends even if a call takes no time.
const _MOST_CALLS := 10_000

## Off, every call takes 0 ns: for tests that look at thousands of boards.
static var is_measuring := true

# Nanoseconds that calling an empty function takes in a browser; NAN before it was measured.
static var _empty_call := NAN


## Nanoseconds for one call of [param function], which takes no argument: the median of several
## batches, less what calling an empty function costs; in a browser by [method fastest_by]. Never
## below 0.
static func nanoseconds(function: Callable) -> float:
	if not is_measuring:
		return 0.0
	if not OS.has_feature("web"):
		return maxf(_median_of(function) - _median_of(_do_nothing), 0.0)
	if is_nan(_empty_call):
		_empty_call = fastest_by(Time.get_ticks_usec, _do_nothing)
	return maxf(fastest_by(Time.get_ticks_usec, function) - _empty_call, 0.0)


## The same for a call that takes a millisecond or more: the fastest of a few single ones.
static func nanoseconds_of_slow(function: Callable) -> float:
	var fastest := INF
	for i in _TRIES if is_measuring else 0:
		var start := Time.get_ticks_usec()
		function.call()
		fastest = minf(fastest, (Time.get_ticks_usec() - start) * 1000.0)
	return fastest if is_measuring else 0.0


## Nanoseconds for one call of [param function] by a [param clock] that tells microseconds in large
## steps: the mean over enough calls, the lowest of three.
static func fastest_by(clock: Callable, function: Callable) -> float:
	var fastest := INF
	for i in _TRIES:
		fastest = minf(fastest, _mean_by(clock, function))
	return fastest


static func _mean_by(clock: Callable, function: Callable) -> float:
	var start: int = clock.call()
	var now := start
	var calls := 0
	while now - start < _LONG_ENOUGH and calls < _MOST_CALLS:
		for i in _CALLS:
			function.call()
		calls += _CALLS
		now = clock.call()
	return (now - start) * 1000.0 / calls


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
