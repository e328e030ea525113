class_name AngledLinesCode
extends RefCounted
## The lines of GDScript beside the formula of the lesson on angled lines: the bounce that it shows,
## else, with endless lines, what the lecture does with each line in each frame.

const _BOUNCE: PackedStringArray = ["var v2 := v1.reflected(unit_normal, C)"]
const _FRAME: PackedStringArray = [
	"var gap := LineDistance.gap(ball, line)",
	"if gap < 0.0:",
	"	PositionReset.reset(ball, line)",
	"	Bounce.apply(ball.velocity, line.normal(), C)",
]

## The lines; none where nothing is computed.
var lines: PackedStringArray = []
## The values of the names in the lines.
var inputs: Dictionary[String, Variant] = {}


## The code for [param model] with [param bounce], if it is not null.
func _init(model: AngledLinesModel, bounce: BounceRecord) -> void:
	inputs["C"] = model.world.surroundings.bounciness
	if bounce:
		lines = _BOUNCE
		inputs["v1"] = bounce.velocity_before
		inputs["unit_normal"] = bounce.normal
	elif model.has_endless_lines and model.world.surroundings.segments:
		lines = _FRAME
		inputs["ball"] = model.ball()
		inputs["line"] = _line_with_the_smallest_gap(model)
		inputs["LineDistance"] = LineDistance


static func _line_with_the_smallest_gap(model: AngledLinesModel) -> LineSegment:
	var found := model.world.surroundings.segments[0]
	for line in model.world.surroundings.segments:
		if LineDistance.gap(model.ball(), line) < LineDistance.gap(model.ball(), found):
			found = line
	return found
