class_name ErrorAndTimeModel
extends LessonModel
## The lesson on error and run time: which problem is measured, in which situation, what has been
## found so far, and what of it is on the frontier.

# Where there is more to see in another situation than in the first: pi from mass ratio 10000 on.
const _FIRST_SITUATIONS: Dictionary[String, int] = {"digits_of_pi": 2}

## The problems that can be chosen, in their order.
var problems := LiveProblems.all()
## The place of the one that is chosen: at first the ball in a box, where there is most to see.
var problem_place := 1
## The place of the situation of this problem that is chosen.
var situation_place := 0
## Whether the table of stability is open instead of the plot.
var is_stability_open := false
## The stiff and extreme cases.
var stability := StabilityRun.new(StabilityCases.all())

# Returns the cases of the engine for a problem's id: they need a scene, which the lesson has.
var _engine_cases: Callable
# All cases of a problem by its id, and the runs of its situations. They are kept: a problem that is
# chosen again shows what was found before.
var _cases: Dictionary[String, Array] = {}
var _runs: Dictionary[String, MeasuringRun] = {}


## A model whose problems are also solved by the cases that [param engine_cases] returns, as an
## Array[MeasuredCase], for a problem's id.
func _init(engine_cases: Callable) -> void:
	_engine_cases = engine_cases


## The problem that is chosen.
func problem() -> ReportProblem:
	return problems[problem_place]


## The place of the problem with the id [param id]; -1 where none has it.
func place_of(id: String) -> int:
	return problems.find_custom(func(some: ReportProblem) -> bool: return some.id == id)


## Chooses a problem by its place, in the situation that shows most.
func choose_problem(place: int) -> void:
	problem_place = place
	situation_place = _FIRST_SITUATIONS.get(problem().id, 0)


## The situations of the problem that is chosen.
func situations() -> PackedStringArray:
	return _situations_of(problem())


## The run of the problem and situation that are chosen.
func run() -> MeasuringRun:
	var key := "%s %d" % [problem().id, situation_place]
	if not _runs.has(key):
		_runs[key] = MeasuringRun.new(_cases_of(situations()[situation_place]))
	return _runs[key]


## The run that is shown: the one of the problem, or the one of the table.
func open_run() -> LiveRun:
	if is_stability_open:
		return stability
	return run()


## Begins what is shown or goes on with it; what is done already is done anew.
func begin() -> void:
	if open_run().is_done():
		forget()
	open_run().is_going = true


## Goes on with what is shown, unless it is done.
func go_on() -> void:
	open_run().is_going = not open_run().is_done()


## Stops what is shown where it is.
func stop() -> void:
	open_run().is_going = false


## Forgets all results of what is shown.
func forget() -> void:
	if is_stability_open:
		stability = StabilityRun.new(StabilityCases.all())
		return
	_cases.erase(problem().id)
	for place in situations().size():
		_runs.erase("%s %d" % [problem().id, place])


## The places in [param measurements] of those that no other beats, the fastest first.
static func frontier(measurements: Array[Measurement]) -> PackedInt32Array:
	var places: PackedInt32Array = []
	for best in Frontier.of(measurements):
		places.append(measurements.find(best))
	return places


## Whether the measurement with the smallest error is the fastest of all (0), one in between (1) or
## the slowest (2); -1 before all are made.
func rank_of_closest() -> int:
	var all := run().measurements()
	if not run().is_done() or all.size() < 3:
		return -1
	var closest := all[frontier(all)[-1]].run_time_us
	var times := all.map(func(one: Measurement) -> float: return one.run_time_us)
	if closest == times.min():
		return 0
	return 2 if closest == times.max() else 1


## The place of the next slower measurement of the same method; of the next faster one for the
## slowest; -1 where the method has one setting only.
static func neighbour(measurements: Array[Measurement], place: int) -> int:
	var here := measurements[place]
	var slower := -1
	var faster := -1
	for i in measurements.size():
		var other := measurements[i]
		if i == place or other.method != here.method:
			continue
		if other.run_time_us > here.run_time_us:
			if slower < 0 or other.run_time_us < measurements[slower].run_time_us:
				slower = i
		elif faster < 0 or other.run_time_us > measurements[faster].run_time_us:
			faster = i
	return slower if slower >= 0 else faster


## The place of the first measurement whose error falls while its run time grows, so that it has an
## order p above 0; -1 where there is none.
static func place_with_order(measurements: Array[Measurement]) -> int:
	for place in measurements.size():
		var other := neighbour(measurements, place)
		if other >= 0 and order(measurements[place], measurements[other]) > 0.0:
			return place
	return -1


## The order p between two measurements of a method, log(e1/e2) / log(t2/t1): the error falls as
## the run time to the power -p. It is computed from the ratios as they are shown: more digits than
## that are not in a run time. NaN where an error is 0 or no answer, or where both took the same
## time.
static func order(one: Measurement, other: Measurement) -> float:
	var errors := log(NumberText.rounded(error_ratio(one, other)))
	var times := log(NumberText.rounded(time_ratio(one, other)))
	return errors / times if times != 0.0 and is_finite(times) and is_finite(errors) else NAN


## The ratio of two errors, e1/e2; NaN where one is 0 or no answer.
static func error_ratio(one: Measurement, other: Measurement) -> float:
	if one.error == 0.0 or other.error == 0.0 or not (one.has_answer() and other.has_answer()):
		return NAN
	return one.error / other.error


## The ratio of two run times, t2/t1.
static func time_ratio(one: Measurement, other: Measurement) -> float:
	return other.run_time_us / one.run_time_us


## What the student has chosen; not what was measured.
func to_dictionary() -> Dictionary:
	return {
		"problem": problem().id,
		"situation": situation_place,
		"stability": is_stability_open,
	}


func problem_in(stored: Dictionary) -> String:
	var id: String = stored["problem"]
	var place: int = stored["situation"]
	var wanted := place_of(id)
	if wanted < 0:
		var ids := problems.map(func(some: ReportProblem) -> String: return some.id)
		return StateCheck.word("problem", id, ids)
	var count := _situations_of(problems[wanted]).size()
	return StateCheck.within("situation", place, 0, count - 1)


func from_dictionary(stored: Dictionary) -> void:
	var id: String = stored["problem"]
	problem_place = place_of(id)
	situation_place = stored["situation"]
	is_stability_open = stored["stability"]


func _situations_of(some_problem: ReportProblem) -> PackedStringArray:
	var found: PackedStringArray = []
	for case in _all_cases(some_problem):
		if not case.situation in found:
			found.append(case.situation)
	return found


func _cases_of(situation: String) -> Array[MeasuredCase]:
	return _all_cases(problem()).filter(
		func(case: MeasuredCase) -> bool: return case.situation == situation
	)


# Cases that wait for frames of the engine are left out: here they would measure the screen.
# `./lab report` has them.
func _all_cases(of_problem: ReportProblem) -> Array[MeasuredCase]:
	var id := of_problem.id
	if not _cases.has(id):
		var found := of_problem.cases(true)
		var engine: Array[MeasuredCase] = _engine_cases.call(id)
		found.append_array(engine)
		_cases[id] = found.filter(func(case: MeasuredCase) -> bool: return not case.needs_frames)
	var cases: Array[MeasuredCase] = []
	cases.assign(_cases[id])
	return cases
