@abstract class_name PiCase
extends MeasuredCase
## Two blocks and a wall by one method: how many impacts it counts, for a mass ratio of 100^n.

## The impacts for n = 0, 1, 2 and so on, as Galperin proved: the digits of pi.
const RIGHT_COUNTS: PackedInt64Array = [3, 31, 314, 3141, 31415, 314159, 3141592, 31415926]
## Seconds after which the blocks have parted for good, however heavy the one is.
const SECONDS := 8.0

# Microseconds. It is run so often that a run takes at least this.
const _SHORTEST_RUN := 2000.0

## The heavy block has 100^n times the mass of the light one.
var n: int

# What the latest count has found, and the microseconds it took.
var _count := 0
var _spent := 0.0


## Blocks for this n.
func _init(of_n: int) -> void:
	n = of_n
	problem = "digits_of_pi"
	situation = "n = %d" % n
	error_unit = "impacts"


## The heavy block's mass.
func mass_ratio() -> float:
	return 100.0 ** n


## See [method MeasuredCase.run_once]: microseconds for all of it.
func run_once() -> void:
	var times := 0
	var spent := 0.0
	while spent < _SHORTEST_RUN and not refusal:
		@warning_ignore("redundant_await")
		await _count_impacts()
		spent += _spent
		times += 1
	error = absf(_count - RIGHT_COUNTS[n])
	note = "%d impacts, %d are right" % [_count, RIGHT_COUNTS[n]]
	keep_run(spent / maxi(times, 1))


## Counts them and sets how long it took; may have to be awaited.
@abstract func _count_impacts() -> void
