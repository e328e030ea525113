class_name BallisticShotProblem
extends ReportProblem
## The ninth problem: where to aim under gravity.

## The closed form for a target at rest, the roots of the equation of degree four for a moving one.
const CAREFUL := "equation for the time"
## The tangent of the slide, for a target at rest.
const BY_THE_SLIDE := "tangent, slide"

# Seconds.
const _LONGEST := 10.0


func _init() -> void:
	id = "ballistic_shot"
	champion = CAREFUL
	title = "A shot under gravity"
	question = (
		"Where to aim at a point when gravity pulls the bullet, at random numbers. The error is the"
		+ " largest miss: the least distance of bullet and target, computed with 106 bits."
	)
	run_time_axis = "run time, µs per shot"
	error_axis = "largest miss, px"


## See [method ReportProblem.cases].
func cases(is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for situation in BallisticQuestions.SITUATIONS:
		var asked := BallisticQuestions.of(situation, is_quick)
		if situation == BallisticQuestions.MOVING:
			found.append(_case(situation, asked, _moving).named(CAREFUL))
			for rounds in LeadShotProblem.ROUNDS:
				var words := "1 round" if rounds == 1 else "%d rounds" % rounds
				var case := _case(situation, asked, _guessed.bind(rounds))
				found.append(case.named(LeadShotProblem.GUESSED, words))
		else:
			found.append(_case(situation, asked, _fixed).named(CAREFUL))
			found.append(_case(situation, asked, _by_the_slide).named(BY_THE_SLIDE))
		for rate in LeadShotProblem.rates(is_quick):
			var search := _case(situation, asked, FramewiseAim.first.bind(rate))
			found.append(search.named(LeadShotProblem.FRAME_BY_FRAME, "%d Hz" % rate))
	return found


func _case(situation: String, asked: Array[AimQuestion], solver: Callable) -> AimCase:
	return AimCase.new(id, situation, asked, solver, _miss)


static func _miss(asked: AimQuestion, aim: Aim) -> float:
	return asked.miss_of(aim)


static func _fixed(asked: AimQuestion) -> Aim:
	var place := asked.target.position
	return _first(BallisticAim.at_fixed(asked.shooter, place, asked.gravity, asked.speed))


static func _by_the_slide(asked: AimQuestion) -> Aim:
	var place := asked.target.position
	return _first(
		BallisticAim.at_fixed_by_the_slide(asked.shooter, place, asked.gravity.y, asked.speed)
	)


static func _moving(asked: AimQuestion) -> Aim:
	return _first(
		BallisticAim.at_moving(asked.shooter, asked.target, asked.gravity, asked.speed, _LONGEST)
	)


static func _guessed(asked: AimQuestion, rounds: int) -> Aim:
	return IteratedAim.ballistic(asked.shooter, asked.target, asked.gravity, asked.speed, rounds)


static func _first(shots: Array[Aim]) -> Aim:
	return shots[0] if shots else Aim.miss(Aim.Outcome.OUT_OF_REACH)
