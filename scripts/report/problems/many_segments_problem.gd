class_name ManySegmentsProblem
extends ReportProblem
## The fourth problem: one ball among more and more segments, frame by frame.

## The numbers of segments.
const COUNTS: PackedInt32Array = [4, 64, 1024, 16384]
## The growth exponent is measured from this number of segments to [constant GROWTH_TO].
const GROWTH_FROM := 64
## See [constant GROWTH_FROM].
const GROWTH_TO := 16384
## The event world that examines only the segments near the ball's way.
const GRID := "event world, grid"
## The event world that examines all segments.
const SCAN := "event world, scan"

# Frames in a second.
const _FRAMES := 60.0


func _init() -> void:
	id = "many_segments"
	champion = GRID
	title = "One ball among many segments"
	question = (
		"A ball at 300 px/s among short segments, one per 80 x 80 px, read 60 times a second. The error"
		+ " is its distance from the exact path (106 bits) after 2 s. Setting up is not measured."
	)


## See [method ReportProblem.cases].
func cases(_is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for count in COUNTS:
		var shot := ManySegmentsShot.new(count)
		found.append(EventFlight.new(EventFlight.Form.GRID, GRID, shot, 60))
		var followed := BallInBoxProblem.FOLLOWED
		found.append(FollowedFlight.new(EventFlight.Form.GRID, followed, shot, 60))
		found.append(EventFlight.new(EventFlight.Form.SCAN, SCAN, shot, 60))
	return found


## See [method ReportProblem.remarks]: the run time of a frame, and how it grows.
func remarks(rows: Array[Measurement]) -> String:
	var heads: PackedStringArray = []
	for count in COUNTS:
		heads.append(str(count))
	var lines: PackedStringArray = [
		"| µs a frame | %s | growth exponent |" % " | ".join(heads),
		"|---|" + "---|".repeat(COUNTS.size() + 1),
	]
	for method in Measurement.methods_in(rows):
		var cells: PackedStringArray = [method]
		for count in COUNTS:
			cells.append(FigureText.short(time_of(method, count, rows) / _FRAMES))
		cells.append("%.2f" % growth(method, rows))
		lines.append("| %s |" % " | ".join(cells))
	lines.append(
		(
			"\nThe growth exponent is log(t2 / t1) / log(n2 / n1) from %d to %d segments."
			% [GROWTH_FROM, GROWTH_TO]
		)
	)
	return "\n".join(lines)


## The run time of a method among [param count] segments; NaN if it was not measured.
static func time_of(method: String, count: int, rows: Array[Measurement]) -> float:
	for row in rows:
		if row.method == method and row.situation == ManySegmentsShot.situation_of(count):
			return row.run_time_us
	return NAN


## The growth exponent of a method; NaN if it was not measured.
static func growth(method: String, rows: Array[Measurement]) -> float:
	var times := time_of(method, GROWTH_TO, rows) / time_of(method, GROWTH_FROM, rows)
	return log(times) / log(float(GROWTH_TO) / GROWTH_FROM)
