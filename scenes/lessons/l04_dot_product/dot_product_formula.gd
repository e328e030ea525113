class_name DotProductFormula
extends RefCounted
## Puts the numbers of the lesson on the dot product into its formula lines.

var _formula: Formula


## Says to [param formula] what the names in [DotProductTexts] stand for.
func _init(formula: Formula) -> void:
	_formula = formula
	_formula.define_symbol("a", "a", Palette.Role.A)
	_formula.define_symbol("b", "b", Palette.Role.B)
	_formula.define_symbol("p", "p", Palette.Role.PROJECTION)
	_formula.define_number("ax", Palette.Role.A, tr("x of a"))
	_formula.define_number("ay", Palette.Role.A, tr("y of a"))
	_formula.define_number("bx", Palette.Role.B, tr("x of b"))
	_formula.define_number("by", Palette.Role.B, tr("y of b"))
	_formula.define_number("e_pair", Palette.Role.UNIT)
	_formula.define_number("dot", Palette.Role.INK)
	_formula.define_number("scalar", Palette.Role.PROJECTION)
	_formula.define_number("p_pair", Palette.Role.PROJECTION)
	_formula.define_number("rest_pair", Palette.Role.REST)
	_formula.define_number("check", Palette.Role.REST)


## Shows the lines of all steps up to [param step] with the numbers of [param model].
func show_model(model: DotProductModel, step: int) -> void:
	_name_vectors(model)
	_formula.show_lines(DotProductTexts.lines(model, step))
	_put_vectors(model.a(), model.b(), model.shadowed(), model.onto())
	_formula.set_number("dot", model.dot())
	_formula.set_number("scalar", model.scalar_projection())
	_formula.set_vector("e_pair", model.unit())
	_formula.set_vector("p_pair", model.vector_projection())
	_formula.set_vector("rest_pair", model.rest())
	_formula.set_number("check", model.rest().dot(model.onto()))


# u is the vector whose shadow is looked for, w the one on which it falls, e the unit vector of w.
func _name_vectors(model: DotProductModel) -> void:
	var role_of_u := Palette.Role.B if model.is_swapped else Palette.Role.A
	var role_of_w := Palette.Role.A if model.is_swapped else Palette.Role.B
	_formula.define_symbol("u", DotProductTexts.shadowed_symbol(model), role_of_u)
	_formula.define_symbol("w", DotProductTexts.onto_symbol(model), role_of_w)
	_formula.define_symbol("e", DotProductTexts.unit_symbol(model), Palette.Role.UNIT)
	_formula.define_number("u_x", role_of_u)
	_formula.define_number("u_y", role_of_u)
	_formula.define_number("w_x", role_of_w)
	_formula.define_number("w_y", role_of_w)
	_formula.define_number("w_length", role_of_w)


func _put_vectors(a: Vec2, b: Vec2, shadowed: Vec2, onto: Vec2) -> void:
	_formula.set_number("ax", a.x)
	_formula.set_number("ay", a.y)
	_formula.set_number("bx", b.x)
	_formula.set_number("by", b.y)
	_formula.set_number("u_x", shadowed.x)
	_formula.set_number("u_y", shadowed.y)
	_formula.set_number("w_x", onto.x)
	_formula.set_number("w_y", onto.y)
	_formula.set_number("w_length", onto.length())
