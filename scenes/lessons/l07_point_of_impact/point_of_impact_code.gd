class_name PointOfImpactCode
extends RefCounted
## The lines of GDScript that compute what each step of the lesson on the point of impact shows.

const _LINES_OF_FRACTION: PackedStringArray = [
	"var t := (old_distance - radius) / (old_distance - new_distance)"
]


## The lines of [param step] of [PointOfImpactTexts]; none where there is nothing to compute.
static func lines(model: PointOfImpactModel, step: int) -> PackedStringArray:
	match step:
		PointOfImpactTexts.Step.MOTION:
			return ["var v := new_position.minus(old_position)"]
		PointOfImpactTexts.Step.RESET:
			return _lines_of_reset(model)
		PointOfImpactTexts.Step.DISTANCES:
			return [
				"var old_distance := LineDistance.signed_distance(old_position, line)",
				"var new_distance := LineDistance.signed_distance(new_position, line)",
			]
		PointOfImpactTexts.Step.WAYS:
			return ["var a := old_distance - radius", "var b := old_distance - new_distance"]
		PointOfImpactTexts.Step.FRACTION:
			return _LINES_OF_FRACTION if model.way_of_frame() != 0.0 else PackedStringArray()
	return ["var poi := old_position.plus(v.scaled(t))"] if model.touches() else []


static func _lines_of_reset(model: PointOfImpactModel) -> PackedStringArray:
	var found: PackedStringArray = [
		"var gap := LineDistance.signed_distance(new_position, line) - radius"
	]
	if model.is_reset():
		found.append("new_position.subtract(line.normal().scaled(gap))")
	return found


## The values of the names in the lines of [param step].
static func inputs(model: PointOfImpactModel, step: int) -> Dictionary[String, Variant]:
	var found: Dictionary[String, Variant] = {
		"LineDistance": LineDistance,
		"line": model.line,
		"radius": model.radius,
		"old_position": model.old_position,
		"new_position": model.new_position,
	}
	if step in [PointOfImpactTexts.Step.WAYS, PointOfImpactTexts.Step.FRACTION]:
		found["old_distance"] = model.old_distance()
		found["new_distance"] = model.new_distance()
	if step == PointOfImpactTexts.Step.IMPACT and model.touches():
		found["v"] = model.motion()
		found["t"] = clampf(model.fraction(), 0.0, 1.0)
	return found
