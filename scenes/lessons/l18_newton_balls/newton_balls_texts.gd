class_name NewtonBallsTexts
extends RefCounted
## The sentences and the verdict of the lesson on balls that meet.

# Energy that is lost by rounding alone, as a share of all.
const _ROUNDING := 1e-12


## One sentence a step, translated.
static func sentences(model: NewtonBallsModel, meeting: BallMeeting) -> PackedStringArray:
	if not meeting:
		var sentence := _on_no_meeting()
		return [sentence, sentence, sentence, sentence, sentence, sentence, sentence, sentence]
	return [
		_on_meet(model),
		LabText.translate(
			"n points from ball 1 to ball 2. Smooth balls push each other along n only."
		),
		LabText.translate(
			"V is the velocity of the centre of mass. No push between the two balls changes it."
		),
		_on_frame(model),
		LabText.translate(
			"Each gives the other the same push J, in opposite directions: action and reaction."
		),
		LabText.translate(
			"The same J changes a heavy ball little and a light one much. Across n nothing changes."
		),
		LabText.translate(
			"Tip to tail, the momenta lead to the same sum P before and after the bounce."
		),
		_on_energy(meeting),
	]


static func _on_no_meeting() -> String:
	return (
		LabText.translate(
			"Within %s s no two balls meet. Drag a ball or a velocity so that they do."
		)
		% NumberText.short(BallRun.LONGEST)
	)


static func _on_meet(model: NewtonBallsModel) -> String:
	if not model.has_newton:
		return LabText.translate(
			"Newton is off: each ball bounces as off a wall. Press Play and watch the momenta."
		)
	if model.balls.size() > 2:
		return LabText.translate(
			"Press Play. The steps are about the first two balls that meet, 1 and 2."
		)
	return LabText.translate("Press Play: two balls meet. How fast does each of them leave?")


static func _on_frame(model: NewtonBallsModel) -> String:
	if model.is_pair():
		return LabText.translate(
			"Seen from the centre of mass, each ball leaves along n as fast as it came, times C."
		)
	return LabText.translate(
		"For somebody who moves with V, each ball leaves along n as fast as it came, times C."
	)


static func _on_energy(meeting: BallMeeting) -> String:
	if meeting.bounciness == 1.0:
		return LabText.translate(
			"With C = 1 the closing speed comes back in full, and no kinetic energy is lost."
		)
	if meeting.bounciness == 0.0:
		return LabText.translate(
			"With C = 0 nothing of the closing speed comes back. The energy of V stays: P is kept."
		)
	return LabText.translate(
		"Of the energy seen from the centre of mass, along n, only the share C² stays."
	)


## What is asked before V is shown, translated.
static func question_on_center() -> String:
	return LabText.translate("What does the centre of mass do when the balls bounce?")


## The answers to [method question_on_center], translated.
static func choices_on_center() -> PackedStringArray:
	return [
		LabText.translate("it moves on as before"),
		LabText.translate("it gets slower"),
		LabText.translate("it turns back"),
	]


## What is asked before the velocities after the bounce are shown, translated.
static func question_on_velocity() -> String:
	return LabText.translate(
		"Where does the arrow of v₁′ end, drawn from ball 1? Drag the “?” there, then step forward."
	)


## What is asked before the energy is shown, translated.
static func question_on_energy() -> String:
	return LabText.translate("The momentum is kept. Is the kinetic energy kept, too?")


## The answers to [method question_on_energy], translated.
static func choices_on_energy() -> PackedStringArray:
	return [LabText.translate("all of it is kept"), LabText.translate("some of it is lost")]


## The right one of [method choices_on_energy], counted from 0; -1 where no balls meet.
static func right_about_energy(meeting: BallMeeting) -> int:
	if not meeting:
		return -1
	return 0 if _keeps_energy(meeting) else 1


## Whether the mistake is shown at [param step]: not before the right velocities.
static func is_compared(model: NewtonBallsModel, meeting: BallMeeting, step: int) -> bool:
	return meeting != null and model.shown_mistake() != 0 and step >= NewtonBallsModel.Step.AFTER


## The step at which a mistake is compared, for who switches it on at [param step].
static func step_of_mistake(_mistake: int, step: int) -> int:
	return step if step >= NewtonBallsModel.Step.AFTER else NewtonBallsModel.Step.MOMENTUM


## What was found at [param step], in a few lines, translated.
static func verdict(model: NewtonBallsModel, meeting: BallMeeting, step: int) -> PackedStringArray:
	if not meeting:
		var sentence := LabText.translate("within %s s no two balls meet")
		return [sentence % NumberText.short(BallRun.LONGEST)]
	var words: PackedStringArray = []
	match step:
		NewtonBallsModel.Step.CENTER, NewtonBallsModel.Step.FRAME:
			words = [
				LabText.translate("V = %s, before and after") % _pair(meeting.center_velocity())
			]
		NewtonBallsModel.Step.IMPULSE:
			words = [LabText.translate("both feel J = %s") % NumberText.short(meeting.impulse())]
		NewtonBallsModel.Step.AFTER:
			var after := meeting.velocities_after()
			words = ["v₁′ = %s" % _pair(after[0]), "v₂′ = %s" % _pair(after[1])]
		NewtonBallsModel.Step.MOMENTUM:
			words = [LabText.translate("P = %s, before and after") % _pair(meeting.momentum())]
		NewtonBallsModel.Step.ENERGY:
			words = [_energy_words(meeting)]
	if is_compared(model, meeting, step):
		words.append(_mistake_words(model, meeting, step))
	return words


static func _energy_words(meeting: BallMeeting) -> String:
	var all := NumberText.short(meeting.energy())
	if _keeps_energy(meeting):
		return LabText.translate("E = %s, before and after") % all
	return LabText.translate("E: %s of %s is lost") % [NumberText.short(meeting.lost_energy()), all]


static func _keeps_energy(meeting: BallMeeting) -> bool:
	return meeting.lost_energy() <= _ROUNDING * meeting.energy()


static func _mistake_words(model: NewtonBallsModel, meeting: BallMeeting, step: int) -> String:
	if not model.mistake_shows(meeting):
		return LabText.translate("the mistake changes nothing here")
	var wrong := NewtonBallsMistakes.velocities_after(model.shown_mistake(), meeting)
	if step == NewtonBallsModel.Step.ENERGY:
		var energy := NumberText.short(meeting.energy_of(wrong))
		return LabText.translate("the mistake makes E = %s") % energy
	if step == NewtonBallsModel.Step.MOMENTUM:
		return LabText.translate("the mistake makes P = %s") % _pair(meeting.momentum_of(wrong))
	return LabText.translate("the mistake: v₁′ = %s, v₂′ = %s") % [_pair(wrong[0]), _pair(wrong[1])]


## The sums over all balls at the moment that is shown, translated.
static func ledger(run: BallRun, seconds: float) -> String:
	var sentence := LabText.translate("t = %s s   P = %s   E = %s")
	var shown := "%.2f" % seconds
	return sentence % [shown, _pair(run.momentum()), NumberText.short(run.energy())]


# What is only rounding beside the other component is 0.
static func _pair(vector: Vec2) -> String:
	var least := 1e-13 * vector.length()
	var x := 0.0 if absf(vector.x) < least else vector.x
	var y := 0.0 if absf(vector.y) < least else vector.y
	return NumberText.pair(x, y)
