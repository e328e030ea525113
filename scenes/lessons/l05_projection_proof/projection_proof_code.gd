class_name ProjectionProofCode
extends RefCounted
## The lines of GDScript that compute what each step of the proof shows.

const _BETA := "var beta := b.angle_%s()"
const _TURN := "a.rotate_%s(-beta)"


## The lines of [param step] of [ProjectionProofTexts]; none for a zero b, which has no direction.
static func lines(model: ProjectionProofModel, step: int) -> PackedStringArray:
	if not model.has_direction():
		return []
	var unit := "radians" if Conventions.uses_radians() else "degrees"
	var beta := _BETA % unit
	var turn := _TURN % unit
	match step:
		ProjectionProofTexts.Step.WANTED:
			return [beta]
		ProjectionProofTexts.Step.TURN:
			return [beta, turn]
		ProjectionProofTexts.Step.READ_OFF:
			return [beta, turn, "var length_of_p := a.x"]
		ProjectionProofTexts.Step.EXPAND:
			return [
				"var beta := b.angle_radians()",
				"var length_of_p := a.x * cos(beta) + a.y * sin(beta)",
			]
		ProjectionProofTexts.Step.TRIANGLE:
			return ["var cosine := b.x / b.length()", "var sine := b.y / b.length()"]
		ProjectionProofTexts.Step.PUT_IN:
			return ["var unit_b := b.normalized()", "var length_of_p := a.dot(unit_b)"]
	return [
		"var length_of_p := a.dot(b.normalized())",
		"a.rotate_radians(-b.angle_radians())",
		"var difference := a.x - length_of_p",
	]


## The values of the names in the lines.
static func inputs(model: ProjectionProofModel) -> Dictionary[String, Variant]:
	return {"a": model.a, "b": model.b}
