@abstract class_name PiCase
extends MeasuredCase
## Two blocks and a wall by one method: the number of impacts that it counts for a mass ratio of
## 100^n.

## The number of impacts for n = 0, 1, 2 and so on, as Galperin proved: the digits of pi.
const RIGHT_COUNTS: PackedInt64Array = [3, 31, 314, 3141, 31415, 314159, 3141592, 31415926]
## Seconds after which no impact follows, for any mass ratio.
const SECONDS := 8.0

# Microseconds. The count is repeated until a run takes at least this.
const _SHORTEST_RUN := 2000.0

## The heavy block has 100^n times the mass of the light one.
var n: int

# The result of the latest count, and its run time in microseconds.
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


## See [method MeasuredCase.run_once]: microseconds for the whole count.
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


## Counts the impacts and stores count and run time; may have to be awaited.
@abstract func _count_impacts() -> void
