class_name AngledLinesFormula
extends RefCounted
## Puts gravity, bounciness, the selected ball and one of its bounces into the formula lines.

# A screen's frames between two looks at it: while balls move, numbers change slowly enough to be
# read.
const _FRAMES_BETWEEN := 15

var _formula: Formula
var _frames_unshown := 0


## Says to [param formula] what the names in [AngledLinesTexts] stand for.
func _init(formula: Formula) -> void:
	_formula = formula
	_formula.define_symbol("g", "g", Palette.Role.B)
	_formula.define_symbol("x", "x", Palette.Role.A)
	_formula.define_symbol("v", "v", Palette.Role.A)
	_formula.define_symbol("n", "n", Palette.Role.UNIT)
	_formula.define_symbol("w", "v′", Palette.Role.PROJECTION)
	_formula.define_number("gx", Palette.Role.B, tr("x of gravity"))
	_formula.define_number("gy", Palette.Role.B, tr("y of gravity"))
	_formula.define_number("C", Palette.Role.INK, tr("bounciness C"))
	_formula.define_number("px", Palette.Role.A, tr("x of the ball"))
	_formula.define_number("py", Palette.Role.A, tr("y of the ball"))
	_formula.define_number("vx", Palette.Role.A, tr("x of the velocity"))
	_formula.define_number("vy", Palette.Role.A, tr("y of the velocity"))
	_formula.define_number("n_pair", Palette.Role.UNIT)
	_formula.define_number("v_pair", Palette.Role.A)
	_formula.define_number("vn", Palette.Role.INK)
	_formula.define_number("factor", Palette.Role.INK)
	_formula.define_number("w_pair", Palette.Role.PROJECTION)


## Shows [param model] with its latest bounce now and then. True where it was shown.
func follow_model(model: AngledLinesModel) -> bool:
	_frames_unshown += 1
	var is_due := _frames_unshown >= _FRAMES_BETWEEN
	if is_due:
		show_model(model, model.last_bounce)
	return is_due


## Shows [param model]; [param bounce] is the one to come or the latest, or null.
func show_model(model: AngledLinesModel, bounce: BounceRecord) -> void:
	_frames_unshown = 0
	_formula.show_lines(AngledLinesTexts.formula_lines(bounce != null))
	var gravity := model.world.surroundings.gravity
	var ball := model.ball()
	_put("gx", gravity.x)
	_put("gy", gravity.y)
	_formula.set_number("C", model.world.surroundings.bounciness)
	_put("px", ball.position.x)
	_put("py", ball.position.y)
	_put("vx", ball.velocity.x)
	_put("vy", ball.velocity.y)
	if bounce:
		_show_bounce(bounce, model.world.surroundings.bounciness)


func _show_bounce(bounce: BounceRecord, bounciness: float) -> void:
	var along_normal := bounce.velocity_before.dot(bounce.normal)
	_formula.set_text("n_pair", NumberText.pair(bounce.normal.x, bounce.normal.y, 3))
	_formula.set_text("v_pair", _whole_pair(bounce.velocity_before))
	_formula.set_text("w_pair", _whole_pair(bounce.velocity_after))
	_formula.set_text("vn", NumberText.factor(roundf(along_normal)))
	_formula.set_text("factor", NumberText.short(1.0 + bounciness))


static func _whole_pair(vector: Vec2) -> String:
	return NumberText.pair(roundf(vector.x), roundf(vector.y))


# Tenths, and no more than four digits: who reads along while it runs sees a number, not a row of
# digits.
func _put(name_in_line: String, value: float) -> void:
	var step := 0.1 if absf(value) < 1000.0 else 1.0
	_formula.set_number(name_in_line, snappedf(value, step))
