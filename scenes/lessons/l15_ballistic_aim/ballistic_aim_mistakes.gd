class_name BallisticAimMistakes
extends RefCounted
## Five ways in which an aim under gravity goes wrong.
##
## Only the bug gallery uses them; the right way is in `scripts/aiming/ballistic_aim.gd`.

## Gravity has the wrong sign.
const SIGN := 101
## The one half of g t²/2 is forgotten.
const HALF := 102
## Nobody asks whether the target can be reached.
const NOT_TESTED := 103
## The target is aimed at as if it stayed where it is.
const AT_REST := 104
## Gravity is left out.
const NO_GRAVITY := 105

# Two directions that differ by less are one aim.
const _ONE_AIM := 1e-9


## The shot to which a mistake leads, or none.
class WrongShot:
	extends RefCounted
	## Whether the mistake finds an aim at all.
	var hit := false
	## Its direction, of length 1.
	var direction := Vec2.zero()
	## When it is thought to hit, in seconds.
	var time := 0.0
	## By how much it misses.
	var miss: ShotMiss


## All aims that hit [param target] from the origin, the earliest first.
static func right_shots(target: AimTarget, gravity: Vec2, speed: float) -> Array[Aim]:
	var here := Vec2.zero()
	if target.position.length() == 0.0:
		return []
	if target.velocity.length() == 0.0 and target.acceleration.length() == 0.0:
		return _apart(BallisticAim.at_fixed(here, target.position, gravity, speed))
	return BallisticAim.at_moving(here, target, gravity, speed, BallisticAimModel.LONGEST)


# At the edge of what can be reached both arcs are one.
static func _apart(aims: Array[Aim]) -> Array[Aim]:
	if aims.size() == 2 and aims[0].direction.distance_to(aims[1].direction) <= _ONE_AIM:
		aims.resize(1)
	return aims


## The shot to which the mistake that is switched on in [param model] leads: of several, that in the
## place of the arc that is flown.
static func shot_of(model: BallisticAimModel) -> WrongShot:
	var wrong := WrongShot.new()
	var aims := _wrong_aims(model)
	if aims.is_empty():
		return wrong
	var aim := aims[clampi(model.arc, 0, aims.size() - 1)]
	wrong.hit = true
	wrong.direction = aim.direction
	wrong.time = aim.time
	wrong.miss = model.miss_of(aim.direction, aim.time)
	return wrong


static func _wrong_aims(model: BallisticAimModel) -> Array[Aim]:
	var target := model.aim_target()
	match model.mistake:
		SIGN:
			target.acceleration = target.acceleration.negated()
			return right_shots(target, model.pull().negated(), model.speed)
		HALF:
			target.acceleration = target.acceleration.scaled(2.0)
			return right_shots(target, model.pull().scaled(2.0), model.speed)
		NOT_TESTED:
			return right_shots(target, model.pull(), model.speed)
		AT_REST:
			return right_shots(AimTarget.new(model.target), model.pull(), model.speed)
		NO_GRAVITY:
			target.acceleration = Vec2.zero()
			return right_shots(target, Vec2.zero(), model.speed)
	return []


## The time of flight that [constant HALF] makes of the right one, in seconds, on the level: the
## bullet comes down to it at half the time.
static func halved_time(time: float) -> float:
	return 0.5 * time


## What the bug gallery says of each, translated.
static func infos() -> Array[MistakeInfo]:
	var tests := "test_ballistic_aim_mistakes.test_"
	return [
		MistakeInfo.new(
			SIGN,
			LabText.translate("sign of g"),
			LabText.translate(
				"The fall is added to the target, not taken away: the aim is below it."
			),
			tests + "the_sign_of_g_aims_below",
			LabText.translate("The test wants the bullet to come to the target.")
		),
		(
			MistakeInfo
			. new(
				HALF,
				LabText.translate("one half forgotten"),
				(
					LabText
					. translate(
						"With g t² for the fall, the aim is too high, or no aim is found where there is one."
					)
				),
				tests + "one_half_forgotten_finds_nothing",
				LabText.translate("The test wants the fall of one second to be g / 2.")
			)
		),
		MistakeInfo.new(
			NOT_TESTED,
			LabText.translate("reach not tested"),
			LabText.translate(
				"Out of reach, w is below 0. Its root is NaN, and so is the place of the bullet."
			),
			tests + "out_of_reach_is_told",
			LabText.translate("The test wants no aim, and no NaN, below the least speed.")
		),
		MistakeInfo.new(
			AT_REST,
			LabText.translate("aimed at the present place"),
			LabText.translate(
				"When the bullet comes, the target is somewhere else. A falling one is lower."
			),
			tests + "a_falling_target_is_aimed_at_straight",
			LabText.translate("The test lets the target fall or move, and wants a hit.")
		),
		MistakeInfo.new(
			NO_GRAVITY,
			LabText.translate("gravity left out"),
			LabText.translate("Aimed straight at the target. The bullet falls all the way."),
			tests + "without_gravity_the_bullet_comes_too_low",
			LabText.translate("The test wants an aim above a target that rests.")
		),
	]
