extends RefCounted
## Measures all methods at one problem: every case runs once, then every case a second time, and so
## on, so that a slow moment of the machine hits all alike.

## The median of this many runs counts.
const RUNS := 5


static func measure(problem: ReportProblem, is_quick: bool, host: Node) -> Array[Measurement]:
	var cases := problem.cases(is_quick) + problem.ceilings()
	cases.append_array(EngineCases.of(problem.id, is_quick, host))
	cases.append_array(EngineAimCases.of(problem.id, is_quick))
	var start := Time.get_ticks_msec()
	for run: int in RUNS:
		for case: MeasuredCase in cases:
			@warning_ignore("redundant_await")
			await case.run_once()
		print(
			"%s: %d methods and settings, run %d of %d" % [problem.id, cases.size(), run + 1, RUNS]
		)
	var measurements: Array[Measurement] = []
	for case: MeasuredCase in cases:
		measurements.append(case.result())
		case.finish()
	print("%s: %.1f s" % [problem.id, (Time.get_ticks_msec() - start) / 1000.0])
	return measurements
