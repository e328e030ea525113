class_name Measurement
extends RefCounted
## One row of the report: how long a method took, and how wrong it was.

## The [member error] of a method that gave no answer: it blew up, lost its ball, or its world
## refused to go on. [member note] then says which. Tables leave the cell empty; pictures have a row
## of their own for it.
const NO_ANSWER := INF

## The id of its problem, such as ball_in_box.
var problem := ""
## The name of the method, such as event world.
var method := ""
## The situation of the problem. Only measurements of the same situation can be compared.
var situation := ""
## The setting of the method, such as 240 steps a second; "" if it has none.
var tuning := ""
## [member situation] and [member tuning] in one text.
var setting: String:
	get:
		return setting_of(situation, tuning)
## Whether this is a method that the lab's own are compared with: the engine's, or a library's.
var is_baseline := false
## Microseconds per simulated second, or per call where the problem says so: the median of the runs.
## [constant NO_ANSWER] where a world refused to go on; tables leave the cell empty.
var run_time_us := 0.0
## A quarter of the runs took at most this long, in the unit of [member run_time_us]; NAN where only
## the median is known.
var lower_quartile_us := NAN
## A quarter of the runs took at least this long; NAN where only the median is known.
var upper_quartile_us := NAN
## The distance from the exact answer, 0 or more in [member error_unit]; or [constant NO_ANSWER].
var error := 0.0
## The unit of [member error], such as px.
var error_unit := "px"
## Further remarks: a sentence or two, without line breaks.
var note := ""
## Further figures by name, such as the drift of the energy; all finite.
var figures: Dictionary[String, float] = {}


## Whether [member error] is a number that can be compared.
func has_answer() -> bool:
	return is_finite(error)


## A situation and a tuning in one text.
static func setting_of(of_situation: String, with_tuning: String) -> String:
	return of_situation if with_tuning == "" else of_situation + ", " + with_tuning


## The measurements of one problem.
static func of_problem(id: String, measurements: Array[Measurement]) -> Array[Measurement]:
	return measurements.filter(func(row: Measurement) -> bool: return row.problem == id)


## The names of the methods that were measured, each once: the lab's own first.
static func methods_in(measurements: Array[Measurement]) -> PackedStringArray:
	var found: PackedStringArray = []
	for baselines: bool in [false, true]:
		for measurement in measurements:
			if measurement.is_baseline == baselines and not found.has(measurement.method):
				found.append(measurement.method)
	return found
