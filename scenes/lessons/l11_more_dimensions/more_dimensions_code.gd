class_name MoreDimensionsCode
extends RefCounted
## The lines of GDScript beside the formula of the lesson on more dimensions.

## The lines; none where nothing is computed yet.
var lines: PackedStringArray = []
## The values of the names in the lines.
var inputs: Dictionary[String, Variant] = {}


## The code for [param model] at the step [param step].
func _init(model: MoreDimensionsModel, step: int) -> void:
	inputs = {"a": model.counted_a(), "b": model.counted_b(), "ComponentLists": ComponentLists}
	if step == MoreDimensionsTexts.Step.PRODUCTS:
		for i in model.dimension():
			lines.append("var p%d := a[%d] * b[%d]" % [i + 1, i, i])
	elif step > MoreDimensionsTexts.Step.PRODUCTS:
		lines.append("var dot := ComponentLists.dot(a, b)")
	if step >= MoreDimensionsTexts.Step.ANGLE and model.has_angle():
		lines.append("var length_a := ComponentLists.length(a)")
		lines.append("var length_b := ComponentLists.length(b)")
		lines.append("var cosine := dot / (length_a * length_b)")
