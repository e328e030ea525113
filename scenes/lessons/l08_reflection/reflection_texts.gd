class_name ReflectionTexts
extends RefCounted
## The sentences and formula lines of the lesson on reflection, step by step.


## One sentence a step, translated.
static func sentences(model: ReflectionModel) -> PackedStringArray:
	if model.refusal():
		var refusals: PackedStringArray = []
		refusals.resize(ReflectionModel.Step.size())
		refusals.fill(
			_translate("n is not of length 1: reflect refuses it, and v stays as it was.")
		)
		return refusals
	return [
		_translate("A ball with velocity v meets a line with the unit normal n."),
		_translate("Along n, v has the part (v · n) n: the shadow of v on n."),
		_translate("Subtract it once: nothing goes into the line. The ball slides."),
		_translate("Subtract it twice: the law of reflection. Both angles are equal."),
		_translate("Subtract it (1 + C) times: C says how much of it comes back."),
	]


## The formula lines at [param step].
static func lines(model: ReflectionModel, step: ReflectionModel.Step) -> PackedStringArray:
	var found: PackedStringArray = [
		"{v} = ( {vx} , {vy} )     %s = ( {lx} , {ly} )" % _translate("line"), _normal_line(model)
	]
	if model.refusal():
		found.append(_translate("|{n}| is not 1: refused. {v} stays {v_pair}"))
		return found
	if step >= ReflectionModel.Step.SPLIT:
		found.append("{v} · {n} = {v_x}·{n_x} + {v_y}·{n_y} = {dot}")
		found.append("({v} · {n}) {n} = {part}")
	if step >= ReflectionModel.Step.SLIDE:
		found.append("{v} − ({v} · {n}) {n} = {v_pair} − {part} = {slide}")
	if step == ReflectionModel.Step.MIRROR:
		found.append("{v} − 2 ({v} · {n}) {n} = {mirror}")
	if step == ReflectionModel.Step.BOUNCE:
		found.append("{v} − (1 + C)({v} · {n}) {n} = {out}")
	return found


## Two lines for the card on the board: the angles to the normal, and what is left of the energy.
static func verdict(model: ReflectionModel, step: ReflectionModel.Step) -> PackedStringArray:
	var leaving := model.velocity_after(model.times_subtracted(step))
	if step < ReflectionModel.Step.SLIDE:
		var angle := NumberText.short(model.angle_in_degrees())
		return [
			_translate("comes in at %s° to the normal") % angle,
			_translate("nothing subtracted: it flies through"),
		]
	var energy := _translate("keeps %s %% of its energy")
	return [
		_angles(model, leaving),
		energy % NumberText.short(model.energy_share(leaving) * 100.0, 3),
	]


## The sign that the card carries: whether the angles are equal.
static func verdict_sign(model: ReflectionModel, step: ReflectionModel.Step) -> String:
	if step < ReflectionModel.Step.SLIDE:
		return "→"
	return "=" if model.has_equal_angles(model.times_subtracted(step)) else "≠"


static func _angles(model: ReflectionModel, leaving: Vec2) -> String:
	var angle_in := NumberText.short(model.angle_in_degrees())
	if leaving.length() == 0.0:
		return _translate("in %s° to the normal, and it stops") % angle_in
	var angle_out := NumberText.short(model.angle_out_degrees(leaving))
	return _translate("in %s°, out %s° to the normal") % [angle_in, angle_out]


static func _normal_line(model: ReflectionModel) -> String:
	if model.has_unit_normal:
		return "{n} = {n_pair}     C = {C}"
	return "{n} = {n_pair}     |{n}| = {n_length}     C = {C}"


static func _translate(sentence: String) -> String:
	return TranslationServer.translate(sentence)
