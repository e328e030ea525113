class_name NormalsFormula
extends RefCounted
## The formula of the lesson on normals: its lines, and what each name in them is.
##
## e is the unit normal, f is v with length 1, w1 and w2 are the wrong normals of mistake 9.

const _NORMAL := "{n} = (−y, x) = {n_pair}"
const _CHECK := "{v} · {n} = {x}·{n_x} + {y}·{n_y} = {check}"
const _LENGTH := "|{n}| = √({n_x}² + {n_y}²) = {n_length}"
const _UNIT := "{e} = {n} / |{n}| = {n_pair} / {n_length} = {e_pair}"
const _UNIT_V := "{f} = {v} / |{v}| = {f_pair}"
const _ZERO := "|{n}| = {n_length}     {e} = {e_pair}"

# The lines that each step shows below the one of v.
const _LINES: Array[Array] = [
	[],
	[
		"cos 90° = 0     sin 90° = 1",
		"{n} = ({turned_x}, {turned_y})",
		"{n} = ({x}·0 − {y}·1, {x}·1 + {y}·0) = {n_pair}",
		_CHECK,
	],
	[_NORMAL, "(y, −x) = {opposite_pair} = −{n}"],
	[_NORMAL, _LENGTH, _UNIT, _UNIT_V],
	[_NORMAL, _LENGTH, _UNIT, "{k} · {e} = {scaled_pair}"],
]
const _LINES_OF_ZERO: Array[Array] = [
	[], [_NORMAL], [_NORMAL, "(y, −x) = {opposite_pair}"], [_NORMAL, _ZERO], [_NORMAL, _ZERO]
]

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of [param step] of [NormalsTexts] with the numbers of [param model]; with a
## mistake switched on only those that it concerns, and its own.
func show_model(model: NormalsModel, step: int) -> void:
	_put_line(model)
	_put_normals(model)
	_put_mistakes(model)
	var lines: PackedStringArray = ["{v} = ( {vx} , {vy} )   " + tr("from") + " ( {sx} , {sy} )"]
	var of_steps := _LINES if model.has_direction() else _LINES_OF_ZERO
	match model.mistake:
		NormalsMistakes.WRONG_NORMAL:
			lines.append_array(_lines_of_wrong_normal())
		NormalsMistakes.ZERO_VECTOR:
			lines.append_array(_lines_of_zero_vector(model))
		NormalsMistakes.CUT_LENGTH:
			lines.append_array(_lines_of_cut_length(model))
		_:
			lines.append_array(PackedStringArray(of_steps[step]))
	_formula.show_lines(lines)


func _lines_of_wrong_normal() -> PackedStringArray:
	return [
		_NORMAL,
		_CHECK,
		"{w1} = {w1_pair}     {v} · {w1} = {x}·{y} + {y}·{x} = {w1_check}",
		"{w2} = {w2_pair} = −{n}",
	]


func _lines_of_zero_vector(model: NormalsModel) -> PackedStringArray:
	if model.has_direction():
		return [_NORMAL, _LENGTH, _UNIT, "{cross} " + tr("without the test for 0: the same")]
	return [_NORMAL, _ZERO, "{cross} " + tr("divides 0 by 0")]


# From this length on there are only whole numbers: nothing is cut.
func _lines_of_cut_length(model: NormalsModel) -> PackedStringArray:
	if not model.has_direction():
		return [_NORMAL, _ZERO]
	if model.v().length() > 1e15:
		return [_NORMAL, _LENGTH, _UNIT]
	return [_NORMAL, _LENGTH, _UNIT, "{cross} int({uncut}) = {cut}"]


func _put_line(model: NormalsModel) -> void:
	var v := model.v()
	_formula.put_symbol("v", "v", Palette.Role.A)
	_formula.put_number("vx", v.x, Palette.Role.A, tr("x of v"))
	_formula.put_number("vy", v.y, Palette.Role.A, tr("y of v"))
	_formula.put_number("x", v.x, Palette.Role.A)
	_formula.put_number("y", v.y, Palette.Role.A)
	_formula.put_number("sx", model.start.x, Palette.Role.INK, tr("x of the start"))
	_formula.put_number("sy", model.start.y, Palette.Role.INK, tr("y of the start"))
	_formula.put_number("k", model.times, Palette.Role.UNIT, tr("How many times n̂ is drawn"))


func _put_normals(model: NormalsModel) -> void:
	var n := model.normal()
	_formula.put_symbol("n", "n", Palette.Role.B)
	_formula.put_vector("n_pair", n, Palette.Role.B)
	# In two parts, between which the line may break.
	_formula.put_symbol("turned_x", "x cos 90° − y sin 90°", Palette.Role.A)
	_formula.put_symbol("turned_y", "x sin 90° + y cos 90°", Palette.Role.A)
	_formula.put_number("n_x", n.x, Palette.Role.B)
	_formula.put_number("n_y", n.y, Palette.Role.B)
	_formula.put_number("n_length", n.length(), Palette.Role.B)
	_formula.put_number("check", model.v().dot(n), Palette.Role.INK)
	_formula.put_vector("opposite_pair", model.opposite(), Palette.Role.REST)
	_formula.put_symbol("f", "v̂", Palette.Role.A)
	_formula.put_vector("f_pair", model.v().normalized(), Palette.Role.A)
	_formula.put_symbol("e", "n̂", Palette.Role.UNIT)
	_formula.put_vector("e_pair", model.unit(), Palette.Role.UNIT)
	_formula.put_vector("scaled_pair", model.scaled(), Palette.Role.UNIT)


func _put_mistakes(model: NormalsModel) -> void:
	var v := model.v()
	var swapped := NormalsMistakes.swapped(v)
	_formula.put_symbol("w1", "✗ (y, x)", Palette.Role.WRONG)
	_formula.put_vector("w1_pair", swapped, Palette.Role.WRONG)
	_formula.put_number("w1_check", v.dot(swapped), Palette.Role.WRONG)
	_formula.put_symbol("w2", "✗ (y, −x)", Palette.Role.WRONG)
	_formula.put_vector("w2_pair", NormalsMistakes.wrong_sign(v), Palette.Role.WRONG)
	_formula.put_symbol("cross", "✗", Palette.Role.WRONG)
	_formula.put_text("uncut", NormalsTexts.uncut_text(v.length()), Palette.Role.B)
	_formula.put_number("cut", floorf(v.length()), Palette.Role.WRONG)
