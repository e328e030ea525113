class_name LineEndsFormula
extends RefCounted
## Puts the numbers of the lesson on line ends into its formula lines.

var _formula: Formula


## Says to [param formula] what the names in [LineEndsTexts] stand for.
func _init(formula: Formula) -> void:
	_formula = formula
	_define_symbols()
	_define_typed_numbers()
	for number: String in [
		"radius", "signed", "distance", "approach", "s", "d_squared", "r_squared"
	]:
		_formula.define_number(number, Palette.Role.INK)
	for number: String in ["a", "b", "c", "discriminant", "minus_b", "root", "two_a"]:
		_formula.define_number(number, Palette.Role.INK)
	for number: String in ["line_fraction", "line_point", "first"]:
		_formula.define_number(number, Palette.Role.PROJECTION)
	_formula.define_number("second", Palette.Role.REST)
	_formula.define_number("d_pair", Palette.Role.B)
	_formula.define_number("d_length", Palette.Role.B)
	_formula.define_number("n_pair", Palette.Role.UNIT)
	_formula.define_number("cap_normal", Palette.Role.UNIT)
	_formula.define_number("after", Palette.Role.A)


## Shows the lines of [param step] with the numbers of [param model].
func show_model(model: LineEndsModel, step: int) -> void:
	_formula.define_symbol("end", LineEndsTexts.end_name(model), Palette.Role.INK)
	_formula.define_symbol("t", "t₁" if step >= LineEndsTexts.Step.CAP else "t", _blue())
	_formula.show_lines(LineEndsTexts.lines(model, step))
	_put_typed_numbers(model)
	_put_line(model, step)
	_put_cap(model)


## Puts a typed number into [param model]; says what is wrong with it, "" if it was taken.
static func enter(model: LineEndsModel, name_in_line: String, value: float) -> String:
	var old := model.to_dictionary()
	match name_in_line:
		"px":
			model.start.x = value
		"py":
			model.start.y = value
		"vx":
			model.motion.x = value
		"vy":
			model.motion.y = value
		"ax":
			model.segment.start.x = value
		"ay":
			model.segment.start.y = value
		"bx":
			model.segment.end.x = value
		"by":
			model.segment.end.y = value
		"r":
			model.radius = value
	var problem := model.problem()
	if problem:
		model.from_dictionary(old)
	return problem


func _define_symbols() -> void:
	_formula.define_symbol("v", "v", Palette.Role.A)
	_formula.define_symbol("d", "d", Palette.Role.B)
	_formula.define_symbol("n", "n", Palette.Role.UNIT)
	_formula.define_symbol("u", "t₂", Palette.Role.REST)


func _define_typed_numbers() -> void:
	_formula.define_number("px", Palette.Role.INK, tr("x of the ball's centre"))
	_formula.define_number("py", Palette.Role.INK, tr("y of the ball's centre"))
	_formula.define_number("vx", Palette.Role.A, tr("x of v"))
	_formula.define_number("vy", Palette.Role.A, tr("y of v"))
	_formula.define_number("r", Palette.Role.INK, tr("radius"))
	_formula.define_number("ax", Palette.Role.INK, tr("x of A"))
	_formula.define_number("ay", Palette.Role.INK, tr("y of A"))
	_formula.define_number("bx", Palette.Role.INK, tr("x of B"))
	_formula.define_number("by", Palette.Role.INK, tr("y of B"))


func _put_typed_numbers(model: LineEndsModel) -> void:
	_formula.set_number("px", model.start.x)
	_formula.set_number("py", model.start.y)
	_formula.set_number("vx", model.motion.x)
	_formula.set_number("vy", model.motion.y)
	_formula.set_number("r", model.radius)
	_formula.set_number("ax", model.segment.start.x)
	_formula.set_number("ay", model.segment.start.y)
	_formula.set_number("bx", model.segment.end.x)
	_formula.set_number("by", model.segment.end.y)


func _put_line(model: LineEndsModel, step: int) -> void:
	var is_one_sided := step == LineEndsTexts.Step.ONE_SIDE
	var normal := model.segment.normal() if is_one_sided else model.facing_normal()
	var distance := absf(LineDistance.signed_distance(model.start, model.segment))
	var approach := -model.motion.dot(normal)
	_formula.set_vector("n_pair", normal)
	_formula.set_number("signed", LineDistance.signed_distance(model.start, model.segment))
	_formula.set_number("distance", distance)
	_formula.set_number("approach", approach)
	_formula.set_number("radius", model.radius)
	if approach != 0.0:
		var fraction := PointOfImpact.fraction(distance, distance - approach, model.radius)
		var point := model.start.plus(model.motion.scaled(fraction))
		_formula.set_number("line_fraction", fraction)
		_formula.set_vector("line_point", point)
		_formula.set_number("s", model.segment.share_of(point))


func _put_cap(model: LineEndsModel) -> void:
	var equation := model.cap_equation()
	_formula.set_vector("d_pair", equation.difference)
	_formula.set_number("d_length", equation.difference.length())
	_formula.set_number("d_squared", equation.difference.length_squared())
	_formula.set_number("r_squared", model.radius * model.radius)
	_formula.set_number("a", equation.a)
	_formula.set_number("b", equation.b)
	_formula.set_number("c", equation.c)
	_formula.set_number("discriminant", equation.discriminant())
	_formula.set_number("minus_b", -equation.b)
	_formula.set_number("two_a", 2.0 * equation.a)
	if equation.has_roots():
		_formula.set_number("root", sqrt(equation.discriminant()))
		_formula.set_number("first", equation.first_root())
		_formula.set_number("second", equation.second_root())
	var impact := model.impact_in(LineEndsModel.Field.ROUND_CAPS)
	if impact.hit:
		_formula.set_vector("cap_normal", impact.normal)
		_formula.set_vector("after", model.motion.reflected(impact.normal))


func _blue() -> Palette.Role:
	return Palette.Role.PROJECTION
