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


## The aims that the mistake with this number finds at [param target], shot from the origin with
## [param gravity], in px/s², and [param speed], in px/s: none for 0, nor where it has no answer.
static func aims(number: int, target: AimTarget, gravity: Vec2, speed: float) -> Array[Aim]:
	var fall := target.acceleration
	match number:
		SIGN:
			return BallisticShots.aims(_falling(target, fall.negated()), gravity.negated(), speed)
		HALF:
			return BallisticShots.aims(
				_falling(target, fall.scaled(2.0)), gravity.scaled(2.0), speed
			)
		NOT_TESTED:
			return BallisticShots.aims(target, gravity, speed)
		AT_REST:
			return BallisticShots.aims(AimTarget.new(target.position), gravity, speed)
		NO_GRAVITY:
			return BallisticShots.aims(_falling(target, Vec2.zero()), Vec2.zero(), speed)
	return []


static func _falling(target: AimTarget, acceleration: Vec2) -> AimTarget:
	return AimTarget.new(target.position, target.velocity, acceleration)


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
