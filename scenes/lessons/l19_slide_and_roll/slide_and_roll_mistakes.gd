class_name SlideAndRollMistakes
extends RefCounted
## The wrong runs of the bug gallery. The right one is that of [Incline].

## Lets the ball roll only from µ = tan on.
const THRESHOLD := 101
## Takes a solid sphere in place of a disc.
const SPHERE := 102
## Lets friction slow the ball down until it stops.
const STOPS := 103
## Forgets that a part of the pull turns the ball.
const WITHOUT_SPIN := 104

# How much slip friction takes from a solid sphere, for 3 of a disc: 1 + 5 / 2.
const _YIELD_OF_SPHERE := 3.5


## How the mistake with this number lets a ball run with [param speed] px/s at the start,
## [param pull] along the line and [param pressure] onto it, in px/s², and [param friction] µ; null
## for none.
static func run(
	number: int, speed: float, pull: float, pressure: float, friction: float
) -> WrongRun:
	var grip := friction * pressure
	match number:
		THRESHOLD:
			if grip < pull:
				return WrongRun.new(speed, pull - grip, INF, pull - grip)
			return WrongRun.that_rolls(speed, pull, grip, Friction.YIELD)
		SPHERE:
			return WrongRun.that_rolls(speed, pull, grip, _YIELD_OF_SPHERE)
		STOPS:
			return WrongRun.that_stops(speed, pull, grip)
		WITHOUT_SPIN:
			return WrongRun.new(speed, pull, INF, pull)
	return null


## What the gallery shows.
static func infos() -> Array[MistakeInfo]:
	return [
		(
			MistakeInfo
			. new(
				THRESHOLD,
				LabText.translate("it rolls only from µ = tan on"),
				(
					LabText
					. translate(
						"A third of tan is enough: friction brakes the ball and turns it, and both end the slip."
					)
				),
				"test_slide_and_roll_model.test_the_threshold_tan_lets_the_ball_slip_too_long",
				LabText.translate("The test lets the ball run with a µ between tan / 3 and tan.")
			)
		),
		MistakeInfo.new(
			SPHERE,
			LabText.translate("5/7 of a solid sphere"),
			LabText.translate(
				"This ball is a flat disc: its share is 2/3. A solid sphere has 5/7."
			),
			"test_slide_and_roll_model.test_the_share_of_a_sphere_is_too_fast",
			LabText.translate("The test wants a rolling disc to take two thirds of the pull.")
		),
		MistakeInfo.new(
			STOPS,
			LabText.translate("friction stops the ball"),
			LabText.translate(
				"As soon as nothing slips, friction no longer stops the ball: it rolls on."
			),
			"test_slide_and_roll_model.test_friction_does_not_stop_a_ball_on_the_level",
			LabText.translate(
				"The test wants a ball on the level to roll on with 2/3 of its speed."
			)
		),
		MistakeInfo.new(
			WITHOUT_SPIN,
			LabText.translate("the spin is forgotten"),
			LabText.translate(
				"A part of the pull turns the ball: a rolling ball is slower than a sliding one."
			),
			"test_slide_and_roll_model.test_without_the_spin_a_rolling_ball_is_too_fast",
			LabText.translate("The test compares a rolling ball with one without friction.")
		),
	]
