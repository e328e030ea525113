class_name LineDistanceFormula
extends RefCounted
## The formula of the lesson on the distance from a line: its lines, and what each name in them is.

# What each mistake computes.
const _WRONG_LINES: Dictionary[int, String] = {
	LineDistanceMistakes.NOT_UNIT:
	"{wrong}: {d} · (−y, x) = {dx}·{minus_ly} + {dy}·{lx} = {wrong_distance}",
	LineDistanceMistakes.WRONG_SIGN: "{wrong}: {d} · (−{n}) = {wrong_distance}",
	LineDistanceMistakes.STRAIGHT_UP: "{wrong}: y of the line − y of c = {wrong_distance}",
}

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of all steps up to [param step] with the numbers of [param model].
func show_model(model: LineDistanceModel, step: int) -> void:
	_put_symbols()
	_put_what_is_typed(model)
	# d is the difference of c and p: what rounding leaves of it grows with both.
	var scale := 4.0 * (model.ball.position.length() + model.from().length())
	_put_vectors(model.line.along(), model.difference(), model.line.normal(), scale)
	_put_distances(model, scale)
	_put_segment(model, scale)
	_formula.show_lines(_lines(model, step))


func _lines(model: LineDistanceModel, step: int) -> PackedStringArray:
	var found: PackedStringArray = []
	var is_compared := LineDistanceTexts.is_compared(model, step)
	# With a mistake, its line replaces those after the step of the distance.
	var last := LineDistanceTexts.Step.DISTANCE if is_compared else step
	for added: PackedStringArray in _lines_by_step().slice(0, last + 1):
		found.append_array(added)
	if is_compared:
		var has_answer := is_finite(model.distance_with_mistake())
		var none := "{wrong}: " + tr("a vertical line has no y at the ball's x")
		found.append(_WRONG_LINES[model.mistake] if has_answer else none)
	return found


# The lines that each step adds.
func _lines_by_step() -> Array[PackedStringArray]:
	return [
		[
			tr("line: ( {sx} , {sy} ) to ( {ex} , {ey} )"),
			tr("{c} = ( {cx} , {cy} )   r = {r}   {p} at {share}"),
			"{d} = {c} − {p} = {d_pair}"
		],
		["{n} = (−{ly}, {lx}) / {length} = {n_pair}"],
		["{d} · {n} = {dx}·{nx} + {dy}·{ny} = {distance}"],
		["gap = {d} · {n} − r = {distance} − {radius} = {gap}"],
		[tr("to the segment: |{c} − {nearest}| = {segment}")],
	]


func _put_symbols() -> void:
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


func _put_vectors(along: Vec2, difference: Vec2, normal: Vec2, scale: float) -> void:
	_formula.put_number("lx", along.x, Palette.Role.INK)
	_formula.put_number("ly", along.y, Palette.Role.INK)
	_formula.put_number("minus_ly", -along.y, Palette.Role.INK)
	_formula.put_number("length", along.length(), Palette.Role.INK)
	_formula.put_vector_sum("d_pair", difference, Vec2.new(scale, scale), Palette.Role.A)
	_formula.put_sum("dx", difference.x, scale, Palette.Role.A)
	_formula.put_sum("dy", difference.y, scale, Palette.Role.A)
	_formula.put_vector("n_pair", normal, Palette.Role.UNIT)
	_formula.put_number("nx", normal.x, Palette.Role.UNIT)
	_formula.put_number("ny", normal.y, Palette.Role.UNIT)


func _put_distances(model: LineDistanceModel, scale: float) -> void:
	var distance := 0.0 if model.is_p_at_ball() else model.distance()
	_formula.put_sum("distance", distance, scale, Palette.Role.PROJECTION)
	_formula.put_number("radius", model.ball.radius, Palette.Role.INK)
	_formula.put_sum("gap", model.gap(), scale, Palette.Role.INK)
	# A normal that is not unit makes what rounding leaves larger, too.
	var is_not_unit := model.mistake == LineDistanceMistakes.NOT_UNIT
	var wrong_scale := scale * model.line.length() if is_not_unit else scale
	var wrong := model.distance_with_mistake()
	_formula.put_sum("wrong_distance", wrong, wrong_scale, Palette.Role.WRONG)


# Where the ball's centre is on the segment, the nearest point reads as c, and |c − c| is 0.
func _put_segment(model: LineDistanceModel, scale: float) -> void:
	var distance := 0.0 if model.is_on_segment() else model.segment_distance()
	_formula.put_vector("nearest", model.nearest(), Palette.Role.REST)
	_formula.put_sum("segment", distance, scale, Palette.Role.REST)
