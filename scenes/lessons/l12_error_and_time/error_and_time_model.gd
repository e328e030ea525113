class_name ErrorAndTimeModel
extends RefCounted
## The lesson on error and run time: which problem is measured, in which situation, what was
## found so far, and what of it stands on the frontier.

## The problems that can be chosen, in their order.
var problems := ReportProblems.all()
## Which one is chosen, by its place: at first the ball in a box, where there is most to see.
var problem_place := 1
## Which of its situations is chosen, by its place.
var situation_place := 0
## The table of stability is open instead.
var is_stability_open := false
## The stiff and extreme cases.
var stability := StabilityRun.new(StabilityCases.all())

# The cases of the engine for a problem's id, as an array; set by whoever has a scene.
var _engine_cases: Callable
# All cases of a problem, and the runs of its situations, kept so that a problem that is chosen
# again shows what was found.
var _cases: Dictionary[String, Array] = {}
var _runs: Dictionary[String, MeasuringRun] = {}


## A model whose problems are also solved by what [param engine_cases] returns for a problem's id:
## an Array[MeasuredCase].
func _init(engine_cases: Callable) -> void:
	_engine_cases = engine_cases


## The problem that is chosen.
func problem() -> ReportProblem:
	return problems[problem_place]


## Chooses a problem, in its first situation.
func choose_problem(place: int) -> void:
	problem_place = place
	situation_place = 0


## The situations of the problem that is chosen.
func situations() -> PackedStringArray:
	return _situations_of(problem())


## The run of the problem and situation that are chosen.
func run() -> MeasuringRun:
	var key := "%s %d" % [problem().id, situation_place]
	if not _runs.has(key):
		_runs[key] = MeasuringRun.new(_cases_of(situations()[situation_place]))
	return _runs[key]


## The run that is looked at: that of the problem, or that of the table.
func open_run() -> LiveRun:
	if is_stability_open:
		return stability
	return run()


## Begins what is looked at, or goes on; what is done already is done anew.
func begin() -> void:
	if open_run().is_done():
		forget()
	open_run().is_going = true


## Forgets all that was found of what is looked at.
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


## The place of the next slower measurement of the same method, or of the next faster one where
## there is none; -1 where a method has one setting only.
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


## The order p between two measurements of a method: so many times steeper than the run time grows
## does the error shrink, log(e1/e2) / log(t2/t1). NaN where an error is 0 or no answer, or both
## took the same time.
static func order(one: Measurement, other: Measurement) -> float:
	var errors := log(one.error / other.error) if other.error > 0.0 and one.error > 0.0 else NAN
	var times := log(other.run_time_us / one.run_time_us)
	return errors / times if times != 0.0 and is_finite(errors) else NAN


## All that the student has chosen, for undo and links; not what was measured.
func to_dictionary() -> Dictionary:
	return {
		"problem": problem().id,
		"situation": situation_place,
		"stability": is_stability_open,
	}


## "" if a state such as [method to_dictionary] tells can be put back; else one sentence with the
## value and what is allowed.
func problem_of(stored: Dictionary) -> String:
	var ids: PackedStringArray = []
	for some in problems:
		ids.append(some.id)
	var wanted := ids.find(str(stored["problem"]))
	if wanted < 0:
		return StateCheck.word("problem", str(stored["problem"]), ids)
	var place: int = stored["situation"]
	var count := _situations_of(problems[wanted]).size()
	return StateCheck.within("situation", place, 0, count - 1)


## Puts back what [method to_dictionary] has told.
func from_dictionary(stored: Dictionary) -> void:
	for place in problems.size():
		if problems[place].id == stored["problem"]:
			problem_place = place
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


# A run that waits for frames of the engine would measure the screen: ./lab report has those.
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
