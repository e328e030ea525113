class_name DotProductFormula
extends RefCounted
## The formula of the lesson on the dot product: its lines, and what each name in them is.
##
## u is the vector whose shadow is looked for, w the one on which it falls, e the unit vector of w.
## `ax` is the field in which the x of a can be typed; `u_x` only shows the x of u.

const _VECTORS: Array[String] = ["{a} = ( {ax} , {ay} )", "{b} = ( {bx} , {by} )"]
const _LENGTH := "|{w}| = √({w_x}² + {w_y}²) = {w_length}"
const _DOT := "{u} · {w} = {u_x}·{w_x} + {u_y}·{w_y} = {dot}"
# The lines that each step adds, up to the one with the rest.
const _LINES: Array[Array] = [
	_VECTORS,
	[_LENGTH, "{e} = {w} / |{w}| = {e_pair}"],
	[_DOT, "{u} · {e} = {dot_used} / {w_length} = {scalar}"],
	["{p} = {scalar} {e} = {p_pair}"],
	["{u} − {p} = {rejection}", "({u} − {p}) · {w} = {check}"],
]
const _MEASURED := "|{p}| = √({p_x}² + {p_y}²) = {p_length}"
# On both shadows, in place of those on one.
const _BOTH_LINES: Array[String] = [
	_DOT,
	_LENGTH,
	"{u} · {e} = {dot_used} / {w_length} = {scalar}",
	"|{u}| = √({u_x}² + {u_y}²) = {u_length}",
	"{w} · {v} = {dot_used} / {u_length} = {other_scalar}",
]
const _WRONG_BOTH_LINES: Array[String] = [_DOT, "{w} · {u} = {w_x}·{u_x} + {w_y}·{u_y} = {dot}"]
# The same for the usual mistake: w is not brought to length 1.
const _WRONG_LINES: Array[Array] = [
	_VECTORS,
	[_LENGTH],
	[_DOT],
	["{p} = {scalar} {w} = {p_pair}", "|{w}|² = {w_length}² = {w_square}"],
	["{u} − {p} = {rejection}", "({u} − {p}) · {w} = {check}"],
]
# On the angle, in place of those on the shadow.
const _ANGLE_LINES: Array[String] = [
	_DOT,
	"{u} · {e} = |{u}| cos φ",
	"{u} · {w} = |{u}| |{w}| cos φ",
	"{u} · {w} = {u_length}·{w_length}·cos {angle}° = {by_angle}",
	"{v} · {e} = cos φ = {cosine}",
	"−1 ≤ {v} · {e} ≤ 1",
]
const _PRIMITIVE_LINES: Array[String] = [
	"{u_angle} = atan2({u_y}, {u_x})%s = {u_degrees}°",
	"{w_angle} = atan2({w_y}, {w_x})%s = {w_degrees}°",
	"φ = {u_angle} − {w_angle}%s = {phi}°",
	"cos φ = cos {phi}° = {cos_phi}",
	"|{u}| cos φ = {u_length}·cos {phi}° = {primitive}",
]

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of [param step] with the numbers of [param model]. What is left by rounding is
## not told where it [param is_moving]: so long a line for a single frame makes the panel jump.
func show_model(model: DotProductModel, step: int, is_moving: bool) -> void:
	_put_both_vectors(model)
	_put_dot(model, is_moving)
	_put_shadow(model)
	_put_angles(model)
	_formula.show_lines(_lines(model, step))


# Where a vector has no direction, what would divide by its length is left out.
func _lines(model: DotProductModel, step: int) -> PackedStringArray:
	var lines := PackedStringArray(_VECTORS)
	if not model.onto().length():
		if step >= DotProductTexts.Step.UNIT:
			lines.append(_LENGTH)
	elif step <= DotProductTexts.Step.SURE or not model.shadowed().length():
		lines.append_array(_lines_on_shadow(model, step))
	elif step == DotProductTexts.Step.BOTH:
		lines.append_array(_BOTH_LINES if model.normalizes else _WRONG_BOTH_LINES)
	elif step == DotProductTexts.Step.ANGLE:
		lines.append_array(_ANGLE_LINES)
	else:
		lines.append_array(_primitive_lines(model))
	return lines


# Where angles go from 0 to 360 degrees, a full turn is added to those below 0: atan2 does not.
static func _primitive_lines(model: DotProductModel) -> PackedStringArray:
	var of_u := model.shadowed().angle_degrees()
	var of_w := model.onto().angle_degrees()
	var phi := Conventions.in_range(of_u) - Conventions.in_range(of_w)
	var angles: PackedFloat64Array = [of_u, of_w, phi]
	var lines := PackedStringArray(_PRIMITIVE_LINES)
	for i in angles.size():
		var is_added := Conventions.has_full_turn() and angles[i] < 0.0
		lines[i] = lines[i] % (" + 360°" if is_added else "")
	return lines


# Where p is measured, its length takes the place of the lines on the rest.
func _lines_on_shadow(model: DotProductModel, step: int) -> PackedStringArray:
	var added := _LINES if model.normalizes else _WRONG_LINES
	var is_measured := step == DotProductTexts.Step.SURE
	var last := DotProductTexts.Step.PROJECTION if is_measured else step
	var lines: PackedStringArray = []
	for of_step: Array in added.slice(1, last + 1):
		lines.append_array(of_step)
	if is_measured:
		lines.append(_MEASURED)
	return lines


func _put_both_vectors(model: DotProductModel) -> void:
	_formula.put_symbol("a", "a", Palette.Role.A)
	_formula.put_symbol("b", "b", Palette.Role.B)
	_formula.put_number("ax", model.a().x, Palette.Role.A, tr("x of a"))
	_formula.put_number("ay", model.a().y, Palette.Role.A, tr("y of a"))
	_formula.put_number("bx", model.b().x, Palette.Role.B, tr("x of b"))
	_formula.put_number("by", model.b().y, Palette.Role.B, tr("y of b"))


# The first line says what is rounding; in those after it that is 0.
func _put_dot(model: DotProductModel, is_moving: bool) -> void:
	var is_rounding := model.is_dot_zero()
	var unrounded := model.dot() if not (is_rounding and is_moving) else 0.0
	_formula.put_number("dot", unrounded, Palette.Role.INK)
	_formula.put_number("dot_used", 0.0 if is_rounding else model.dot(), Palette.Role.INK)
	var scalar := 0.0 if is_rounding else model.scalar_projection()
	_formula.put_number("scalar", scalar, Palette.Role.PROJECTION)
	var projection := Vec2.new() if is_rounding else model.vector_projection()
	_formula.put_vector("p_pair", projection, Palette.Role.PROJECTION)
	_formula.put_number("p_x", projection.x, Palette.Role.PROJECTION)
	_formula.put_number("p_y", projection.y, Palette.Role.PROJECTION)
	_formula.put_number("p_length", projection.length(), Palette.Role.PROJECTION)
	var other := 0.0 if is_rounding else model.other_scalar_projection()
	_formula.put_number("other_scalar", other, Palette.Role.REST)


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
	# As the lines above show p: 0 where the dot product is only rounding.
	var projection := Vec2.new() if model.is_dot_zero() else model.vector_projection()
	var rejection := model.shadowed().minus(projection)
	var check := rejection.dot(model.onto())
	var size := model.shadowed().length() * model.onto().length()
	_formula.put_sum("check", check, size, Palette.Role.REST)
	_formula.put_vector("e_pair", model.unit(), Palette.Role.UNIT)
	var u := model.shadowed()
	var parts := Vec2.new(absf(u.x) + absf(projection.x), absf(u.y) + absf(projection.y))
	_formula.put_vector_sum("rejection", rejection, parts, Palette.Role.REST)
	_formula.put_number("w_square", model.onto().length_squared(), role_of_w)


func _put_angles(model: DotProductModel) -> void:
	var role_of_u := Palette.Role.B if model.is_swapped else Palette.Role.A
	var role_of_w := Palette.Role.A if model.is_swapped else Palette.Role.B
	var of_u := model.shadowed().angle_degrees()
	var of_w := model.onto().angle_degrees()
	_formula.put_symbol("v", DotProductTexts.shadowed_unit_symbol(model), role_of_u)
	_formula.put_symbol("u_angle", "β" if model.is_swapped else "α", role_of_u)
	_formula.put_symbol("w_angle", "α" if model.is_swapped else "β", role_of_w)
	_formula.put_number("u_length", model.shadowed().length(), role_of_u)
	_formula.put_angle("u_degrees", Conventions.in_range(of_u), role_of_u)
	_formula.put_angle("w_degrees", Conventions.in_range(of_w), role_of_w)
	_formula.put_angle("angle", model.angle_degrees(), Palette.Role.INK)
	# The angles are rounded, too, and shown with fewer digits than the sum of two products needs.
	var size := 256.0 * model.shadowed().length()
	var dot := 0.0 if model.is_dot_zero() else model.dot()
	_formula.put_sum("by_angle", dot, size * model.onto().length(), Palette.Role.INK)
	var is_rounding := absf(of_u - of_w) <= FormulaStatement.ROUNDING * (absf(of_u) + absf(of_w))
	_formula.put_angle("phi", 0.0 if is_rounding else _phi(of_u, of_w), Palette.Role.INK)
	_formula.put_sum("cos_phi", cos(Vec2.deg_to_rad(of_u - of_w)), 256.0, Palette.Role.INK)
	_formula.put_sum("cosine", model.cosine(), 1.0, Palette.Role.INK)
	var primitive := PrimitiveProjection.scalar(model.shadowed(), model.onto())
	_formula.put_sum("primitive", primitive, size, Palette.Role.PROJECTION)


# Of the angles as they are shown.
static func _phi(of_u: float, of_w: float) -> float:
	return Conventions.in_range(Conventions.in_range(of_u) - Conventions.in_range(of_w))
