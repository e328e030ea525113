class_name DotProductFormula
extends RefCounted
## The formula of the lesson on the dot product: its lines, and what each name in them is.
##
## u is the vector whose shadow is looked for, w the one on which it falls, e the unit vector of w.
## `ax` is the field in which the x of a can be typed; `u_x` only shows the x of u.

# The lines that each step adds.
const _LINES: Array[Array] = [
	["{a} = ( {ax} , {ay} )     {b} = ( {bx} , {by} )"],
	["|{w}| = √({w_x}² + {w_y}²) = {w_length}", "{e} = {w} / |{w}| = {e_pair}"],
	[
		"{u} · {w} = {u_x}·{w_x} + {u_y}·{w_y} = {dot}",
		"{u} · {e} = {dot} / {w_length} = {scalar}",
	],
	["{p} = {scalar} {e} = {p_pair}"],
	["{u} − {p} = {rejection}     ({u} − {p}) · {w} = {check}"],
]
# The same for the usual mistake: w is not brought to length 1.
const _WRONG_LINES: Array[Array] = [
	["{a} = ( {ax} , {ay} )     {b} = ( {bx} , {by} )"],
	["|{w}| = √({w_x}² + {w_y}²) = {w_length}"],
	["{u} · {w} = {u_x}·{w_x} + {u_y}·{w_y} = {dot}"],
	["{p} = {scalar} {w} = {p_pair}"],
	["{u} − {p} = {rejection}     ({u} − {p}) · {w} = {check}"],
]

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of all steps up to [param step] with the numbers of [param model].
func show_model(model: DotProductModel, step: int) -> void:
	_put_both_vectors(model)
	_put_shadow(model)
	var lines: PackedStringArray = []
	for added: PackedStringArray in (_LINES if model.normalizes else _WRONG_LINES).slice(
		0, step + 1
	):
		lines.append_array(added)
	_formula.show_lines(lines)


func _put_both_vectors(model: DotProductModel) -> void:
	_formula.put_symbol("a", "a", Palette.Role.A)
	_formula.put_symbol("b", "b", Palette.Role.B)
	_formula.put_number("ax", model.a().x, Palette.Role.A, tr("x of a"))
	_formula.put_number("ay", model.a().y, Palette.Role.A, tr("y of a"))
	_formula.put_number("bx", model.b().x, Palette.Role.B, tr("x of b"))
	_formula.put_number("by", model.b().y, Palette.Role.B, tr("y of b"))
	_formula.put_number("dot", model.dot(), Palette.Role.INK)


func _put_shadow(model: DotProductModel) -> void:
	var role_of_u := Palette.Role.B if model.is_swapped else Palette.Role.A
	var role_of_w := Palette.Role.A if model.is_swapped else Palette.Role.B
	_formula.put_symbol("u", DotProductTexts.shadowed_symbol(model), role_of_u)
	_formula.put_symbol("w", DotProductTexts.onto_symbol(model), role_of_w)
	_formula.put_symbol("e", DotProductTexts.unit_symbol(model), Palette.Role.UNIT)
	_formula.put_symbol("p", "p", Palette.Role.PROJECTION)
	_formula.put_number("u_x", model.shadowed().x, role_of_u)
	_formula.put_number("u_y", model.shadowed().y, role_of_u)
	_formula.put_number("w_x", model.onto().x, role_of_w)
	_formula.put_number("w_y", model.onto().y, role_of_w)
	_formula.put_number("w_length", model.onto().length(), role_of_w)
	_formula.put_number("scalar", model.scalar_projection(), Palette.Role.PROJECTION)
	_formula.put_number("check", model.rejection().dot(model.onto()), Palette.Role.REST)
	_formula.put_vector("e_pair", model.unit(), Palette.Role.UNIT)
	_formula.put_vector("p_pair", model.vector_projection(), Palette.Role.PROJECTION)
	_formula.put_vector("rejection", model.rejection(), Palette.Role.REST)
