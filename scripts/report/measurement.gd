class_name Measurement
extends RefCounted
## One row of the report: how long a method took, and how wrong it was.

## Stands in [member error] where a method gave no answer at all: it blew up, or lost its ball. The
## row then says so in [member note]; tables leave the cell empty and pictures leave the point out.
const NO_ANSWER := INF

## The id of its problem, such as ball_in_box.
var problem := ""
## How it was done, such as event world.
var method := ""
## What was asked. Only measurements of the same situation can be compared.
var situation := ""
## What the method was set to, such as 240 steps a second; "" where there is nothing to set.
var tuning := ""
## [member situation] and [member tuning] in one text.
var setting: String:
	get:
		return setting_of(situation, tuning)
## Whether this is the engine's own, or another library: what the lab is compared with.
var is_peer := false
## Microseconds per simulated second, or per call where the problem says so: the median of the runs.
var run_time_us := 0.0
## A quarter of the runs took at most this long, in the unit of [member run_time_us]; NAN where only
## the median is known.
var lower_quartile_us := NAN
## A quarter of the runs took at least this long; NAN where only the median is known.
var upper_quartile_us := NAN
## How far from the exact answer, 0 or more in [member error_unit]; or [constant NO_ANSWER].
var error := 0.0
## What the error is counted in, such as px.
var error_unit := "px"
## What else is to be said: a sentence or two, without line breaks.
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


## The methods that were measured, each once: the lab's own first.
static func methods_in(measurements: Array[Measurement]) -> PackedStringArray:
	var found: PackedStringArray = []
	for peers: bool in [false, true]:
		for measurement in measurements:
			if measurement.is_peer == peers and not found.has(measurement.method):
				found.append(measurement.method)
	return found
