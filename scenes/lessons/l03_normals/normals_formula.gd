class_name NormalsFormula
extends RefCounted
## The formula of the lesson on normals: its lines, and what each name in them is.
##
## e is the unit normal, w1 and w2 are the wrong normals of mistake 9.

const _LINE_OF_N := "{n} = (−y, x) = {n_pair}     {v} · {n} = {check}"
const _LINE_OF_LENGTH := "|{n}| = √({n_x}² + {n_y}²) = {n_length}"
const _LINE_OF_UNIT := "{e} = {n} / |{n}| = {e_pair}"

# The lines that each step adds to the one of v.
const _LINES: Array[Array] = [
	[],
	[_LINE_OF_N],
	["(y, −x) = {opposite_pair} = −{n}"],
	[_LINE_OF_LENGTH, _LINE_OF_UNIT],
	["{k} · {e} = {scaled_pair}"],
]
# The lines that a mistake shows instead, in all steps.
const _LINES_OF_MISTAKES: Dictionary[int, Array] = {
	NormalsMistakes.WRONG_NORMAL:
	[_LINE_OF_N, "{w1} = {w1_pair}     {v} · {w1} = {w1_check}", "{w2} = {w2_pair}"],
	NormalsMistakes.ZERO_VECTOR:
	[_LINE_OF_LENGTH, _LINE_OF_UNIT, "{cross} {n} / |{n}| = {wrong_pair}"],
	NormalsMistakes.CUT_LENGTH:
	[_LINE_OF_LENGTH, _LINE_OF_UNIT, "{cross} int(|{n}|) = {cut}  →  {wrong_pair}"],
}

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of all steps up to [param step], counted from 0, with the numbers of
## [param model]; with a mistake switched on only those that it concerns, and its own.
func show_model(model: NormalsModel, step: int) -> void:
	_put_line(model)
	_put_normals(model)
	_put_mistakes(model)
	var lines: PackedStringArray = ["{v} = ( {vx} , {vy} )   " + tr("from") + " ( {sx} , {sy} )"]
	if model.mistake != 0:
		lines.append_array(PackedStringArray(_LINES_OF_MISTAKES[model.mistake]))
	else:
		for added: PackedStringArray in _LINES.slice(0, step + 1):
			lines.append_array(added)
	_formula.show_lines(lines)


func _put_line(model: NormalsModel) -> void:
	var v := model.v()
	_formula.put_symbol("v", "v", Palette.Role.A)
	_formula.put_number("vx", v.x, Palette.Role.A, tr("x of v"))
	_formula.put_number("vy", v.y, Palette.Role.A, tr("y of v"))
	_formula.put_number("sx", model.start.x, Palette.Role.INK, tr("x of the start"))
	_formula.put_number("sy", model.start.y, Palette.Role.INK, tr("y of the start"))
	_formula.put_number("k", model.times, Palette.Role.UNIT, tr("How many times n̂ is drawn"))


func _put_normals(model: NormalsModel) -> void:
	var n := model.normal()
	_formula.put_symbol("n", "n", Palette.Role.B)
	_formula.put_vector("n_pair", n, Palette.Role.B)
	_formula.put_number("n_x", n.x, Palette.Role.B)
	_formula.put_number("n_y", n.y, Palette.Role.B)
	_formula.put_number("n_length", n.length(), Palette.Role.B)
	_formula.put_number("check", model.v().dot(n), Palette.Role.INK)
	_formula.put_vector("opposite_pair", model.opposite(), Palette.Role.REST)
	_formula.put_symbol("e", "n̂", Palette.Role.UNIT)
	_formula.put_vector("e_pair", model.unit(), Palette.Role.UNIT)
	_formula.put_vector("scaled_pair", model.scaled(), Palette.Role.UNIT)


func _put_mistakes(model: NormalsModel) -> void:
	var v := model.v()
	var swapped := NormalsMistakes.swapped(v)
	var wrong_unit := NormalsMistakes.wrong_unit(model.mistake, v)
	_formula.put_symbol("w1", "✗ (y, x)", Palette.Role.WRONG)
	_formula.put_vector("w1_pair", swapped, Palette.Role.WRONG)
	_formula.put_number("w1_check", v.dot(swapped), Palette.Role.WRONG)
	_formula.put_symbol("w2", "✗ (y, −x)", Palette.Role.WRONG)
	_formula.put_vector("w2_pair", NormalsMistakes.wrong_sign(v), Palette.Role.WRONG)
	_formula.put_symbol("cross", "✗", Palette.Role.WRONG)
	_formula.put_number("cut", floorf(v.length()), Palette.Role.WRONG)
	_formula.put_vector("wrong_pair", wrong_unit, Palette.Role.WRONG)
