class_name LineEndsFormula
extends RefCounted
## The formula of the lesson on line ends: its lines, step by step, and what each name in them is.
##
## P is the ball's centre at the beginning of the frame, v its motion, r its radius. The line goes
## from A to B with the unit normal n̂. d goes from the end that is met to P.

const _GIVEN: PackedStringArray = [
	"P = ( {px} , {py} )   {v} = ( {vx} , {vy} )   r = {r}",
	"A = ( {ax} , {ay} )   B = ( {bx} , {by} )",
]
const _BLUE := Palette.Role.PROJECTION

var _formula: Formula
# The ball overlaps the line from the start: t is below 0, and the start of the frame counts.
var _starts_at_once := false


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of [param step] with the numbers of [param model].
func show_model(model: LineEndsModel, step: int) -> void:
	_put_given(model)
	_put_line(model, step)
	_put_equation(model)
	_put_bounce(model)
	_formula.put_symbol("t", "t₁" if step >= LineEndsTexts.Step.CAP else "t", _BLUE)
	if step < LineEndsTexts.Step.CAP:
		_formula.show_lines(_GIVEN + _lines_on_line(model, step))
	else:
		_formula.show_lines(_GIVEN + _lines_on_cap(model, step))


func _put_given(model: LineEndsModel) -> void:
	_formula.put_symbol("v", "v", Palette.Role.A)
	_formula.put_number("px", model.start.x, Palette.Role.INK, tr("x of the ball's centre"))
	_formula.put_number("py", model.start.y, Palette.Role.INK, tr("y of the ball's centre"))
	_formula.put_number("vx", model.motion.x, Palette.Role.A, tr("x of v"))
	_formula.put_number("vy", model.motion.y, Palette.Role.A, tr("y of v"))
	_formula.put_number("r", model.radius, Palette.Role.INK, tr("radius"))
	_formula.put_number("ax", model.segment.start.x, Palette.Role.INK, tr("x of A"))
	_formula.put_number("ay", model.segment.start.y, Palette.Role.INK, tr("y of A"))
	_formula.put_number("bx", model.segment.end.x, Palette.Role.INK, tr("x of B"))
	_formula.put_number("by", model.segment.end.y, Palette.Role.INK, tr("y of B"))


func _put_line(model: LineEndsModel, step: int) -> void:
	var is_one_sided := step == LineEndsTexts.Step.ONE_SIDE
	var normal := model.segment.normal() if is_one_sided else model.facing_normal()
	var signed := LineDistance.signed_distance(model.start, model.segment)
	var approach := -model.motion.dot(normal)
	_formula.put_symbol("n", "n̂", Palette.Role.UNIT)
	_formula.put_vector("n_pair", normal, Palette.Role.UNIT)
	var scale := 4.0 * (model.start.length() + model.segment.start.length())
	_formula.put_sum("signed", signed, scale, Palette.Role.INK)
	_formula.put_sum("distance", absf(signed), scale, Palette.Role.INK)
	_formula.put_number("approach", approach, Palette.Role.INK)
	_formula.put_number("radius", model.radius, Palette.Role.INK)
	if approach > 0.0:
		var fraction := PointOfImpact.fraction(absf(signed), absf(signed) - approach, model.radius)
		var point := model.start.plus(model.motion.scaled(maxf(fraction, 0.0)))
		_formula.put_number("line_fraction", fraction, _BLUE)
		_formula.put_vector("line_point", point, _BLUE)
		# Of a difference of places, as d below.
		var scale_of_s := (scale + 4.0 * model.motion.length()) / model.segment.length()
		_formula.put_sum("s", model.segment.share_of(point), scale_of_s, Palette.Role.INK)
		_starts_at_once = fraction < 0.0


func _put_equation(model: LineEndsModel) -> void:
	var equation := model.cap_equation()
	_formula.put_symbol("end", LineEndsTexts.end_name(model), Palette.Role.INK)
	_formula.put_symbol("d", "d", Palette.Role.B)
	_formula.put_symbol("u", "t₂", Palette.Role.REST)
	# d is a difference of places: what rounding leaves of it grows with both.
	var scale := 4.0 * (model.start.length() + model.cap_point().length())
	var scales := Vec2.new(scale, scale)
	_formula.put_vector_sum("d_pair", equation.difference, scales, Palette.Role.B)
	_formula.put_sum("d_length", equation.difference.length(), scale, Palette.Role.B)
	_formula.put_number("d_squared", equation.difference.length_squared(), Palette.Role.INK)
	_formula.put_number("r_squared", model.radius * model.radius, Palette.Role.INK)
	_formula.put_number("a", equation.a, Palette.Role.INK)
	var scale_of_b := 0.5 * scale * equation.motion.length()
	_formula.put_sum("b", equation.b, scale_of_b, Palette.Role.INK)
	_formula.put_number("c", equation.c, Palette.Role.INK)
	_formula.put_number("discriminant", equation.discriminant(), Palette.Role.INK)
	_formula.put_number("minus_b", -equation.b, Palette.Role.INK)
	_formula.put_number("two_a", 2.0 * equation.a, Palette.Role.INK)
	if equation.has_roots():
		_formula.put_number("root", sqrt(equation.discriminant()), Palette.Role.INK)
		_formula.put_number("first", equation.first_root(), _BLUE)
		_formula.put_number("second", equation.second_root(), Palette.Role.REST)


func _put_bounce(model: LineEndsModel) -> void:
	var impact := model.impact_in(LineEndsModel.Field.ROUND_CAPS)
	if impact.hit:
		_formula.put_vector("cap_normal", impact.normal, Palette.Role.UNIT)
		var after := model.motion.reflected(impact.normal)
		var scale := 4.0 * model.motion.length()
		_formula.put_vector_sum("after", after, Vec2.new(scale, scale), Palette.Role.A)


func _lines_on_line(model: LineEndsModel, step: int) -> PackedStringArray:
	if step == LineEndsTexts.Step.ONE_SIDE:
		return ["{n} = {n_pair}     (P − A) · {n} = {signed}"]
	var found: PackedStringArray = ["{n} = {n_pair}     (P − A) · {n} = {distance}"]
	var approach := -model.motion.dot(model.facing_normal())
	if approach == 0.0:
		found.append("{v} · {n} = 0: " + tr("along the line, no time of impact"))
	elif approach < 0.0:
		found.append("−{v} · {n} = {approach}: " + tr("it moves away, no impact"))
	else:
		var overlap := "     " + tr("overlap: t = 0") if _starts_at_once else ""
		found.append("{t} = ({distance} − {radius}) / {approach} = {line_fraction}" + overlap)
		if step == LineEndsTexts.Step.SEGMENT:
			found.append(
				("F = P + 0 {v}" if _starts_at_once else "F = P + {t} {v}") + " = {line_point}"
			)
			found.append("s = (F − A) · (B − A) / |B − A|² = {s}")
	return found


func _lines_on_cap(model: LineEndsModel, step: int) -> PackedStringArray:
	var found: PackedStringArray = ["{d} = P − {end} = {d_pair}     |{d}| = {d_length}"]
	if step in [LineEndsTexts.Step.QUADRATIC, LineEndsTexts.Step.ROOTS]:
		found.append("a = {v} · {v} = {a}     b = 2 {d} · {v} = {b}")
		found.append("c = {d} · {d} − r² = {d_squared} − {r_squared} = {c}")
	if step == LineEndsTexts.Step.ROOTS:
		found.append("D = b² − 4 a c = {b}² − 4·{a}·{c} = {discriminant}")
		found.append_array(_lines_on_roots(model))
	if step == LineEndsTexts.Step.BOUNCE and model.bounces_on_the_end():
		found.append_array(_lines_on_bounce(model))
	return found


# A ball that overlaps the end touches it where it starts, at whatever distance.
func _lines_on_bounce(model: LineEndsModel) -> PackedStringArray:
	if model.impact_in(LineEndsModel.Field.ROUND_CAPS).fraction == 0.0:
		# With its centre on the end, only rounding gives d a direction.
		var size := model.start.length() + model.cap_point().length()
		if model.start.distance_to(model.cap_point()) <= 1e-12 * size:
			return []
		return ["{n} = {d} / |{d}| = {cap_normal}", "{v} − 2 ({v} · {n}) {n} = {after}"]
	return [
		"{t} = {first}",
		"{n} = (P + {t} {v} − {end}) / r = {cap_normal}",
		"{v} − 2 ({v} · {n}) {n} = {after}"
	]


func _lines_on_roots(model: LineEndsModel) -> PackedStringArray:
	var equation := model.cap_equation()
	if equation.a == 0.0:
		return [tr("a = 0: the ball does not move. Do not divide by a.")]
	if not equation.has_roots():
		return [tr("D < 0: no root. This end is not touched.")]
	return [
		"t = (−b ± √D) / (2 a)",
		"{t} = ({minus_b} − {root}) / {two_a} = {first}",
		"{u} = ({minus_b} + {root}) / {two_a} = {second}     " + _verdict(model, equation),
	]


# Which of the two roots counts, in a few words.
func _verdict(model: LineEndsModel, equation: CapEquation) -> String:
	if model.result_in(LineEndsModel.Field.ROUND_CAPS) == LineEndsModel.Result.BOUNCES:
		return tr("the line is met first")
	if equation.b >= 0.0:
		return tr("moving away: none")
	if equation.discriminant() == 0.0:
		return tr("it only grazes: none")
	if equation.c <= 0.0:
		return tr("overlap: t = 0")
	if equation.first_root() > 1.0:
		return tr("t₁ > 1: none")
	# A ball that overlaps the line and moves away from it does not touch the end either.
	return tr("t₁ counts") if model.bounces_on_the_end() else tr("moving away: none")
