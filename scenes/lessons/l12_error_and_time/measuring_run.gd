class_name MeasuringRun
extends LiveRun
## The methods of one problem in one situation, measured one after the other.

## So many runs of each method are made; their median counts, and only then it is shown: a flight
## may be flown in parts, and has no error before the last.
const ROUNDS := 5

var _cases: Array[MeasuredCase] = []
var _runs := 0


## A run over these cases, none of them run yet.
func _init(cases: Array[MeasuredCase]) -> void:
	_cases = cases


## See [method LiveRun.size]: a part is a single run.
func size() -> int:
	return ROUNDS * _cases.size()


## See [method LiveRun.done_count].
func done_count() -> int:
	return _runs


## See [method LiveRun.do_next].
func do_next() -> void:
	_case_in_turn().run_once()
	_runs += 1


## The method that is measured next, or was last.
func method_in_turn() -> String:
	return _case_in_turn().method


## The methods in their order, each once.
func methods() -> PackedStringArray:
	var found: PackedStringArray = []
	for case in _cases:
		if not case.method in found:
			found.append(case.method)
	return found


## Whether each of [method methods] is the engine's own.
func are_baselines() -> Array[bool]:
	var found: Array[bool] = []
	for method in methods():
		found.append(
			_cases.any(
				func(case: MeasuredCase) -> bool: return case.method == method and case.is_baseline
			)
		)
	return found


## What has been measured so far, in the order of the cases.
func measurements() -> Array[Measurement]:
	var found: Array[Measurement] = []
	for i in floori(float(_runs) / ROUNDS):
		found.append(_cases[i].result())
	return found


func _case_in_turn() -> MeasuredCase:
	return _cases[mini(floori(float(_runs) / ROUNDS), _cases.size() - 1)]
