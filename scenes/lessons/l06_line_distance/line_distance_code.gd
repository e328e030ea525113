class_name LineDistanceCode
extends RefCounted
## The lines of GDScript that compute what each step of the lesson on the distance shows.

const _RED: Dictionary[DiscreteDetection.Rule, String] = {
	DiscreteDetection.Rule.BELOW_RADIUS: "var is_red := distance < ball.radius",
	DiscreteDetection.Rule.ONLY_ABOVE: "var is_red := distance >= 0.0 and distance < ball.radius",
	DiscreteDetection.Rule.BOTH_SIDES: "var is_red := absf(distance) < ball.radius",
}


## The lines of [param step] of [LineDistanceTexts].
static func lines(model: LineDistanceModel, step: int) -> PackedStringArray:
	match step:
		LineDistanceTexts.Step.DIFFERENCE:
			return ["var d := ball.position.minus(p)"]
		LineDistanceTexts.Step.NORMAL:
			return ["var unit_normal := line.normal()"]
		LineDistanceTexts.Step.DISTANCE:
			return ["var d := ball.position.minus(p)", "var distance := d.dot(line.normal())"]
		LineDistanceTexts.Step.GAP:
			return [
				"var distance := LineDistance.signed_distance(ball.position, line)",
				"var gap := distance - ball.radius",
			]
		LineDistanceTexts.Step.SEGMENT:
			return [
				"var nearest := line.closest_point(ball.position)",
				"var distance := ball.position.distance_to(nearest)",
			]
	return ["var distance := LineDistance.signed_distance(ball.position, line)", _RED[model.rule]]


## The values of the names in the lines of [param step]; the ball flies in the last one.
static func inputs(model: LineDistanceModel, step: int) -> Dictionary[String, Variant]:
	var flies := step == LineDistanceTexts.Step.DETECTION
	var ball := Ball.new(model.position_at(model.frame), model.ball.radius)
	return {
		"LineDistance": LineDistance,
		"line": model.line,
		"p": model.from(),
		"ball": ball if flies else model.ball,
	}
