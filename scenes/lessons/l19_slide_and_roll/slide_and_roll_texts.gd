class_name SlideAndRollTexts
extends RefCounted
## The sentences and the verdict of the lesson on sliding and rolling.


## One sentence a step, translated.
static func sentences(model: SlideAndRollModel, race: BallRace) -> PackedStringArray:
	return [
		_on_slide(model, race),
		_on_pull(model),
		_on_slip(model, race),
		_on_mark(model),
		_on_roll(model, race),
		_on_race(race),
		_on_error(race),
	]


static func _on_slide(model: SlideAndRollModel, race: BallRace) -> String:
	if race.run_case == SlideAndRollModel.Case.RESTS:
		return LabText.translate("Nothing moves the ball. Make the line steeper, or push it: v₀.")
	if model.height() == 0.0:
		return LabText.translate("Without friction the ball keeps its speed and does not turn.")
	return LabText.translate("Without friction the ball slides down and does not turn. Press Play.")


static func _on_pull(model: SlideAndRollModel) -> String:
	if model.height() == 0.0:
		return LabText.translate(
			"The line is level: gravity presses with N and does not pull, G = 0."
		)
	return LabText.translate("Gravity pulls along the line with G and presses on it with N.")


static func _on_slip(model: SlideAndRollModel, race: BallRace) -> String:
	if model.friction == 0.0:
		return LabText.translate("Here µ is 0: there is no friction, and nothing turns the ball.")
	if race.run_case == SlideAndRollModel.Case.RESTS:
		return LabText.translate("Nothing slips, so there is no friction either.")
	return LabText.translate(
		"Friction f brakes the ball and turns it. Of the slip it takes 3 f, and f is at most µ N."
	)


static func _on_mark(model: SlideAndRollModel) -> String:
	if model.height() == 0.0:
		return LabText.translate(
			"On the level tan is 0: with any friction the ball rolls in the end."
		)
	return LabText.translate(
		"It can roll if 3 µ N is at least G: from µ = tan / 3 on. Drag µ across the mark."
	)


static func _on_roll(model: SlideAndRollModel, race: BallRace) -> String:
	match race.run_case:
		SlideAndRollModel.Case.RESTS:
			return LabText.translate("Nothing moves the ball: it stays where it is.")
		SlideAndRollModel.Case.ROLLS:
			return LabText.translate(
				"It rolls. A third of G turns the ball, so two thirds of G move it."
			)
		SlideAndRollModel.Case.ROLLS_LATER:
			return LabText.translate("It slips until t₁. Then the slip is 0, and it rolls.")
		SlideAndRollModel.Case.ENDS_BEFORE:
			return LabText.translate("It slips, and the line ends before the slip is 0.")
	if model.friction == 0.0:
		return LabText.translate("Without friction it slips on and does not turn.")
	return LabText.translate("Friction is too weak: it slips on, and turns too slowly to roll.")


static func _on_race(race: BallRace) -> String:
	if race.run_case == SlideAndRollModel.Case.RESTS:
		return LabText.translate("Nobody wins this race: nothing moves.")
	return LabText.translate(
		"Three balls race: without friction, with µ, and one that rolls from the start. Press Play."
	)


static func _on_error(race: BallRace) -> String:
	match race.run_case:
		SlideAndRollModel.Case.RESTS:
			return LabText.translate("Nothing moves, so there is nothing to measure.")
		SlideAndRollModel.Case.ROLLS, SlideAndRollModel.Case.ROLLS_LATER:
			return (
				LabText
				. translate(
					"The formula is off by rounding only. In frames the slip never ends: the ball trembles."
				)
			)
	return LabText.translate(
		"The formula is off by rounding only. In frames the end is seen with the next frame."
	)


## What is asked before the mark is shown, translated.
static func question_on_mark() -> String:
	return LabText.translate("From which µ on can the ball roll on this slope?")


## The answers to [method question_on_mark], translated.
static func choices() -> PackedStringArray:
	return [
		LabText.translate("from µ = tan on"),
		LabText.translate("from µ = tan / 2 on"),
		LabText.translate("from µ = tan / 3 on")
	]


## The right one of [method choices], counted from 0; -1 on a level line.
static func right_choice(model: SlideAndRollModel) -> int:
	return 2 if model.height() > 0.0 else -1


## What is asked before the race, translated.
static func question_on_race() -> String:
	return LabText.translate(
		"Where is your ball when the one without friction is at the end? Drag the “?”."
	)


## Whether the mistake that is switched on is shown at [param step].
static func is_compared(model: SlideAndRollModel, step: int) -> bool:
	return model.mistake != 0 and step >= SlideAndRollModel.Step.ROLL


## The step at which a mistake is compared, for who switches it on at [param step]: in the race.
static func step_of_mistake(_mistake: int, step: int) -> int:
	return step if step >= SlideAndRollModel.Step.ROLL else SlideAndRollModel.Step.RACE


## What was found at [param step], in a few lines, translated.
static func verdict(model: SlideAndRollModel, race: BallRace, step: int) -> PackedStringArray:
	var words: PackedStringArray = [_case_words(race)]
	if step >= SlideAndRollModel.Step.RACE:
		words.append(_end_words(race))
	if is_compared(model, step):
		words.append(_mistake_words(model, race))
	return words


static func _case_words(race: BallRace) -> String:
	match race.run_case:
		SlideAndRollModel.Case.RESTS:
			return LabText.translate("nothing moves")
		SlideAndRollModel.Case.ROLLS:
			return LabText.translate("it rolls at once")
		SlideAndRollModel.Case.ROLLS_LATER:
			var sentence := LabText.translate("it rolls after %s s")
			return sentence % NumberText.short(race.ball.roll_time)
		SlideAndRollModel.Case.ENDS_BEFORE:
			return LabText.translate("the line ends before it rolls")
	return LabText.translate("it slips all the way")


static func _end_words(race: BallRace) -> String:
	if not race.arrives():
		return LabText.translate("it does not come to the end")
	return LabText.translate("at the end after %s s") % NumberText.short(race.ball.end_time)


static func _mistake_words(model: SlideAndRollModel, race: BallRace) -> String:
	if not race.arrives() or not model.shows_mistake():
		return LabText.translate("the mistake changes nothing here")
	if race.wrong.stops() and race.wrong.time_to(model.segment().length()) == INF:
		var stops := LabText.translate("the mistake: it stops after %s s")
		return stops % NumberText.short(race.wrong.change)
	var lead := race.lead_of_wrong()
	var sentence := LabText.translate("the mistake: %s px ahead")
	if lead < 0.0:
		sentence = LabText.translate("the mistake: %s px behind")
	return sentence % NumberText.short(absf(lead), 3)
