class_name LineDistanceFormula
extends RefCounted
## The formula of the lesson on the distance from a line: its lines, and what each name in them is.

# What each mistake computes.
const _WRONG_LINES: Dictionary[int, String] = {
	LineDistanceMistakes.NOT_UNIT:
	"{wrong}: {d} · (−y, x) = {dx}·{minus_ly} + {dy}·{lx} = {wrong_distance}",
	LineDistanceMistakes.WRONG_SIGN: "{wrong}: {d} · (−{n}) = {wrong_distance}",
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
	_put_detection(model, scale)
	_formula.show_lines(_lines(model, step))


func _lines(model: LineDistanceModel, step: int) -> PackedStringArray:
	var found: PackedStringArray = []
	var is_compared := LineDistanceTexts.is_compared(model, step)
	var is_detected := step == LineDistanceTexts.Step.DETECTION
	# The line of a mistake, and those of the flight, replace those after the step of the distance.
	var last := LineDistanceTexts.Step.DISTANCE if is_compared or is_detected else step
	for added: PackedStringArray in _lines_by_step().slice(0, last + 1):
		found.append_array(added)
	if is_detected:
		found.append(tr("speed = {speed} px per frame"))
		found.append(tr("frame {frame}     {distance} − {frame}·{speed_value} = {flown}"))
		found.append(_line_of_test(model) + "     {is_red}")
	if is_compared:
		var has_answer := is_finite(model.distance_with_mistake())
		var none := "{wrong}: " + tr("a vertical line has no y at the ball's x")
		found.append(_wrong_line(model.mistake) if has_answer else none)
	return found


func _wrong_line(mistake: int) -> String:
	if mistake == LineDistanceMistakes.STRAIGHT_UP:
		return tr("{wrong}: y of the line − y of c = {wrong_distance}")
	return _WRONG_LINES[mistake]


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


# Whether the ball is red in the frame, as the test asks it.
func _line_of_test(model: LineDistanceModel) -> String:
	var distance := model.detection().distance_at(model.frame)
	var is_red := model.detection().is_red(model.frame)
	match model.rule:
		DiscreteDetection.Rule.ONLY_ABOVE:
			if distance < 0.0:
				return "{flown} < 0"
			return "0 ≤ {flown} < {radius}" if is_red else "{flown} ≥ {radius}"
		DiscreteDetection.Rule.BOTH_SIDES:
			return "|{flown}| < {radius}" if is_red else "|{flown}| ≥ {radius}"
	return "{flown} < {radius}" if is_red else "{flown} ≥ {radius}"


func _put_detection(model: LineDistanceModel, scale: float) -> void:
	var flown := model.detection().distance_at(model.frame)
	var title := tr("speed of the ball in pixels per frame")
	_formula.put_number("speed", model.speed, Palette.Role.INK, title)
	_formula.put_number("speed_value", model.speed, Palette.Role.INK)
	_formula.put_number("frame", model.frame, Palette.Role.INK)
	_formula.put_sum("flown", flown, scale + model.frame * model.speed, Palette.Role.PROJECTION)
	var is_red := model.detection().is_red(model.frame)
	var word := tr("red") if is_red else tr("not red")
	_formula.put_answer("is_red", word, Palette.Role.WRONG if is_red else Palette.Role.INK)


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
