class_name DotProductReadout
extends RefCounted
## The table of the lesson on the dot product: the scalar projection by the dot product and by
## angles, with error and run time.

var _readout: Readout


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout
	_readout.is_the_point = true


## Fills the table for [param model] at [param step] of [DotProductTexts].
func show_model(model: DotProductModel, step: int) -> void:
	_readout.visible = step == DotProductTexts.Step.PRIMITIVE and model.onto().length() > 0.0
	if not _readout.visible:
		return
	var shadowed := model.shadowed()
	var onto := model.onto()
	var title := LabText.translate("%s by the dot product") % _product(model)
	var by_dot := shadowed.scalar_projection if model.normalizes else shadowed.dot
	_show_call("dot", title, by_dot.bind(onto), model)
	var primitive := PrimitiveProjection.scalar.bind(shadowed, onto)
	_show_call("primitive", LabText.translate("by atan2 and cos"), primitive, model)


# What is computed: `a · b̂`, or `a · b` with the usual mistake.
func _product(model: DotProductModel) -> String:
	var second := DotProductTexts.onto_symbol(model)
	if model.normalizes:
		second = DotProductTexts.unit_symbol(model)
	return "%s · %s" % [DotProductTexts.shadowed_symbol(model), second]


func _show_call(key: String, title: String, method: Callable, model: DotProductModel) -> void:
	var value: float = method.call()
	var error := ExactProjection.error_of_scalar_projection(value, model.shadowed(), model.onto())
	_readout.show_result(key, title, value, error, CallTimer.nanoseconds(method))
