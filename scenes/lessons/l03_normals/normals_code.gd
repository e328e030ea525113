class_name NormalsCode
## The lines of GDScript that compute what the formula of the lesson on normals shows.

const _LINES: Dictionary[NormalsTexts.Step, Array] = {
	NormalsTexts.Step.VECTOR: ["var v := end.minus(start)"],
	NormalsTexts.Step.NORMAL: ["var n := Vec2.new(-v.y, v.x)", "var check := v.dot(n)"],
	NormalsTexts.Step.OPPOSITE: ["var opposite := Vec2.new(v.y, -v.x)"],
	NormalsTexts.Step.UNIT: ["var unit_v := v.normalized()", "var unit_normal := v.normal()"],
	NormalsTexts.Step.SCALED:
	["var unit_normal := v.normal()", "var drawn := unit_normal.scaled(times)"],
}


## The lines at [param step] for [param model]; none for the normals of a zero v, and none where a
## mistake does not show.
static func lines(model: NormalsModel, step: NormalsTexts.Step) -> PackedStringArray:
	if model.mistake == NormalsMistakes.WRONG_NORMAL and model.has_direction():
		return ["var wrong := Vec2.new(v.y, v.x)", "var check := v.dot(wrong)"]
	if model.mistake == NormalsMistakes.CUT_LENGTH and model.is_mistaken():
		return ["var length := v.length()", "var cut := int(length)"]
	if model.mistake != 0 or step != NormalsTexts.Step.VECTOR and not model.has_direction():
		return []
	return PackedStringArray(_LINES[step])


## What the names in [method lines] stand for.
static func inputs(model: NormalsModel) -> Dictionary[String, Variant]:
	return {v = model.v(), start = model.start, end = model.end, times = model.times}
