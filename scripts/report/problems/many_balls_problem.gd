class_name ManyBallsProblem
extends ReportProblem
## The sixth problem: many elastic balls.

## The numbers of balls, each with its simulated time in seconds.
const SECONDS: Dictionary[int, float] = {2: 10.0, 10: 10.0, 100: 5.0, 1000: 4.0}
## The same for the quick form.
const QUICK_SECONDS: Dictionary[int, float] = {2: 10.0, 10: 5.0, 100: 1.0, 1000: 0.25}


func _init() -> void:
	id = "many_balls"
	champion = EventCrowd.METHOD
	title = "Many elastic balls"
	question = (
		"Balls of 10 px radius at 100 to 300 px/s cover a tenth of a square box; no gravity, C = 1."
		+ " The error is the deepest overlap of two balls (0: none), measured 10 times a second. The"
		+ " notes give the drift of the energy, and for how long a reversed run retraces its path."
	)
	error_axis = "worst overlap of two balls, px"


## See [method ReportProblem.cases].
func cases(is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for crowd in crowds(is_quick):
		for rate: int in [60, 240]:
			found.append(EventCrowd.new(crowd, rate))
	return found


## The crowds that are measured.
static func crowds(is_quick: bool) -> Array[Crowd]:
	var seconds := QUICK_SECONDS if is_quick else SECONDS
	var found: Array[Crowd] = []
	for count in seconds:
		found.append(Crowd.new(count, seconds[count]))
	return found


## See [method ReportProblem.remarks]: the figures of the notes as a table.
func remarks(rows: Array[Measurement]) -> String:
	var lines: PackedStringArray = ["| method | balls | | note |", "|---|---|---|---|"]
	for row in rows:
		lines.append("| %s | %s | %s | %s |" % [row.method, row.situation, row.tuning, row.note])
	return "\n".join(lines)
