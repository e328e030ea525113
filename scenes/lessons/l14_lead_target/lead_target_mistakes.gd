class_name LeadTargetMistakes
extends RefCounted
## The wrong directions of the bug gallery. The right one is that of [LeadAim].

## Aims at the place where the target is now.
const AT_PRESENT := 101
## Takes the time to that place, and aims at where the target is then.
const ONE_STEP := 102
## Takes a root below 0.
const BELOW_ZERO := 103
## Forgets the shooter's own velocity.
const WITHOUT_OWN := 104
## Subtracts the shooter's own velocity twice.
const OWN_TWICE := 105


## The direction that the mistake with this number takes, of length 1; zero where it finds none.
## [param equation] is the right one, [param own] the shooter's own velocity.
static func direction(number: int, equation: LeadEquation, own: Vec2) -> Vec2:
	match number:
		AT_PRESENT:
			return equation.way.normalized()
		ONE_STEP:
			return equation.way_after(equation.way.length() / equation.speed).normalized()
		BELOW_ZERO:
			var root := equation.root_below_zero()
			return Vec2.new() if is_nan(root) else equation.way_after(root).normalized()
		WITHOUT_OWN:
			return _direction_for(equation, equation.velocity.plus(own))
		OWN_TWICE:
			return _direction_for(equation, equation.velocity.minus(own))
	return Vec2.new()


static func _direction_for(right: LeadEquation, wrong_velocity: Vec2) -> Vec2:
	return LeadEquation.new(right.way, wrong_velocity, right.speed, right.radius).direction()


## What the gallery shows.
static func infos() -> Array[MistakeInfo]:
	return [
		MistakeInfo.new(
			AT_PRESENT,
			LabText.translate("aimed at where it is now"),
			LabText.translate("When the bullet gets there, the target is gone."),
			"test_lead_target_model.test_aimed_at_where_it_is_now_misses_by_123",
			LabText.translate("The test wants the shot to come closer than the target is wide.")
		),
		MistakeInfo.new(
			ONE_STEP,
			LabText.translate("lead in one step"),
			LabText.translate(
				"|P| / s is the time to where the target is now: the real way is longer or shorter."
			),
			"test_lead_target_model.test_one_step_of_lead_misses_by_24",
			LabText.translate("The test wants |P + V t| = R + s t for the t that is used.")
		),
		MistakeInfo.new(
			BELOW_ZERO,
			LabText.translate("the root below 0"),
			LabText.translate(
				"It aims at where the target was: squaring made a root that lies in the past."
			),
			"test_lead_target_model.test_the_root_below_zero_aims_at_the_past",
			LabText.translate("The test wants t to be 0 or more.")
		),
		MistakeInfo.new(
			WITHOUT_OWN,
			LabText.translate("own velocity forgotten"),
			LabText.translate(
				"The bullet takes u along, so the shooter must aim by V = v − u, not by v."
			),
			"test_lead_target_model.test_own_velocity_forgotten_or_taken_twice",
			LabText.translate(
				"The test lets the shooter move as the target does: then it aims straight at it."
			)
		),
		MistakeInfo.new(
			OWN_TWICE,
			LabText.translate("own velocity taken twice"),
			LabText.translate(
				"u is subtracted once, in V = v − u. The bullet brings the rest along."
			),
			"test_lead_target_model.test_own_velocity_forgotten_or_taken_twice",
			LabText.translate(
				"The test lets the shooter move as the target does: then it aims straight at it."
			)
		),
	]
