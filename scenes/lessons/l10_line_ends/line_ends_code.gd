class_name LineEndsCode
extends RefCounted
## The lines of GDScript beside the formula of the lesson on line ends: what each step computes.

## The lines; none where there is nothing to compute.
var lines: PackedStringArray = []
## The values of the names in the lines.
var inputs: Dictionary[String, Variant] = {}

var _model: LineEndsModel


## The code for [param model] at the step [param step].
func _init(model: LineEndsModel, step: int) -> void:
	_model = model
	inputs = {
		"P": model.start,
		"v": model.motion,
		"r": model.radius,
		"A": model.segment.start,
		"B": model.segment.end,
	}
	if step < LineEndsTexts.Step.CAP:
		_tell_line(step)
	else:
		_tell_cap(step)


# The normal is turned to the ball's side from the second step on.
func _tell_line(step: int) -> void:
	if step == LineEndsTexts.Step.ONE_SIDE:
		lines = [
			"var unit_normal := B.minus(A).normal()",
			"var signed_distance := P.minus(A).dot(unit_normal)",
		]
		return
	inputs["unit_normal"] = _model.facing_normal()
	var distance := absf(LineDistance.signed_distance(_model.start, _model.segment))
	var approach := -_model.motion.dot(_model.facing_normal())
	if step == LineEndsTexts.Step.TWO_SIDES:
		lines.append("var distance := P.minus(A).dot(unit_normal)")
		if approach > 0.0:
			lines.append("var t := (distance - r) / -v.dot(unit_normal)")
	elif approach > 0.0:
		inputs["t"] = maxf((distance - _model.radius) / approach, 0.0)
		lines = [
			"var F := P.plus(v.scaled(t))",
			"var s := F.minus(A).dot(B.minus(A)) / B.minus(A).length_squared()",
		]


func _tell_cap(step: int) -> void:
	var equation := _model.cap_equation()
	var end := LineEndsTexts.end_name(_model)
	inputs["d"] = equation.difference
	match step:
		LineEndsTexts.Step.CAP:
			lines = ["var d := P.minus(%s)" % end, "var distance := d.length()"]
		LineEndsTexts.Step.QUADRATIC:
			lines = ["var a := v.dot(v)", "var b := 2.0 * d.dot(v)", "var c := d.dot(d) - r * r"]
		LineEndsTexts.Step.ROOTS:
			_tell_roots(equation)
		LineEndsTexts.Step.BOUNCE:
			_tell_bounce(end)


func _tell_roots(equation: CapEquation) -> void:
	inputs["a"] = equation.a
	inputs["b"] = equation.b
	inputs["c"] = equation.c
	lines = ["var D := b * b - 4.0 * a * c"]
	if equation.has_roots():
		lines.append("var t1 := (-b - sqrt(D)) / (2.0 * a)")
		lines.append("var t2 := (-b + sqrt(D)) / (2.0 * a)")


# With its centre on the end, the ball has no normal.
func _tell_bounce(end: String) -> void:
	var impact := _model.impact_in(LineEndsModel.Field.ROUND_CAPS)
	if not _model.bounces_on_the_end():
		return
	var touch := _model.start.plus(_model.motion.scaled(impact.fraction))
	if touch.distance_to(_model.cap_point()) == 0.0:
		return
	inputs["t1"] = impact.fraction
	lines = [
		"var unit_normal := P.plus(v.scaled(t1)).minus(%s).normalized()" % end,
		"var after := v.reflected(unit_normal)",
	]
	if impact.fraction == 0.0:
		lines[0] = "var unit_normal := d.normalized()"
