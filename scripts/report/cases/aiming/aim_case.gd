class_name AimCase
extends MeasuredCase
## A way to find shots, tried on all questions of a situation: how long it takes for one, and by how
## much the worst one misses.
##
## The ways of the engine are cases of this class, too, with questions in the engine's vectors.

# Microseconds. The questions are asked again until a run takes at least this.
const _SHORTEST_RUN := 2000.0
# Pixels. What comes nearer counts as a hit in the note.
const _HIT := 1.0

# What is asked, each in the form that the way takes.
var _questions: Array
var _solver: Callable
var _miss: Callable


## A case for the problem with this id. [code]solver.call(question)[/code] finds the shot, and
## [code]miss.call(question, shot)[/code] says by how much it misses, in pixels: NAN for none.
func _init(
	of_problem: String, of_situation: String, questions: Array, solver: Callable, miss: Callable
) -> void:
	problem = of_problem
	situation = of_situation
	_questions = questions
	_solver = solver
	_miss = miss


## The same case with the name of the way, and how it is tuned, as `60 Hz`.
func named(its_method: String, with_tuning: String = "") -> AimCase:
	method = its_method
	tuning = with_tuning
	return self


## See [method MeasuredCase.run_once]: microseconds for one shot.
func run_once() -> void:
	if runs() == 0:
		_find_error()
	var start := Time.get_ticks_usec()
	var spent := 0.0
	var times := 0
	while spent < _SHORTEST_RUN:
		for question: RefCounted in _questions:
			_solver.call(question)
		times += 1
		spent = Time.get_ticks_usec() - start
	keep_run(spent / (times * _questions.size()))


func _find_error() -> void:
	var hits := 0
	var lost := 0
	for question: RefCounted in _questions:
		var miss: float = _miss.call(question, _solver.call(question))
		if is_nan(miss):
			lost += 1
		else:
			error = maxf(error, miss)
			hits += int(miss <= _HIT)
	note = "%d of %d shots within 1 px" % [hits, _questions.size()]
	if lost > 0:
		error = Measurement.NO_ANSWER
		note += ", none found for %d" % lost
