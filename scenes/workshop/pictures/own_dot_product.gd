class_name OwnDotProduct
extends OwnPicture
## The dot product and the length of the shadow as numbers beside the shadow, and the shadow.


func questions(state: Dictionary) -> Array[OwnQuestion]:
	var model := DotProductModel.new()
	model.from_dictionary(state)
	var tail := model.foot(model.shadowed_tail())
	var head := model.foot(model.shadowed_head())
	var note := func(_answer: PackedFloat64Array) -> OwnMark: return OwnMark.note(head)
	var shadow := func(answer: PackedFloat64Array) -> OwnMark:
		return OwnMark.arrow(tail, tail.plus(vector(answer)))
	var both := pair(model.shadowed()) + pair(model.onto())
	var names := [DotProductTexts.shadowed_symbol(model), DotProductTexts.unit_symbol(model)]
	return [
		OwnQuestion.new("vector_projection", both, "p", head, shadow),
		OwnQuestion.new("scalar_projection", both, "%s·%s" % names, head, note),
		OwnQuestion.new("dot", pair(model.a()) + pair(model.b()), "a·b", head, note),
	]
