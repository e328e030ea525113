class_name AngledLinesFormula
extends RefCounted
## The formula of the lesson on angled lines: gravity, bounciness, the selected ball and one of its
## bounces.
##
## x is the ball's centre, v its velocity, n the normal of the line that it meets, w its velocity
## after the bounce.

const _LINES: PackedStringArray = [
	"{g} = ( {gx} , {gy} )    C = {C}",
	"{x} = ( {px} , {py} )   {v} = ( {vx} , {vy} )",
]
const _LINES_ON_BOUNCE: PackedStringArray = [
	"{w} = {v} − (1 + C) ({v} · {n}) {n} = {w_pair}",
	"   = {v_pair} − {factor} · {vn} {n_pair}",
]
# While time runs, the numbers change once in this many frames of the screen: slowly enough to be
# read.
const _FRAMES_BETWEEN := 15

var _formula: Formula
var _frames_unshown := 0


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows [param model] with the bounce to come in [param forecast]. Where that is null, time runs:
## then it shows the latest bounce, and only now and then. True where it was shown.
func show_moment(model: AngledLinesModel, forecast: BallForecast) -> bool:
	_frames_unshown += 1
	if not forecast and _frames_unshown < _FRAMES_BETWEEN:
		return false
	_frames_unshown = 0
	_show(model, forecast.next_bounce if forecast else model.last_bounce)
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


func _show(model: AngledLinesModel, bounce: BounceRecord) -> void:
	var ball := model.ball()
	var surroundings := model.world.surroundings
	_formula.put_symbol("g", "g", Palette.Role.B)
	_formula.put_symbol("x", "x", Palette.Role.A)
	_formula.put_symbol("v", "v", Palette.Role.A)
	_put("gx", surroundings.gravity.x, Palette.Role.B, tr("x of gravity"))
	_put("gy", surroundings.gravity.y, Palette.Role.B, tr("y of gravity"))
	_put("px", ball.position.x, Palette.Role.A, tr("x of the ball"))
	_put("py", ball.position.y, Palette.Role.A, tr("y of the ball"))
	_put("vx", ball.velocity.x, Palette.Role.A, tr("x of the velocity"))
	_put("vy", ball.velocity.y, Palette.Role.A, tr("y of the velocity"))
	_formula.put_number("C", surroundings.bounciness, Palette.Role.INK, tr("bounciness C"))
	if bounce:
		_put_bounce(bounce, surroundings.bounciness)
	_formula.show_lines(_LINES + (_LINES_ON_BOUNCE if bounce else PackedStringArray()))


func _put_bounce(bounce: BounceRecord, bounciness: float) -> void:
	var along_normal := roundf(bounce.velocity_before.dot(bounce.normal))
	var normal := NumberText.pair(bounce.normal.x, bounce.normal.y, 3)
	_formula.put_symbol("n", "n", Palette.Role.UNIT)
	_formula.put_symbol("w", "v′", Palette.Role.PROJECTION)
	_formula.put_text("n_pair", normal, Palette.Role.UNIT)
	_formula.put_text("v_pair", _whole_pair(bounce.velocity_before), Palette.Role.A)
	_formula.put_text("w_pair", _whole_pair(bounce.velocity_after), Palette.Role.PROJECTION)
	_formula.put_text("vn", NumberText.factor(along_normal), Palette.Role.INK)
	_formula.put_text("factor", NumberText.short(1.0 + bounciness), Palette.Role.INK)


static func _whole_pair(vector: Vec2) -> String:
	return NumberText.pair(roundf(vector.x), roundf(vector.y))


# Tenths, and at most four digits: while time runs they can be read along.
func _put(name_in_line: String, value: float, role: Palette.Role, title: String) -> void:
	var step := 0.1 if absf(value) < 1000.0 else 1.0
	_formula.put_number(name_in_line, snappedf(value, step), role, title)
