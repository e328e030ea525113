class_name MeasuringRun
extends RefCounted
## The methods of one problem in one situation, measured in turn, one run at a time, so that the
## window stays alive in between.

## So many runs of each method are made; their median counts.
const ROUNDS := 5

## It is to go on. False before the first run, when it was stopped, and when it is done.
var is_going := false

var _cases: Array[MeasuredCase] = []
var _runs := 0


## A run over these cases, none of them run yet.
func _init(cases: Array[MeasuredCase]) -> void:
	_cases = cases


## Makes the next single run; the last one ends it.
func measure_next() -> void:
	_cases[_runs % _cases.size()].run_once()
	_runs += 1
	if is_done():
		is_going = false


## All runs have been made.
func is_done() -> bool:
	return _runs >= ROUNDS * _cases.size()


## The share of all runs that have been made, 0..1.
func share() -> float:
	return float(_runs) / (ROUNDS * _cases.size())


## How many runs have been made.
func runs() -> int:
	return _runs


## How many runs there are in all.
func all_runs() -> int:
	return ROUNDS * _cases.size()


## The methods in their order, each once.
func methods() -> PackedStringArray:
	var found: PackedStringArray = []
	for case in _cases:
		if not case.method in found:
			found.append(case.method)
	return found


## Whether each of [method methods] is the engine's own.
func are_peers() -> Array[bool]:
	var found: Array[bool] = []
	for method in methods():
		found.append(
			_cases.any(
				func(case: MeasuredCase) -> bool: return case.method == method and case.is_peer
			)
		)
	return found


## What has been measured so far, in the order of the cases.
func measurements() -> Array[Measurement]:
	var found: Array[Measurement] = []
	for case in _cases:
		if case.runs() > 0:
			found.append(case.result())
	return found
