class_name AngledLinesFormula
extends RefCounted
## The formula of the lesson on angled lines: gravity, bounciness, the selected ball and one of its
## bounces.
##
## P is the ball's centre, v its velocity, n̂ the normal of the line that it meets, v₁ and v₂ its
## velocity before and after that bounce.

const _LINES: PackedStringArray = [
	"{g} = ( {gx} , {gy} )    C = {C}",
	"{P} = ( {px} , {py} )   {v} = ( {vx} , {vy} )",
]
const _LINES_ON_BOUNCE: PackedStringArray = [
	"{after} = {before} − (1 + C) ({before} · {n}) {n}",
	"{after} = {before_pair} − {factor} · {vn} {n_pair} = {after_pair}",
]
# While time runs, the numbers change once in this many frames of the screen: slowly enough to be
# read.
const _FRAMES_BETWEEN := 15

var _formula: Formula
var _frames_unshown := 0


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows [param model] with [param bounce], if it is not null. While time runs it shows the numbers
## only now and then. True where they were shown.
func show_moment(model: AngledLinesModel, bounce: BounceRecord, is_running: bool) -> bool:
	_frames_unshown += 1
	if is_running and _frames_unshown < _FRAMES_BETWEEN:
		return false
	_frames_unshown = 0
	_show(model, bounce, is_running)
	return true


## Puts a typed number into [param model]. "" or one sentence with the value and what is allowed;
## then nothing has changed.
static func enter(model: AngledLinesModel, name_in_line: String, value: float) -> String:
	if name_in_line == "C":
		return model.set_bounciness(value)
	var gravity := model.world.surroundings.gravity.copy()
	var position := model.ball().position.copy()
	var velocity := model.ball().velocity.copy()
	var vectors: Dictionary[String, Vec2] = {"g": gravity, "p": position, "v": velocity}
	vectors[name_in_line[0]].set(name_in_line[1], value)
	if name_in_line[0] == "g":
		return model.set_gravity(gravity)
	return model.change_ball(position, velocity)


func _show(model: AngledLinesModel, bounce: BounceRecord, is_running: bool) -> void:
	var ball := model.ball()
	var surroundings := model.world.surroundings
	var step := 0.1 if is_running else 0.0
	_formula.put_symbol("g", "g", Palette.Role.B)
	_formula.put_symbol("P", "P", Palette.Role.A)
	_formula.put_symbol("v", "v", Palette.Role.A)
	_put("gx", surroundings.gravity.x, Palette.Role.B, tr("x of gravity"))
	_put("gy", surroundings.gravity.y, Palette.Role.B, tr("y of gravity"))
	_put("px", snappedf(ball.position.x, step), Palette.Role.A, tr("x of the ball"))
	_put("py", snappedf(ball.position.y, step), Palette.Role.A, tr("y of the ball"))
	_put("vx", snappedf(ball.velocity.x, step), Palette.Role.A, tr("x of the velocity"))
	_put("vy", snappedf(ball.velocity.y, step), Palette.Role.A, tr("y of the velocity"))
	_put("C", surroundings.bounciness, Palette.Role.INK, tr("bounciness C"))
	if bounce:
		_put_bounce(bounce, surroundings.bounciness)
	_formula.show_lines(_LINES + (_LINES_ON_BOUNCE if bounce else PackedStringArray()))


func _put(name_in_line: String, value: float, role: Palette.Role, title: String) -> void:
	_formula.put_number(name_in_line, value, role, title)


func _put_bounce(bounce: BounceRecord, bounciness: float) -> void:
	var before := bounce.velocity_before
	_formula.put_symbol("n", "n̂", Palette.Role.UNIT)
	_formula.put_symbol("before", "v₁", Palette.Role.A)
	_formula.put_symbol("after", "v₂", Palette.Role.PROJECTION)
	_formula.put_vector("n_pair", bounce.normal, Palette.Role.UNIT)
	_formula.put_vector("before_pair", before, Palette.Role.A)
	_formula.put_vector("after_pair", bounce.velocity_after, Palette.Role.PROJECTION)
	_formula.put_number("vn", before.dot(bounce.normal), Palette.Role.INK)
	_formula.put_number("factor", 1.0 + bounciness, Palette.Role.INK)
