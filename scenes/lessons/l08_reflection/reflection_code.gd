class_name ReflectionCode
extends RefCounted
## The lines of GDScript that compute what each step of the lesson on reflection shows.

const _NORMAL := "var unit_normal := along.normal()"


## The lines of [param step]; none for a normal that [method Vec2.reflect] refuses.
static func lines(model: ReflectionModel, step: ReflectionModel.Step) -> PackedStringArray:
	if model.refusal():
		return []
	match step:
		ReflectionModel.Step.MEET:
			return [_NORMAL]
		ReflectionModel.Step.SPLIT:
			return [
				_NORMAL,
				"var dot := v.dot(unit_normal)",
				"var part := unit_normal.scaled(dot)",
			]
		ReflectionModel.Step.SLIDE:
			return [_NORMAL, "v.reflect(unit_normal, 0.0)"]
		ReflectionModel.Step.MIRROR:
			return [_NORMAL, "v.reflect(unit_normal)"]
		ReflectionModel.Step.BOUNCE:
			return [_NORMAL, "v.reflect(unit_normal, bounciness)"]
	# On the side from which the ball came.
	var facing := "along.normal()" if model.faces_ball() else "along.normal().negated()"
	return [
		"var unit_normal := " + facing,
		"var dot := v_out.dot(unit_normal)",
		"if dot < 0.0: v_out.reflect(unit_normal, bounciness)",
	]


## The values of the names in the lines.
static func inputs(model: ReflectionModel) -> Dictionary[String, Variant]:
	return {
		"v": model.velocity,
		"v_out": model.velocity_out(),
		"along": model.along,
		"bounciness": model.bounciness,
	}
