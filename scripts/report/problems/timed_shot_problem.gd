class_name TimedShotProblem
extends ReportProblem
## The eleventh problem: when to fire.

## The equations for the moment; for a turning barrel their root by halving.
const CAREFUL := "equation for the moment"
## The formulas of the slide.
const BY_THE_SLIDE := "formula of the slide"
## See [method FramewiseTiming.ahead].
const FRAME_BY_FRAME := "frame by frame"
## See [method FramewiseTiming.in_front].
const IN_FRONT := "when it is in front"


func _init() -> void:
	id = "timed_shot"
	champion = CAREFUL
	title = "The moment to fire"
	question = (
		"When does a barrel fire that is fixed, or that turns all the time, so that its bullet meets a"
		+ " target that passes? The error is the largest miss, computed with 106 bits."
	)
	run_time_axis = "run time, µs per shot"
	error_axis = "largest miss, px"


## See [method ReportProblem.cases].
func cases(is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for situation in TimedQuestions.SITUATIONS:
		var asked := TimedQuestions.of(situation, is_quick)
		found.append(_case(situation, asked, _careful).named(CAREFUL))
		if situation != TimedQuestions.TURNING:
			found.append(_case(situation, asked, _by_the_slide).named(BY_THE_SLIDE))
		for rate in LeadShotProblem.rates(is_quick):
			var search := _case(situation, asked, FramewiseTiming.ahead.bind(rate))
			found.append(search.named(FRAME_BY_FRAME, "%d Hz" % rate))
		var in_front := _case(situation, asked, FramewiseTiming.in_front.bind(60))
		found.append(in_front.named(IN_FRONT, "60 Hz"))
	return found


func _case(situation: String, asked: Array[TimedQuestion], solver: Callable) -> AimCase:
	return AimCase.new(id, situation, asked, solver, _miss)


static func _miss(asked: TimedQuestion, shot: TimedShot) -> float:
	return asked.miss_of(shot)


static func _careful(asked: TimedQuestion) -> TimedShot:
	return asked.answer()


static func _by_the_slide(asked: TimedQuestion) -> TimedShot:
	var place := asked.target.position
	if asked.circle_radius:
		return TimedAim.at_circle_by_the_slide(
			asked.muzzle, asked.bullet, place, asked.circle_radius, asked.phase, asked.circle_turn
		)
	return TimedAim.at_line_by_the_slide(asked.muzzle, asked.bullet, place, asked.target.velocity)
