class_name MovingPlatformsTexts
extends RefCounted
## The sentences and the verdict of the lesson on surfaces that move.


## The surfaces that move, translated, in the order of [enum MovingSurface.Kind].
static func kinds() -> PackedStringArray:
	return [
		LabText.translate("a wall"),
		LabText.translate("a belt"),
		LabText.translate("a platform"),
		LabText.translate("a paddle that turns"),
		LabText.translate("a press"),
	]


## One sentence a step, translated.
static func sentences(model: MovingPlatformsModel) -> PackedStringArray:
	match model.kind:
		MovingSurface.Kind.BELT:
			return _on_belt(model)
		MovingSurface.Kind.PLATFORM:
			return _on_platform(model)
		MovingSurface.Kind.PRESS:
			return _on_press()
	if not model.impact().hit:
		var sentence := LabText.translate(
			"Within %s s they do not meet. Drag the ball or a velocity so that they do."
		)
		sentence = sentence % NumberText.short(SurfaceImpact.LONGEST)
		return [sentence, sentence, sentence, sentence, sentence]
	return _on_impact(model)


static func _on_impact(model: MovingPlatformsModel) -> PackedStringArray:
	var is_paddle := model.kind == MovingSurface.Kind.PADDLE
	return [
		(
			LabText.translate(
				"The paddle turns with ω. Which of its points tells how fast it hits? Press Play."
			)
			if is_paddle
			else LabText.translate(
				"The wall comes, too. How fast does the ball leave? Drag the heads of v and w."
			)
		),
		(
			(
				LabText
				. translate(
					"The touched point moves across its arm r, with w. From there the ball comes with U."
				)
			)
			if is_paddle
			else LabText.translate(
				"Seen from the wall, the wall rests and the ball comes with U = v − w."
			)
		),
		LabText.translate(
			"There the law is that of a wall at rest: what U has along n turns round, times C."
		),
		LabText.translate("Seen from the lab again, w is added: v′ = U′ + w."),
		_on_flight(model),
	]


static func _on_belt(model: MovingPlatformsModel) -> PackedStringArray:
	var run := model.run()
	var is_level := run.pull() == 0.0
	var back := ""
	match run.run_case:
		CarriedRun.Case.ROLLS:
			back = LabText.translate("Nothing slips, and it rolls at once.")
		CarriedRun.Case.ROLLS_LATER when is_level:
			back = LabText.translate(
				"A third of u goes into the flight, two thirds into the spin. Then it rolls."
			)
		CarriedRun.Case.ROLLS_LATER:
			back = (
				LabText
				. translate(
					"When u is 0, it rolls. Then G moves it as on a slope at rest: no belt holds a disc."
				)
			)
		CarriedRun.Case.ENDS_BEFORE:
			back = LabText.translate("The belt ends before u is 0: it still slips there.")
		CarriedRun.Case.SLIPS:
			back = LabText.translate("Friction is too weak to end the slip: it never rolls.")
	return [
		LabText.translate(
			"A disc that does not turn is put on the belt. How fast is it in the end? Press Play."
		),
		LabText.translate("Seen from the belt, the disc's lowest point slips with u = v − s."),
		_on_friction(model),
		back,
		_on_flight(model),
	]


static func _on_friction(model: MovingPlatformsModel) -> String:
	if model.friction == 0.0:
		return LabText.translate("Here µ is 0: nothing moves or turns the disc.")
	if model.run().slip == 0.0:
		return LabText.translate("Nothing slips, so there is no friction that would end it.")
	return LabText.translate(
		"Friction f = µ N works against u and turns the disc: of u it takes 3 f each second."
	)


static func _on_platform(model: MovingPlatformsModel) -> PackedStringArray:
	var back := LabText.translate(
		"It keeps a third of V and rolls on, while the platform goes back."
	)
	match model.run().run_case:
		CarriedRun.Case.ENDS_BEFORE:
			back = LabText.translate("It comes to the end of the platform before u is 0.")
		CarriedRun.Case.SLIPS:
			back = LabText.translate("Without friction it keeps V.")
	return [
		LabText.translate(
			"The disc lies on the platform and goes with it. What does it do when that turns back?"
		),
		LabText.translate(
			"The platform has −V at once, the disc still V. So it slips with u = V − (−V) = 2 V."
		),
		_on_friction(model),
		back,
		_on_flight(model),
	]


static func _on_press() -> PackedStringArray:
	return [
		LabText.translate(
			"The ball bounces between two walls, and one comes nearer. What becomes of it?"
		),
		LabText.translate("Seen from the wall that moves, the ball comes with U = u₀ + V."),
		LabText.translate(
			"It leaves that wall with U. Seen from the lab, that is U + V = u₀ + 2 V."
		),
		(
			LabText
			. translate(
				"Each such bounce adds 2 V. The way h that is free shrinks, and h (u − V) stays the same."
			)
		),
		(
			LabText
			. translate(
				"Without end the bounces come faster, until h₀ / V. The crushed ball keeps its last state."
			)
		),
	]


static func _on_flight(model: MovingPlatformsModel) -> String:
	if model.mistake_shows():
		return LabText.translate("Flown in the event world. What the mistake does is red.")
	return LabText.translate("Flown in the event world, it comes to where the formulas have it.")


## What is asked before the law is shown, translated; "" for the kinds without a question.
static func question(model: MovingPlatformsModel) -> String:
	match model.kind:
		MovingSurface.Kind.BELT:
			return LabText.translate("The disc is put on at rest. How fast is it when it rolls?")
		MovingSurface.Kind.PLATFORM:
			return LabText.translate("The platform turns back at once. What does the disc do?")
		MovingSurface.Kind.PRESS:
			return LabText.translate("How often does the ball bounce before it is crushed?")
	return ""


## The answers to [method question], translated.
static func choices(model: MovingPlatformsModel) -> PackedStringArray:
	match model.kind:
		MovingSurface.Kind.BELT:
			return [
				LabText.translate("as fast as the belt"),
				LabText.translate("two thirds as fast"),
				LabText.translate("a third as fast"),
			]
		MovingSurface.Kind.PLATFORM:
			return [
				LabText.translate("it turns back, too"),
				LabText.translate("it stops"),
				LabText.translate("it goes on, more slowly"),
			]
		MovingSurface.Kind.PRESS:
			return [
				LabText.translate("that depends on u₀"),
				LabText.translate("that depends on V"),
				LabText.translate("without end"),
			]
	return []


## The right one of [method choices], counted from 0; below 0 where there is nothing to ask.
static func right_choice(model: MovingPlatformsModel) -> int:
	if model.kind == MovingSurface.Kind.PRESS:
		return 2
	if not model.is_carried() or model.run().run_case != CarriedRun.Case.ROLLS_LATER:
		return -1
	if model.kind == MovingSurface.Kind.PLATFORM:
		return 2
	return 2 if model.speed == 0.0 and model.run().pull() == 0.0 else -1


## What is asked before v′ is shown, translated.
static func question_on_velocity() -> String:
	return LabText.translate(
		"Where does the arrow of v′ end, drawn from the ball at the impact? Drag the “?” there."
	)


## The step at which a mistake is compared, for who switches it on at [param step].
static func step_of_mistake(_mistake: int, step: int) -> int:
	return maxi(step, MovingPlatformsModel.Step.BACK)


## Two or three lines for the card on the board, translated.
static func verdict(
	model: MovingPlatformsModel, flight: PlatformFlight, step: MovingPlatformsModel.Step
) -> PackedStringArray:
	var words: PackedStringArray = []
	if step == MovingPlatformsModel.Step.FLY:
		words = _on_end(model, flight)
	else:
		words = _on_answer(model)
	if model.mistake != 0:
		words.append(_on_mistake(model))
	return words


## The sign that the card carries: 0 where nothing meets; a cross where a mistake says otherwise.
static func verdict_sign(model: MovingPlatformsModel) -> String:
	if model.mistake_shows():
		return "✗"
	return "0" if model.is_impact() and not model.impact().hit else "!"


static func _on_answer(model: MovingPlatformsModel) -> PackedStringArray:
	if model.is_carried():
		return _on_rolling(model)
	if model.kind == MovingSurface.Kind.PRESS:
		var speed := Press.speed_after(
			MovingPlatformsModel.PRESS_BOUNCE, model.speed, model.surface_speed
		)
		var way := Press.way_after(
			MovingPlatformsModel.PRESS_BOUNCE, model.way, model.speed, model.surface_speed
		)
		return [
			LabText.translate("after 3 bounces off it: %s px/s") % NumberText.short(speed),
			LabText.translate("way left then: %s px") % NumberText.short(way),
		]
	if not model.impact().hit:
		return [_on_no_impact()]
	return [
		LabText.translate("they meet after %s s") % NumberText.short(model.impact().time),
		"v′ = %s" % pair(model.impact().leaving, _size(model)),
	]


static func _on_rolling(model: MovingPlatformsModel) -> PackedStringArray:
	var run := model.run()
	var words: PackedStringArray = []
	if model.kind == MovingSurface.Kind.PLATFORM:
		words.append(LabText.translate("carried for %s s") % NumberText.short(model.turn_time()))
	match run.run_case:
		CarriedRun.Case.ROLLS:
			words.append(LabText.translate("it rolls at once"))
		CarriedRun.Case.ROLLS_LATER:
			words.append(LabText.translate("it slips for %s s") % NumberText.short(run.roll_time))
			words.append(LabText.translate("then it rolls with %s px/s") % speed_text(model))
		CarriedRun.Case.ENDS_BEFORE:
			words.append(LabText.translate("it comes to an end before it rolls"))
		CarriedRun.Case.SLIPS:
			words.append(LabText.translate("it slips all the way"))
	return words


## v′ on a belt or platform; what is only rounding beside the speeds of which it is the difference
## is 0.
static func speed_text(model: MovingPlatformsModel) -> String:
	var rolling := model.rolling_speed()
	var size := absf(model.speed) + absf(model.surface_speed) + absf(model.run().slip)
	return NumberText.short(0.0 if absf(rolling) < 1e-13 * size else rolling)


static func _on_no_impact() -> String:
	return LabText.translate("no impact within %s s") % NumberText.short(SurfaceImpact.LONGEST)


static func _on_end(model: MovingPlatformsModel, flight: PlatformFlight) -> PackedStringArray:
	if model.is_impact() and not model.impact().hit:
		return [_on_no_impact()]
	var words: PackedStringArray = []
	if model.kind == MovingSurface.Kind.PRESS:
		words.append(LabText.translate("crushed after %s s") % NumberText.short(model.crush_time()))
	words.append(ShotText.of_right(flight.miss(), flight.rounding()))
	return words


static func _on_mistake(model: MovingPlatformsModel) -> String:
	if not model.mistake_shows():
		return LabText.translate("the mistake changes nothing here")
	if model.mistake == MovingPlatformsMistakes.FRAME_LATE:
		var behind := model.surface_speed * MovingPlatformsMistakes.FRAME
		return LabText.translate("the mistake: %s px behind") % NumberText.short(behind)
	if model.is_impact():
		return (
			LabText.translate("the mistake: v′ = %s") % pair(model.wrong_velocity(), _size(model))
		)
	return LabText.translate("the mistake: %s px/s") % NumberText.short(model.wrong_speed())


static func _size(model: MovingPlatformsModel) -> float:
	return model.impact().coming.length() + 2.0 * model.impact().touched.length()


## A pair of numbers; what is only rounding beside terms of [param size] is 0.
static func pair(vector: Vec2, size: float) -> String:
	var shown := cleaned(vector, size)
	return NumberText.pair(shown.x, shown.y)


## The same vector, in which what is only rounding beside terms of [param size] is 0.
static func cleaned(vector: Vec2, size: float) -> Vec2:
	var least := 1e-13 * size
	var x := 0.0 if absf(vector.x) < least else vector.x
	var y := 0.0 if absf(vector.y) < least else vector.y
	return Vec2.new(x, y)
