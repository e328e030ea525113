class_name LineDistanceFormula
extends RefCounted
## The formula of the lesson on the distance from a line: its lines, and what each name in them is.

# With a mistake, its line replaces those after this step.
const _LAST_STEP_WITH_MISTAKE := 2
# What each mistake computes.
const _WRONG_LINES: Dictionary[int, String] = {
	LineDistanceMistakes.NOT_UNIT: "{wrong}: {d} · ( −({ly}), {lx} ) = {wrong_distance}",
	LineDistanceMistakes.WRONG_SIGN: "{wrong}: {d} · (−{n}) = {wrong_distance}",
	LineDistanceMistakes.STRAIGHT_UP: "{wrong}: straight up {wrong_distance}",
}

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of all steps up to [param step] with the numbers of [param model].
func show_model(model: LineDistanceModel, step: int) -> void:
	_put_symbols()
	_put_what_is_typed(model)
	_put_vectors(model.line.along(), model.difference(), model.line.normal())
	_put_distances(model)
	_formula.show_lines(_lines(model, step))


func _lines(model: LineDistanceModel, step: int) -> PackedStringArray:
	var found: PackedStringArray = []
	var last := step if model.mistake == 0 else mini(step, _LAST_STEP_WITH_MISTAKE)
	for added: PackedStringArray in _lines_by_step().slice(0, last + 1):
		found.append_array(added)
	if model.mistake != 0:
		found.append(_WRONG_LINES[model.mistake])
	return found


# The lines that each step adds.
func _lines_by_step() -> Array[PackedStringArray]:
	return [
		[
			tr("{l}: ( {sx} , {sy} ) to ( {ex} , {ey} )"),
			tr("{c} = ( {cx} , {cy} )   r = {r}   {p} at {share}"),
			"{d} = {c} − {p} = {d_pair}"
		],
		["{n} = ( −({ly}), {lx} ) / {length} = {n_pair}"],
		["{d} · {n} = {dx}·{nx} + {dy}·{ny} = {distance}"],
		["gap = {d} · {n} − r = {gap}"],
		[tr("to the segment: |{c} − {nearest}| = {segment}")],
	]


func _put_symbols() -> void:
	_formula.put_symbol("l", "l", Palette.Role.INK)
	_formula.put_symbol("c", "c", Palette.Role.INK)
	_formula.put_symbol("p", "p", Palette.Role.A)
	_formula.put_symbol("d", "d", Palette.Role.A)
	_formula.put_symbol("n", "n̂", Palette.Role.UNIT)
	_formula.put_symbol("wrong", tr("wrong"), Palette.Role.WRONG)


# Each of these has its counterpart in LineDistanceModel.enter.
func _put_what_is_typed(model: LineDistanceModel) -> void:
	var ink := Palette.Role.INK
	_formula.put_number("sx", model.line.start.x, ink, tr("x of the line's start"))
	_formula.put_number("sy", model.line.start.y, ink, tr("y of the line's start"))
	_formula.put_number("ex", model.line.end.x, ink, tr("x of the line's end"))
	_formula.put_number("ey", model.line.end.y, ink, tr("y of the line's end"))
	_formula.put_number("cx", model.ball.position.x, ink, tr("x of the ball's centre"))
	_formula.put_number("cy", model.ball.position.y, ink, tr("y of the ball's centre"))
	_formula.put_number("r", model.ball.radius, ink, tr("radius of the ball"))
	var title := tr("place of p: 0 at the start, 1 at the end")
	_formula.put_number("share", model.from_share, Palette.Role.A, title)


func _put_vectors(along: Vec2, difference: Vec2, normal: Vec2) -> void:
	_formula.put_text("lx", NumberText.short(along.x), Palette.Role.INK)
	_formula.put_text("ly", NumberText.short(along.y), Palette.Role.INK)
	_formula.put_number("length", along.length(), Palette.Role.INK)
	_formula.put_vector("d_pair", difference, Palette.Role.A)
	_formula.put_number("dx", difference.x, Palette.Role.A)
	_formula.put_number("dy", difference.y, Palette.Role.A)
	_formula.put_vector("n_pair", normal, Palette.Role.UNIT)
	_formula.put_number("nx", normal.x, Palette.Role.UNIT)
	_formula.put_number("ny", normal.y, Palette.Role.UNIT)


func _put_distances(model: LineDistanceModel) -> void:
	_put("distance", model.distance(), Palette.Role.PROJECTION)
	_put("gap", model.gap(), Palette.Role.INK)
	_formula.put_vector("nearest", model.nearest(), Palette.Role.REST)
	_put("segment", model.segment_distance(), Palette.Role.REST)
	_put("wrong_distance", model.distance_with_mistake(), Palette.Role.WRONG)


# A result ends its line: no parentheses around a negative one.
func _put(name_in_line: String, result: float, role: Palette.Role) -> void:
	_formula.put_text(name_in_line, NumberText.short(result), role)
