class_name NormalsTexts
## The sentences and formula lines of the lesson on normals, step by step.

const _LINE_OF_N := "{n} = (−y, x) = {n_pair}     {v} · {n} = {check}"
const _LINE_OF_LENGTH := "|{n}| = √({n_x}² + {n_y}²) = {n_length}"
const _LINE_OF_UNIT := "{e} = {n} / |{n}| = {e_pair}"


## One sentence a step, translated.
static func sentences(model: NormalsModel) -> PackedStringArray:
	var turn := clockwise_text(model)
	return [
		_translate("A line has a direction: v = end − start. Drag its ends, or all of it."),
		_translate("The normal is (−y, x): v turned by +90°, %s on screen.") % turn,
		_translate("(y, −x) is the opposite normal. A line has two; code must stay with one."),
		_translate("Divide n by its length: the unit normal n̂ has length 1. Normal is not unit!"),
		_translate("1 pixel cannot be seen: a line's normal is drawn k times as long."),
	]


## The formula lines of all steps up to [param step], counted from 0; with a mistake switched on
## only those that it concerns, and its own.
static func lines(model: NormalsModel, step: int) -> PackedStringArray:
	if model.mistake != 0:
		return _mistake_lines(model.mistake)
	var groups: Array[PackedStringArray] = [
		[_line_of_v()],
		[_LINE_OF_N],
		["(y, −x) = {opposite_pair} = −{n}"],
		[_LINE_OF_LENGTH, _LINE_OF_UNIT],
		["{k} · {e} = {scaled_pair}"],
	]
	var found: PackedStringArray = []
	for i in step + 1:
		found.append_array(groups[i])
	return found


## Which way +90 degrees turns on the screen, in a word or two.
static func clockwise_text(model: NormalsModel) -> String:
	if model.is_y_up:
		return _translate("counter-clockwise")
	return _translate("clockwise")


## The mistakes that can be switched on.
static func mistakes() -> Array[MistakeInfo]:
	var script := "test_vec2_student_mistakes."
	return [
		MistakeInfo.new(
			NormalsMistakes.WRONG_NORMAL,
			_translate("signs and order"),
			_translate("(y, x) is no normal, (y, −x) the opposite."),
			script + "test_mistake_9_the_normal_with_the_wrong_sign_or_swapped"
		),
		MistakeInfo.new(
			NormalsMistakes.ZERO_VECTOR,
			_translate("zero vector"),
			_translate("0 / 0 is NaN. Zero must stay zero."),
			script + "test_mistake_6_a_zero_vector_normalized_to_nan"
		),
		MistakeInfo.new(
			NormalsMistakes.CUT_LENGTH,
			_translate("length cut to an integer"),
			_translate("int(0.5) is 0: short is taken for zero."),
			script + "test_mistake_7_the_length_cut_to_a_whole_number"
		),
	]


static func _mistake_lines(mistake: int) -> PackedStringArray:
	if mistake == NormalsMistakes.WRONG_NORMAL:
		var wrong := "{w1} = {w1_pair}     {v} · {w1} = {w1_check}"
		return [_line_of_v(), _LINE_OF_N, wrong, "{w2} = {w2_pair}"]
	var lines_of_unit: PackedStringArray = [_line_of_v(), _LINE_OF_LENGTH, _LINE_OF_UNIT]
	if mistake == NormalsMistakes.ZERO_VECTOR:
		lines_of_unit.append("{cross} {n} / |{n}| = {wrong_pair}")
	else:
		lines_of_unit.append("{cross} int(|{n}|) = {cut}  →  {wrong_pair}")
	return lines_of_unit


static func _line_of_v() -> String:
	return "{v} = ( {vx} , {vy} )   " + _translate("from") + " ( {sx} , {sy} )"


static func _translate(sentence: String) -> String:
	return TranslationServer.translate(sentence)
