class_name CollisionFrictionTexts
extends RefCounted
## The sentences and the verdict of the lesson on friction at a bounce.

# What is a smaller share of its terms is rounding.
const _ROUNDING := 1e-12


## One sentence a step, translated.
static func sentences(model: CollisionFrictionModel, contact: FrictionContact) -> PackedStringArray:
	return [
		_on_meet(model),
		_on_slip(contact),
		LabText.translate("Along n friction changes nothing: the push jn is that of every bounce."),
		_on_cone(contact),
		_on_after(contact),
		_on_ledger(contact),
		_on_flight(model),
	]


static func _on_meet(model: CollisionFrictionModel) -> String:
	if model.two_balls:
		return (
			LabText
			. translate(
				"Without friction two balls push each other straight apart, and no spin changes. Press Play."
			)
		)
	return (
		LabText
		. translate(
			"Without friction a bounce changes neither the speed along the line nor the spin. Press Play."
		)
	)


static func _on_slip(contact: FrictionContact) -> String:
	if _does_not_rub(contact):
		return LabText.translate("The rim is as fast as the flight: nothing rubs, the slip u is 0.")
	return LabText.translate(
		"The surfaces rub along each other with the slip u: the flight along t less the rim, r ω."
	)


static func _on_cone(contact: FrictionContact) -> String:
	if contact.friction == 0.0:
		return LabText.translate("Without friction the cone is a line: the impulse J is along n.")
	if _does_not_rub(contact):
		return LabText.translate("Nothing rubs, so J is along n, in the middle of the cone.")
	if contact.regime() == Friction.Regime.STICK:
		return (
			LabText
			. translate(
				"J is in the cone: a third of the slip is enough, and the surfaces stick. Drag its edge."
			)
		)
	return LabText.translate(
		"J is on the edge of the cone: friction is all of µ jn, and they slip on. Drag the edge."
	)


static func _on_after(contact: FrictionContact) -> String:
	if contact.friction == 0.0 or _does_not_rub(contact):
		return LabText.translate(
			"Nothing acts along t: neither the speed there nor a spin changes."
		)
	if contact.other:
		return LabText.translate(
			"Each ball takes half of J. Friction turns both the same way round."
		)
	return LabText.translate("J changes the flight, and its part jt turns the ball, too.")


static func _on_ledger(contact: FrictionContact) -> String:
	if not _loses_energy(contact):
		return LabText.translate("Nothing is lost here: energy and angular momentum L are kept.")
	if contact.other:
		return LabText.translate(
			"Friction moves angular momentum from the flight into both spins. The sum L is kept."
		)
	return LabText.translate(
		"About the contact no force has a lever: the angular momentum L of flight and spin is kept."
	)


static func _on_flight(model: CollisionFrictionModel) -> String:
	if model.two_balls or model.gravity == 0.0:
		return LabText.translate(
			"Press Play: the event world flies it. ε × condition is how far rounding may move it."
		)
	return LabText.translate(
		"Press Play: it hops, and friction acts at each touch, always with the same µ."
	)


## What is asked before the cone is shown, translated.
static func question_on_cone() -> String:
	return LabText.translate("Friction is at most µ jn. Can it end the slip?")


## The answers to [method question_on_cone], translated.
static func choices_on_cone() -> PackedStringArray:
	return [
		LabText.translate("the surfaces stick"),
		LabText.translate("the surfaces slip on"),
	]


## The right one of [method choices_on_cone], counted from 0; -1 where nothing rubs.
static func right_about_cone(contact: FrictionContact) -> int:
	if contact.friction == 0.0 or _does_not_rub(contact):
		return -1
	return 0 if contact.regime() == Friction.Regime.STICK else 1


## What is asked before the velocities after the contact are shown, translated.
static func question_on_velocity(model: CollisionFrictionModel) -> String:
	if model.two_balls:
		return (
			LabText
			. translate(
				"Where does the arrow of v₂′ end, drawn from ball 2? Drag the “?” there, then step forward."
			)
		)
	return (
		LabText
		. translate(
			"Where does the arrow of v′ end, drawn from the ball? Drag the “?” there, then step forward."
		)
	)


## What is asked before the ledger is shown, translated.
static func question_on_ledger() -> String:
	return LabText.translate("What is the same before and after this bounce?")


## The answers to [method question_on_ledger], translated.
static func choices_on_ledger() -> PackedStringArray:
	return [
		LabText.translate("the energy of flight and spin"),
		LabText.translate("the spin"),
		LabText.translate("the angular momentum about the contact"),
	]


## The right one of [method choices_on_ledger], counted from 0; -1 where more than one is.
static func right_about_ledger(contact: FrictionContact) -> int:
	if contact.friction == 0.0 or _does_not_rub(contact) or not _loses_energy(contact):
		return -1
	return 2


## Whether the mistake that is switched on is shown at [param step]: not before the right way.
static func is_compared(model: CollisionFrictionModel, step: int) -> bool:
	return model.mistake != 0 and step >= CollisionFrictionModel.Step.AFTER


## The step at which a mistake is compared, for who switches it on at [param step].
static func step_of_mistake(_mistake: int, step: int) -> int:
	return maxi(step, CollisionFrictionModel.Step.AFTER)


## What was found at [param step], in a few lines, translated. [param flight] is needed at the last
## step.
static func verdict(
	model: CollisionFrictionModel, contact: FrictionContact, flight: ContactFlight, step: int
) -> PackedStringArray:
	var words: PackedStringArray = [_regime_words(contact)]
	match step:
		CollisionFrictionModel.Step.CONE:
			if contact.friction > 0.0:
				words.append(LabText.translate("one µ, for sticking and slipping"))
		CollisionFrictionModel.Step.AFTER:
			words.append_array(_leaving_words(contact.after(), contact))
		CollisionFrictionModel.Step.LEDGER:
			words = [_energy_words(contact), _momentum_words(contact)]
		CollisionFrictionModel.Step.FLY:
			if model.gravity > 0.0 and not model.two_balls:
				words = [_touch_words(flight)]
			words.append(ShotText.of_right(flight.miss(), model.rounding(contact, flight)))
	if is_compared(model, step):
		words.append_array(_mistake_words(model, contact, step))
	return words


static func _regime_words(contact: FrictionContact) -> String:
	if contact.friction == 0.0:
		return LabText.translate("no friction")
	if contact.regime() == Friction.Regime.STICK:
		return LabText.translate("the surfaces stick")
	return LabText.translate("the surfaces slip on")


static func _leaving_words(balls: Array[Ball], contact: FrictionContact) -> PackedStringArray:
	if balls.size() == 1:
		return ["v′ = %s, ω′ = %s" % [pair(balls[0], contact), spin_text(balls[0], contact)]]
	var words: PackedStringArray = []
	for place: int in 2:
		var subscript: String = ["₁", "₂"][place]
		var numbers := [pair(balls[place], contact), spin_text(balls[place], contact)]
		words.append("v{0}′ = %s, ω{0}′ = %s".replace("{0}", subscript) % numbers)
	return words


static func _energy_words(contact: FrictionContact) -> String:
	var all := NumberText.short(FrictionContact.energy(contact.before()))
	if not _loses_energy(contact):
		return LabText.translate("E = %s, before and after") % all
	var lost := contact.lost_to_bounce() + contact.lost_to_friction()
	return LabText.translate("E: %s of %s is lost") % [NumberText.short(lost), all]


static func _momentum_words(contact: FrictionContact) -> String:
	var sentence := LabText.translate("L = %s, before and after")
	return sentence % momentum_text(contact.before(), contact)


# Not more than there is room for.
static func _touch_words(flight: ContactFlight) -> String:
	var words: PackedStringArray = []
	for regime: Friction.Regime in flight.regimes().slice(0, 3):
		if regime == Friction.Regime.STICK:
			words.append(LabText.translate("sticks"))
		else:
			words.append(LabText.translate("slips"))
	return LabText.translate("touches: %s") % ", ".join(words)


static func _mistake_words(
	model: CollisionFrictionModel, contact: FrictionContact, step: int
) -> PackedStringArray:
	if not model.shows_mistake():
		return [LabText.translate("the mistake changes nothing here")]
	var wrong := CollisionFrictionMistakes.balls_after(model.mistake, contact)
	if step == CollisionFrictionModel.Step.LEDGER:
		return [LabText.translate("the mistake makes L = %s") % momentum_text(wrong, contact)]
	var last := wrong[-1]
	var numbers := [pair(last, contact), spin_text(last, contact)]
	if contact.other:
		return [LabText.translate("the mistake: v₂′ = %s, ω₂′ = %s") % numbers]
	return [LabText.translate("the mistake: v′ = %s, ω′ = %s") % numbers]


## The velocity of [param ball] as a pair; what is only rounding beside the speeds of
## [param contact] is 0.
static func pair(ball: Ball, contact: FrictionContact) -> String:
	var least := _ROUNDING * contact.speed_scale()
	var x := 0.0 if absf(ball.velocity.x) < least else ball.velocity.x
	var y := 0.0 if absf(ball.velocity.y) < least else ball.velocity.y
	return NumberText.pair(x, y)


## The same for its spin.
static func spin_text(ball: Ball, contact: FrictionContact) -> String:
	var is_rounding := absf(ball.spin * ball.radius) < _ROUNDING * contact.speed_scale()
	return NumberText.short(0.0 if is_rounding else ball.spin)


## The angular momentum of [param balls] about the contact; what is only rounding is 0.
static func momentum_text(balls: Array[Ball], contact: FrictionContact) -> String:
	var momentum := FrictionContact.angular_momentum(balls)
	var is_rounding := absf(momentum) < _ROUNDING * contact.ball.radius * contact.speed_scale()
	return NumberText.short(0.0 if is_rounding else momentum)


static func _does_not_rub(contact: FrictionContact) -> bool:
	return absf(contact.slip()) <= _ROUNDING * contact.speed_scale()


static func _loses_energy(contact: FrictionContact) -> bool:
	var lost := contact.lost_to_bounce() + contact.lost_to_friction()
	return lost > _ROUNDING * FrictionContact.energy(contact.before())
