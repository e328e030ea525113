class_name EasyBounceFormula
extends RefCounted
## Puts the numbers of the lesson on the easy bounce into its formula lines.

var _formula: Formula


## Says to [param formula] what the names in [EasyBounceTexts] stand for.
func _init(formula: Formula) -> void:
	_formula = formula
	_formula.define_symbol("p", "P", Palette.Role.INK)
	_formula.define_symbol("v", "v", Palette.Role.PROJECTION)
	_formula.define_symbol("n", "n̂", Palette.Role.UNIT)
	_formula.define_symbol("easy", tr("easy:"), Palette.Role.B)
	_formula.define_symbol("right", tr("right:"), Palette.Role.A)
	_formula.define_number("px", Palette.Role.INK, tr("x of the ball"))
	_formula.define_number("py", Palette.Role.INK, tr("y of the ball"))
	_formula.define_number("vx", Palette.Role.PROJECTION, tr("x of v"))
	_formula.define_number("vy", Palette.Role.PROJECTION, tr("y of v"))
	_formula.define_number("r", Palette.Role.INK, tr("Radius of the ball"))
	_formula.define_number("tilt", Palette.Role.INK, tr("Tilt of the line in degrees"))
	for number: String in ["frame", "line_at", "p_axis", "radius"]:
		_formula.define_number(number, Palette.Role.INK)
	for number: String in ["straight", "easy_hit", "back", "v_easy"]:
		_formula.define_number(number, Palette.Role.B)
	for number: String in ["shortest", "depth", "right_hit", "p_right", "v_right"]:
		_formula.define_number(number, Palette.Role.A)


## Shows the lines of [param step] with the numbers of [param model] for its ball [param moved].
func show_model(model: EasyBounceModel, moved: Ball, step: int) -> void:
	_formula.show_lines(EasyBounceTexts.lines(model, moved, step))
	_formula.set_number("px", moved.position.x)
	_formula.set_number("py", moved.position.y)
	_formula.set_number("vx", moved.velocity.x)
	_formula.set_number("vy", moved.velocity.y)
	_formula.set_number("r", moved.radius)
	_formula.set_number("tilt", model.tilt_degrees)
	_put_result("frame", model.frame())
	_put_easy(model, moved)
	_put_right(model, moved)


func _put_easy(model: EasyBounceModel, moved: Ball) -> void:
	var easy := model.easy_result(moved)
	_formula.set_number("line_at", model.line_at(moved.position))
	_formula.set_number("p_axis", moved.position.x if model.is_wall else moved.position.y)
	_formula.set_number("radius", moved.radius)
	_put_result("straight", model.straight_distance(moved.position))
	_formula.set_text("easy_hit", EasyBounceTexts.hit_text(model.easy_detects(moved)))
	_put_result("back", easy.position.x if model.is_wall else easy.position.y)
	_formula.set_vector("v_easy", easy.velocity)


func _put_right(model: EasyBounceModel, moved: Ball) -> void:
	var right := model.right_result(moved)
	var is_hit := LineDistance.is_overlapping(moved, model.line())
	_put_result("shortest", model.shortest_distance(moved.position))
	_formula.set_text("right_hit", EasyBounceTexts.hit_text(is_hit))
	_formula.set_vector("p_right", right.position)
	_formula.set_number("depth", maxf(-LineDistance.gap(moved, model.line()), 0.0))
	_formula.set_vector("v_right", right.velocity)


# A result stands alone: no parentheses around a negative one.
func _put_result(name_in_line: String, value: float) -> void:
	_formula.set_text(name_in_line, NumberText.short(value))
