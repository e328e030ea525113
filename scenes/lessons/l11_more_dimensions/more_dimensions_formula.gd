class_name MoreDimensionsFormula
extends RefCounted
## The formula of the lesson on more dimensions: its lines, and what each name in them is.
##
## a1, a2, ... are the components of a, which can be typed; pa1, pa2, ... are the same in the
## products, and p1, p2, ... the products.

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines up to [param step] with the numbers of [param model].
func show_model(model: MoreDimensionsModel, step: int) -> void:
	_formula.put_symbol("a", "a", Palette.Role.A)
	_formula.put_symbol("b", "b", Palette.Role.B)
	for i in model.dimension():
		_put_component(i + 1, model.a[i], model.b[i])
	_formula.put_sum("dot", model.dot(), model.size_of_products(), Palette.Role.INK)
	_formula.put_answer("sign", MoreDimensionsTexts.comparison(model), Palette.Role.INK)
	_formula.put_answer("words", MoreDimensionsTexts.sign_words(model), Palette.Role.INK)
	_formula.put_number("length_a", model.length_of_a(), Palette.Role.A)
	_formula.put_number("length_b", model.length_of_b(), Palette.Role.B)
	_formula.put_sum("cosine", model.cosine(), 1.0, Palette.Role.INK)
	_formula.put_answer("angle", _angle_text(model), Palette.Role.INK)
	_formula.show_lines(_lines(model, step))


func _put_component(place: int, of_a: float, of_b: float) -> void:
	_formula.put_number("a%d" % place, of_a, Palette.Role.A, tr("Component %d of a") % place)
	_formula.put_number("b%d" % place, of_b, Palette.Role.B, tr("Component %d of b") % place)
	_formula.put_number("pa%d" % place, of_a, Palette.Role.A)
	_formula.put_number("pb%d" % place, of_b, Palette.Role.B)
	_formula.put_number("p%d" % place, of_a * of_b, Palette.Role.PROJECTION)


func _lines(model: MoreDimensionsModel, step: int) -> PackedStringArray:
	var dimension := model.dimension()
	var found: PackedStringArray = [_list("a", dimension), _list("b", dimension)]
	if step == MoreDimensionsTexts.Step.PRODUCTS:
		found.append("{a} · {b} = " + _joined("{pa%d}·{pb%d}", dimension, " + "))
	if step >= MoreDimensionsTexts.Step.SUM:
		found.append("{a} · {b} = " + _joined("{pa%d}·{pb%d}", dimension, " + ") + " = {dot}")
	if step >= MoreDimensionsTexts.Step.SIGN:
		found.append("{a} · {b} {sign} 0: {words}")
	if step >= MoreDimensionsTexts.Step.ANGLE and model.has_angle():
		found.append("|{a}| = {length_a}     |{b}| = {length_b}")
		found.append("cos α = {dot} / ({length_a}·{length_b}) = {cosine}")
		found.append("α = {angle}°")
	return found


# In the unit that is chosen, with as many digits as tell it from a right angle, where it is none.
static func _angle_text(model: MoreDimensionsModel) -> String:
	var is_right := model.side() == MoreDimensionsModel.Side.RIGHT
	var degrees := 90.0 if is_right else model.angle_degrees()
	var share := Conventions.share_of_pi(degrees)
	if share and (is_right or degrees != 90.0):
		return share
	var angle := Conventions.shown(degrees)
	var right := Conventions.shown(90.0)
	var digits := 4
	while not is_right and _is_same(angle, right, digits) and digits < 17:
		digits += 1
	return NumberText.short(angle, digits)


static func _is_same(one: float, other: float, digits: int) -> bool:
	return NumberText.rounded(one, digits) == NumberText.rounded(other, digits)


static func _list(letter: String, dimension: int) -> String:
	return "{%s} = ( %s )" % [letter, _joined("{%s%%d}" % letter, dimension, " , ")]


static func _joined(pattern: String, dimension: int, between: String) -> String:
	var parts: PackedStringArray = []
	for i in dimension:
		parts.append(pattern.replace("%d", str(i + 1)))
	return between.join(parts)
