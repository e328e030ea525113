class_name AngledLinesProblem
extends ReportProblem
## The third problem: one ball among angled lines, until it is a pixel off the exact path.

# The numbers of steps in a second.
const _RATES: PackedInt32Array = [60, 240, 960]
const _QUICK_RATES: PackedInt32Array = [60, 240]


func _init() -> void:
	id = "angled_lines"
	champion = BallInBoxProblem.EVENT_WORLD
	title = "One ball among angled lines"
	question = (
		"Each bounce off lines and their ends multiplies an error. For how many bounces does a method"
		+ " follow the exact path (106 bits) to 1 px? The error is 1 over that number."
	)
	error_axis = "1 / bounces until 1 px off"


## See [method ReportProblem.cases].
func cases(is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	var shot := LinesShot.new()
	for rate in rates(is_quick):
		found.append(EventFlight.new(EventFlight.Form.GRID, champion, shot, rate))
		for way in SteppedFlight.METHODS:
			found.append(SteppedFlight.new(way, shot, rate))
	return found


## The numbers of steps in a second that are measured.
static func rates(is_quick: bool) -> PackedInt32Array:
	return _QUICK_RATES if is_quick else _RATES
