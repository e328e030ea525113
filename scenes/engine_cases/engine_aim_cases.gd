class_name EngineAimCases
extends RefCounted
## What users of Godot write for the problems of aiming.


## New cases for the problem with this id; none for another problem.
static func of(problem_id: String, is_quick: bool) -> Array[MeasuredCase]:
	match problem_id:
		"lead_shot":
			return _lead(is_quick)
		"ballistic_shot":
			return _ballistic(is_quick)
		"bank_shot":
			return _bank(is_quick)
		"timed_shot":
			return _timed(is_quick)
	return []


static func _lead(is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for situation in LeadQuestions.SITUATIONS:
		var asked := LeadQuestions.of(situation, is_quick).map(Vector2Shot.new)
		var quadratic := func(shot: Vector2Shot) -> Vector2: return shot.by_quadratic_equation()
		var guess := func(shot: Vector2Shot) -> Vector2: return shot.by_one_guess()
		var name_of_guess := "Vector2, guessed time of flight"
		found.append(
			_shot_case("lead_shot", situation, asked, quadratic).named(
				"Vector2, quadratic equation"
			)
		)
		found.append(
			_shot_case("lead_shot", situation, asked, guess).named(name_of_guess, "1 round")
		)
	return found


static func _ballistic(is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for situation in BallisticQuestions.SITUATIONS:
		var asked := BallisticQuestions.of(situation, is_quick).map(Vector2Shot.new)
		var tangent := func(shot: Vector2Shot) -> Vector2: return shot.by_tangent()
		found.append(
			_shot_case("ballistic_shot", situation, asked, tangent).named("Vector2, tangent")
		)
	return found


static func _shot_case(
	problem: String, situation: String, asked: Array, solver: Callable
) -> AimCase:
	var miss := func(shot: Vector2Shot, direction: Vector2) -> float: return shot.miss(direction)
	return _as_baseline(AimCase.new(problem, situation, asked, solver, miss))


static func _bank(is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	var solver := func(bank: Vector2Bank) -> Vector2: return bank.by_mirror_image()
	var miss := func(bank: Vector2Bank, direction: Vector2) -> float: return bank.miss(direction)
	for situation in BankQuestions.SITUATIONS:
		var asked := BankQuestions.of(situation, is_quick).map(Vector2Bank.new)
		var case := _as_baseline(AimCase.new("bank_shot", situation, asked, solver, miss))
		found.append(case.named("Vector2, mirror image"))
	return found


static func _timed(is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	var by_formula := func(timing: Vector2Timing) -> float: return timing.by_formula()
	var on_circle := func(timing: Vector2Timing) -> float: return timing.on_circle()
	var by_frames := func(timing: Vector2Timing) -> float: return timing.frame_by_frame()
	var miss := func(timing: Vector2Timing, fire: float) -> float: return timing.miss(fire)
	for situation in TimedQuestions.SITUATIONS:
		var asked := TimedQuestions.of(situation, is_quick).map(Vector2Timing.new)
		var solver := on_circle if situation == TimedQuestions.CIRCLE else by_formula
		if situation == TimedQuestions.TURNING:
			solver = by_frames
		var case := _as_baseline(AimCase.new("timed_shot", situation, asked, solver, miss))
		var is_turning := situation == TimedQuestions.TURNING
		found.append(
			(
				case.named("Vector2, frame by frame", "60 Hz")
				if is_turning
				else case.named("Vector2, formula")
			)
		)
	return found


static func _as_baseline(case: AimCase) -> AimCase:
	case.is_baseline = true
	return case
