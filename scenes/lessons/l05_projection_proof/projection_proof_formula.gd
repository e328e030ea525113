class_name ProjectionProofFormula
extends RefCounted
## The formula of the proof: its lines, and what each name in them is.
##
## e is the unit vector along b.

## A component smaller than this share of its vector is rounding, and shown as 0; the readout tells
## how large it is.
const _ROUNDING := 1.0 / 2.0 ** 48

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Puts in the numbers of [param model] that stay during the turn; then call [method show_turn].
func show_model(model: ProjectionProofModel) -> void:
	_put_both_vectors(model)
	_put_angle(model)
	_formula.put_symbol("p", "p", Palette.Role.PROJECTION)
	var scale := model.a.length()
	_formula.put_sum("scalar", model.dot_with_unit(), scale, Palette.Role.PROJECTION)
	var difference := model.x_of_turned_a() - model.dot_with_unit()
	_formula.put_sum("difference", difference, scale, Palette.Role.INK)


## Puts in the numbers that change during the turn, and shows the lines of [param step].
func show_turn(model: ProjectionProofModel, step: int) -> void:
	var a := _without_rounding(model.turned(model.a))
	var b := _without_rounding(model.turned(model.b))
	_formula.put_symbol("a_turned", "a′", Palette.Role.A)
	_formula.put_symbol("b_turned", "b′", Palette.Role.B)
	_formula.put_vector("a_turned_pair", a, Palette.Role.A)
	_formula.put_vector("b_turned_pair", b, Palette.Role.B)
	_formula.show_lines(_lines(model, step))


# The lines on the angle go when the angle is no longer needed.
func _lines(model: ProjectionProofModel, step: int) -> PackedStringArray:
	var found: PackedStringArray = ["{a} = ( {ax} , {ay} )     {b} = ( {bx} , {by} )"]
	if not model.has_direction():
		return found
	if step < ProjectionProofTexts.Step.TRIANGLE:
		var is_added := Conventions.has_full_turn() and model.beta() < 0.0
		var turn := " + 360°" if is_added else ""
		found.append("β = atan2({b_y}, {b_x})%s = {beta}°" % turn)
	if step >= ProjectionProofTexts.Step.TURN and step <= ProjectionProofTexts.Step.EXPAND:
		found.append(_turned_line(model))
	if step >= ProjectionProofTexts.Step.READ_OFF:
		found.append(tr("signed length of {p} = {a_turned}.x = {scalar}"))
	if step == ProjectionProofTexts.Step.EXPAND:
		found.append("{a_turned}.x = {a_x}·cos(−β) − {a_y}·sin(−β)")
		found.append("cos(−β) = cos β     sin(−β) = −sin β")
	if step >= ProjectionProofTexts.Step.EXPAND:
		found.append("{a_turned}.x = {a_x}·cos β + {a_y}·sin β")
	if step >= ProjectionProofTexts.Step.TRIANGLE:
		found.append("cos β = {b}x / |{b}| = {b_x} / {b_length} = {cosine_value}")
		found.append("sin β = {b}y / |{b}| = {b_y} / {b_length} = {sine_value}")
	if step >= ProjectionProofTexts.Step.PUT_IN:
		found.append("{a_turned}.x = {a_x}·{cosine} + {a_y}·{sine} = {scalar}")
		found.append("{a} · {e} = ({a_x}·{b_x} + {a_y}·{b_y}) / {b_length} = {scalar}")
	if step >= ProjectionProofTexts.Step.COMPARE:
		found.append("{a_turned}.x − {a} · {e} = {difference}")
	return found


# The vectors are called a′ and b′ only at the end of the turn.
func _turned_line(model: ProjectionProofModel) -> String:
	if model.turned_share == 1.0:
		return "{a_turned} = {a_turned_pair}     {b_turned} = {b_turned_pair}"
	return tr("on the way: {a_turned_pair}     {b_turned_pair}")


func _put_both_vectors(model: ProjectionProofModel) -> void:
	_formula.put_symbol("a", "a", Palette.Role.A)
	_formula.put_number("ax", model.a.x, Palette.Role.A, tr("x of a"))
	_formula.put_number("ay", model.a.y, Palette.Role.A, tr("y of a"))
	_formula.put_number("a_x", model.a.x, Palette.Role.A)
	_formula.put_number("a_y", model.a.y, Palette.Role.A)
	_formula.put_symbol("b", "b", Palette.Role.B)
	_formula.put_number("bx", model.b.x, Palette.Role.B, tr("x of b"))
	_formula.put_number("by", model.b.y, Palette.Role.B, tr("y of b"))
	_formula.put_number("b_x", model.b.x, Palette.Role.B)
	_formula.put_number("b_y", model.b.y, Palette.Role.B)
	_formula.put_number("b_length", model.b.length(), Palette.Role.B)


func _put_angle(model: ProjectionProofModel) -> void:
	var beta := Conventions.in_range(Vec2.rad_to_deg(model.beta()))
	_formula.put_angle("beta", beta, Palette.Role.INK)
	_formula.put_symbol("e", ProjectionProofTexts.UNIT, Palette.Role.UNIT)
	_formula.put_number("cosine", model.cosine(), Palette.Role.UNIT)
	_formula.put_number("sine", model.sine(), Palette.Role.UNIT)
	_formula.put_number("cosine_value", model.cosine(), Palette.Role.UNIT)
	_formula.put_number("sine_value", model.sine(), Palette.Role.UNIT)


static func _without_rounding(vector: Vec2) -> Vec2:
	var least := vector.length() * _ROUNDING
	var across := vector.x if absf(vector.x) > least else 0.0
	return Vec2.new(across, vector.y if absf(vector.y) > least else 0.0)
