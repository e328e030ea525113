extends SceneTree
## Run time of an impact under constant acceleration, in the cases that a world meets.
##
## Run with: ./lab bench impacts
## [br][br]
## Each case is many flights of one kind, shifted a little, so that no two calls are alike. The runs
## of all cases take turns, so that a slow moment of the machine hits all alike; the median counts,
## less the loop that only sets the flight.

const RUNS := 9
const CALLS_PER_RUN := 4000

## Seconds that a prediction looks ahead.
const HORIZON := 5.0

## Flight px, py, vx, vy, gx, gy, r, and segment ax, ay, bx, by.
const CASES: Dictionary[String, Array] = {
	"hits the line": [0, -200, 60, -100, 0, 400, 10, -300, 50, 300, 90],
	"hits a cap, from above": [0, -200, 30, -100, 0, 400, 10, 45, 20, 300, 90],
	"hits a cap, past its middle": [0, -200, 30, -100, 0, 400, 10, 38, 20, -200, 90],
	"misses: passes beside the end": [0, -200, 30, -100, 0, 400, 10, 120, 20, 300, 90],
	"misses: apex before the line": [0, 0, 60, -100, 0, 400, 10, -300, -90, 300, -80],
	"misses: moves away": [0, 0, 60, 100, 0, 400, 10, -300, -90, 300, -80],
	"misses: after the horizon": [0, -50000, 60, 0, 0, 400, 10, -300, 50, 300, 90],
	"starts inside, leaves, falls back": [0, -5, 60, -200, 0, 400, 10, -300, 0, 300, 0],
}

var _solver := AcceleratedImpactFinder.new()
var _hits := 0


func _init() -> void:
	var times: Dictionary[String, PackedFloat64Array] = {}
	for case: String in CASES:
		times[case] = PackedFloat64Array()
	var empty := PackedFloat64Array()
	for _run: int in RUNS:
		empty.append(_empty_run())
		for case: String in CASES:
			times[case].append(_run_of(case))
	print("Microseconds a call, median of %d runs of %d calls.\n" % [RUNS, CALLS_PER_RUN])
	print("| case | with_segment | finds an impact |")
	print("| --- | ---: | --- |")
	for case: String in CASES:
		_run_of(case)
		var time := _median(times[case]) - _median(empty)
		var finds := "%d %%" % roundi(100.0 * _hits / CALLS_PER_RUN)
		print("| %s | %s | %s |" % [case, String.num(time, 2), finds])
	print("\nSetting the flight: %s." % String.num(_median(empty), 2))
	quit()


# Microseconds for one call with its flight.
func _run_of(case: String) -> float:
	var n := PackedFloat64Array(CASES[case])
	var ax := n[7]
	var ay := n[8]
	var bx := n[9]
	var by := n[10]
	_hits = 0
	var start := Time.get_ticks_usec()
	for number: int in CALLS_PER_RUN:
		_solver.set_flight(n[0] + number * 1e-4, n[1], n[2], n[3], n[4], n[5], n[6])
		if _solver.with_segment(ax, ay, bx, by, HORIZON):
			_hits += 1
	return (Time.get_ticks_usec() - start) / float(CALLS_PER_RUN)


# The same without looking for an impact.
func _empty_run() -> float:
	var n := PackedFloat64Array(CASES["hits the line"])
	_hits = 0
	var start := Time.get_ticks_usec()
	for number: int in CALLS_PER_RUN:
		_solver.set_flight(n[0] + number * 1e-4, n[1], n[2], n[3], n[4], n[5], n[6])
		if n.is_empty():
			_hits += 1
	return (Time.get_ticks_usec() - start) / float(CALLS_PER_RUN)


func _median(values: PackedFloat64Array) -> float:
	var sorted := values.duplicate()
	sorted.sort()
	return sorted[floori(sorted.size() / 2.0)]
