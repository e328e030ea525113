class_name StabilityRun
extends LiveRun
## The stiff and extreme cases, tried one after the other, the long ones in their quick form. Long
## ones without a quick form are left out.

## The cases that are tried, in the order of the table.
var cases: Array[StabilityCase] = []
## Those that take too long here.
var left_out: Array[StabilityCase] = []
## The results of the cases that have been tried, in their order.
var results: Array[StabilityResult] = []


## Will try these cases.
func _init(of_cases: Array[StabilityCase]) -> void:
	for case in of_cases:
		if case.has_quick_form():
			cases.append(case)
		else:
			left_out.append(case)


## See [method LiveRun.size].
func size() -> int:
	return cases.size()


## See [method LiveRun.done_count].
func done_count() -> int:
	return results.size()


## See [method LiveRun.do_next].
func do_next() -> void:
	results.append(cases[results.size()].run(true))


## How many of the tried cases hold.
func passed_count() -> int:
	var count := 0
	for result in results:
		count += 1 if result.passed else 0
	return count


## The place of the first tried case that does not hold; 0 where all hold.
func first_failure() -> int:
	for place in results.size():
		if not results[place].passed:
			return place
	return 0
