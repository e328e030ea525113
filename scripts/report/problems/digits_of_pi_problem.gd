class_name DigitsOfPiProblem
extends ReportProblem
## The seventh problem: digits of pi, counted by two blocks and a wall.

const _LAST := 7
const _QUICK_LAST := 5
# The numbers of steps in a second.
const _RATES: PackedInt32Array = [60, 960, 15360]


func _init() -> void:
	id = "digits_of_pi"
	champion = EventPi.METHOD
	title = "Digits of pi from two blocks and a wall"
	question = (
		"A block 100^n times as heavy as another pushes it against a wall; the number of impacts gives"
		+ " the digits of pi. The error is the difference from the right number."
	)
	run_time_axis = "run time, µs for all impacts"
	error_axis = "impacts too few or too many"


## See [method ReportProblem.cases].
func cases(is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for n in numbers(is_quick):
		found.append(EventPi.new(n))
		for rate in _RATES:
			found.append(SteppedPi.new(n, rate))
	return found


## The values of n that are measured.
static func numbers(is_quick: bool) -> PackedInt32Array:
	return PackedInt32Array(range((_QUICK_LAST if is_quick else _LAST) + 1))
