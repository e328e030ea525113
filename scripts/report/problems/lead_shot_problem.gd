class_name LeadShotProblem
extends ReportProblem
## The eighth problem: where to aim at a target that moves, for a bullet of constant speed.

## The slide's formula and the careful one.
const CAREFUL := "quadratic equation"
## See [constant CAREFUL].
const BY_THE_SLIDE := "quadratic equation, slide"
## See [IteratedAim].
const GUESSED := "guessed time of flight"
## See [FramewiseAim].
const FRAME_BY_FRAME := "frame by frame"
## How often the time of flight is guessed.
const ROUNDS: PackedInt32Array = [1, 4, 16]

# The numbers of frames in a second.
const _RATES: PackedInt32Array = [60, 240]
const _QUICK_RATES: PackedInt32Array = [60]


func _init() -> void:
	id = "lead_shot"
	champion = CAREFUL
	title = "A shot ahead of a moving target"
	question = (
		"Where to aim at a point that moves, with a bullet of constant speed, at random numbers. The"
		+ " error is the largest miss: the least distance of bullet and target, computed with 106 bits."
	)
	run_time_axis = "run time, µs per shot"
	error_axis = "largest miss, px"


## See [method ReportProblem.cases].
func cases(is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for situation in LeadQuestions.SITUATIONS:
		var asked := LeadQuestions.of(situation, is_quick)
		found.append(_case(situation, asked, _careful).named(CAREFUL))
		found.append(_case(situation, asked, _by_the_slide).named(BY_THE_SLIDE))
		for rounds in ROUNDS:
			var words := "1 round" if rounds == 1 else "%d rounds" % rounds
			found.append(_case(situation, asked, _guessed.bind(rounds)).named(GUESSED, words))
		for rate in rates(is_quick):
			var search := FramewiseAim.first.bind(rate)
			found.append(_case(situation, asked, search).named(FRAME_BY_FRAME, "%d Hz" % rate))
	return found


## The numbers of frames in a second that are measured.
static func rates(is_quick: bool) -> PackedInt32Array:
	return _QUICK_RATES if is_quick else _RATES


func _case(situation: String, asked: Array[AimQuestion], solver: Callable) -> AimCase:
	return AimCase.new(id, situation, asked, solver, _miss)


static func _miss(asked: AimQuestion, aim: Aim) -> float:
	return asked.miss_of(aim)


static func _careful(asked: AimQuestion) -> Aim:
	return LeadAim.first(asked.shooter, asked.target, asked.speed)


static func _by_the_slide(asked: AimQuestion) -> Aim:
	return LeadAim.first_by_the_slide(asked.shooter, asked.target, asked.speed)


static func _guessed(asked: AimQuestion, rounds: int) -> Aim:
	return IteratedAim.lead(asked.shooter, asked.target, asked.speed, rounds)
