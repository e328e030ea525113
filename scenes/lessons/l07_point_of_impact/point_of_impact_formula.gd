class_name PointOfImpactFormula
extends RefCounted
## The formula of the lesson on the point of impact: its lines, and what each name in them is.

const _WAYS := (
	"{a_symbol} = {old_distance} − {r_value} = {a}     "
	+ "{b_symbol} = {old_distance} − {new_distance} = {b}"
)
# What each mistake takes for t.
const _WRONG_TERMS: Dictionary[int, String] = {
	PointOfImpactMistakes.OVER_NEW: "{a} / {new_distance} = {wrong_t}",
	PointOfImpactMistakes.UNSIGNED:
	"(|{old_distance}| − {r_value}) / (|{old_distance}| − |{new_distance}|) = {wrong_t}",
	PointOfImpactMistakes.NOT_LIMITED: "{a} / {b} = {wrong_t}",
	PointOfImpactMistakes.FROM_NEW: "({new_distance} − {r_value}) / {b} = {wrong_t}",
}

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of all steps up to [param step] with the numbers of [param model].
func show_model(model: PointOfImpactModel, step: int) -> void:
	_put_symbols()
	_put_what_is_typed(model)
	_put_distances(model)
	_put_places(model)
	_formula.show_lines(_lines(model, step))


func _lines(model: PointOfImpactModel, step: int) -> PackedStringArray:
	var found: PackedStringArray = [
		"old ( {old_x} , {old_y} )     new ( {new_x} , {new_y} )",
		tr("line: ( {sx} , {sy} ) to ( {ex} , {ey} )   r = {r}"),
	]
	if PointOfImpactTexts.is_compared(model, step):
		# The wrong t beside the right one replaces motion, reset and POI.
		return found + PackedStringArray([_WAYS, _line_of_t(model), _line_of_wrong_t(model)])
	found.append("v = new − old = {v_pair}     |v| = {speed}")
	if step in [PointOfImpactTexts.Step.RESET, PointOfImpactTexts.Step.IMPACT]:
		found.append(_line_of_reset(model))
	if step == PointOfImpactTexts.Step.DISTANCES:
		found.append(tr("old distance = {old_distance}     new distance = {new_distance}"))
	var added: PackedStringArray = [_WAYS, _line_of_t(model), _line_of_impact(model)]
	return found + added.slice(0, maxi(step - PointOfImpactTexts.Step.DISTANCES, 0))


func _line_of_reset(model: PointOfImpactModel) -> String:
	if model.is_reset():
		return "{reset} = new + ({r_value} − {new_distance}) {n} = {reset_pair}"
	return "{reset}: " + tr("not needed")


func _line_of_t(model: PointOfImpactModel) -> String:
	if model.way_of_frame() == 0.0:
		return "t: " + tr("none, b is 0")
	return "t = {a_symbol} / {b_symbol} = {a} / {b} = {t}"


func _line_of_wrong_t(model: PointOfImpactModel) -> String:
	if is_finite(model.fraction_with_mistake()):
		return "{wrong}: " + _WRONG_TERMS[model.mistake]
	return "{wrong}: " + tr("divides by 0")


# A contact before the frame is one at its start.
func _line_of_impact(model: PointOfImpactModel) -> String:
	match model.frame_case():
		PointOfImpactModel.Case.IN_FRAME:
			return "{poi} = old + t v = {poi_pair}"
		PointOfImpactModel.Case.OVERLAPS_FROM_START:
			return "{poi} = old + 0 v = {poi_pair}"
	return "{poi}: " + tr("none")


func _put_symbols() -> void:
	_formula.put_symbol("a_symbol", "a", Palette.Role.A)
	_formula.put_symbol("b_symbol", "b", Palette.Role.B)
	_formula.put_symbol("n", "n̂", Palette.Role.UNIT)
	_formula.put_symbol("poi", "POI", Palette.Role.PROJECTION)
	_formula.put_symbol("reset", tr("reset"), Palette.Role.REST)
	_formula.put_symbol("wrong", tr("wrong"), Palette.Role.WRONG)


# Each of these has its counterpart in PointOfImpactModel.enter.
func _put_what_is_typed(model: PointOfImpactModel) -> void:
	var ink := Palette.Role.INK
	_formula.put_number("old_x", model.old_position.x, ink, tr("x of the old position"))
	_formula.put_number("old_y", model.old_position.y, ink, tr("y of the old position"))
	_formula.put_number("new_x", model.new_position.x, ink, tr("x of the new position"))
	_formula.put_number("new_y", model.new_position.y, ink, tr("y of the new position"))
	_formula.put_number("sx", model.line.start.x, ink, tr("x of the line's start"))
	_formula.put_number("sy", model.line.start.y, ink, tr("y of the line's start"))
	_formula.put_number("ex", model.line.end.x, ink, tr("x of the line's end"))
	_formula.put_number("ey", model.line.end.y, ink, tr("y of the line's end"))
	_formula.put_number("r", model.radius, ink, tr("radius of the ball"))
	_formula.put_number("speed", model.motion().length(), ink, tr("speed in pixels per frame"))


func _put_distances(model: PointOfImpactModel) -> void:
	# Distances are differences of places: what rounding leaves of them grows with those.
	var scale := 4.0 * (model.line.start.length() + model.radius)
	scale += 4.0 * (model.old_position.length() + model.new_position.length())
	_formula.put_sum("old_distance", model.old_distance(), scale, Palette.Role.INK)
	_formula.put_sum("new_distance", model.new_distance(), scale, Palette.Role.INK)
	_formula.put_number("r_value", model.radius, Palette.Role.INK)
	_formula.put_sum("a", model.way_to_contact(), scale, Palette.Role.A)
	_formula.put_sum("b", model.way_of_frame(), scale, Palette.Role.B)
	_formula.put_sum("t", model.fraction(), scale / absf(model.way_of_frame()), Palette.Role.INK)
	_formula.put_number("wrong_t", model.fraction_with_mistake(), Palette.Role.WRONG)


func _put_places(model: PointOfImpactModel) -> void:
	_formula.put_vector("v_pair", model.motion(), Palette.Role.INK)
	_formula.put_vector("reset_pair", model.reset_position(), Palette.Role.REST)
	if model.touches():
		_formula.put_vector("poi_pair", model.impact_position(), Palette.Role.PROJECTION)
