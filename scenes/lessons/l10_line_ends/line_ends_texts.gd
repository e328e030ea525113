class_name LineEndsTexts
## The sentences and formula lines of the lesson on line ends, step by step.

## The steps in order.
enum Step { ONE_SIDE, TWO_SIDES, SEGMENT, CAP, QUADRATIC, ROOTS, BOUNCE }


## One sentence a step, translated.
static func sentences() -> PackedStringArray:
	return [
		_translate("So far: an infinite line with one good side. From behind, balls pass."),
		_translate("Turn n to the ball's side, and both sides work. Still infinite."),
		_translate("With ends: the foot of the ball at impact lies between them, 0 ≤ s ≤ 1."),
		_translate("Round caps: the ball touches an end when its centre is r away."),
		_translate("|d + t v| = r, squared, is a quadratic: a t² + b t + c = 0."),
		_translate("D < 0: no touch. Else t₁ is the first touch; it counts if in 0..1."),
		_translate("n points from the end to the centre. Reflect v on it as ever."),
	]


## The formula lines of [param step] for the shot of [param model].
static func lines(model: LineEndsModel, step: int) -> PackedStringArray:
	var found: PackedStringArray = [
		"P = ( {px} , {py} )   {v} = ( {vx} , {vy} )   r = {r}",
		"A = ( {ax} , {ay} )   B = ( {bx} , {by} )",
	]
	if step < Step.CAP:
		_add_lines_of_line(found, model, step)
	else:
		_add_lines_of_cap(found, model, step)
	return found


## The name of the end that the quadratic is about.
static func end_name(model: LineEndsModel) -> String:
	return "A" if model.nearest_cap() == Impact.Feature.START else "B"


static func _add_lines_of_line(found: PackedStringArray, model: LineEndsModel, step: int) -> void:
	if step == Step.ONE_SIDE:
		found.append("{n} = {n_pair}     (P − A) · {n} = {signed}")
		return
	found.append("{n} = {n_pair}     (P − A) · {n} = {distance}")
	if model.motion.dot(model.facing_normal()) == 0.0:
		found.append("{v} · {n} = 0: " + _translate("along the line, no time of impact"))
		return
	found.append("{t} = ({distance} − {radius}) / {approach} = {line_fraction}")
	if step == Step.SEGMENT:
		found.append("F = P + {t} {v} = {line_point}")
		found.append("s = (F − A) · (B − A) / |B − A|² = {s}")


static func _add_lines_of_cap(found: PackedStringArray, model: LineEndsModel, step: int) -> void:
	if step < Step.BOUNCE:
		found.append("{d} = P − {end} = {d_pair}     |{d}| = {d_length}")
	if step == Step.QUADRATIC or step == Step.ROOTS:
		found.append("a = {v} · {v} = {a}     b = 2 {d} · {v} = {b}")
	if step == Step.QUADRATIC:
		found.append("c = {d} · {d} − r² = {d_squared} − {r_squared} = {c}")
	if step >= Step.ROOTS:
		found.append("c = {d} · {d} − r² = {c}     D = b² − 4ac = {discriminant}")
		found.append_array(_lines_of_roots(model))
	if step == Step.BOUNCE and model.result_in(LineEndsModel.Field.ROUND_CAPS) == _on_the_end():
		found.append("{n} = (P + {t} {v} − {end}) / r = {cap_normal}")
		found.append("{v} − 2 ({v} · {n}) {n} = {after}")


static func _lines_of_roots(model: LineEndsModel) -> PackedStringArray:
	var equation := model.cap_equation()
	if equation.a == 0.0:
		return [_translate("a = 0: the ball does not move. Do not divide by a.")]
	if not equation.has_roots():
		return [_translate("D < 0: no root. This end is not touched.")]
	return [
		"{t} = (−b − √D) / 2a = ({minus_b} − {root}) / {two_a} = {first}",
		"{u} = (−b + √D) / 2a = {second}     " + _verdict(model, equation),
	]


# Which of both times counts, in a few words.
static func _verdict(model: LineEndsModel, equation: CapEquation) -> String:
	if model.result_in(LineEndsModel.Field.ROUND_CAPS) == LineEndsModel.Result.BOUNCES:
		return _translate("the line is met first")
	if equation.b >= 0.0:
		return _translate("moving away: none")
	if equation.c <= 0.0:
		return _translate("overlap: t = 0")
	return _translate("t₁ counts") if equation.first_root() <= 1.0 else _translate("t₁ > 1: none")


static func _on_the_end() -> LineEndsModel.Result:
	return LineEndsModel.Result.BOUNCES_ON_THE_END


static func _translate(sentence: String) -> String:
	return TranslationServer.translate(sentence)
