class_name MovingPlatformsMistakes
extends RefCounted
## Six ways in which the motion of a surface is taken wrongly.
##
## Only the bug gallery uses them; the right ways are in `scripts/friction/` and
## `scripts/collision/press.gd`.

## The wall is taken to rest.
const IGNORED := 101
## Reflected in the lab, and the wall's velocity added once.
const ADDED_ONCE := 102
## The wall's velocity is added twice, whatever C is.
const ADDED_TWICE := 103
## The tip's velocity is taken, wherever the paddle is touched.
const TIP := 104
## What lies on a belt gets the belt's speed.
const BELT_SPEED := 105
## The ball is moved as its platform was a frame before.
const FRAME_LATE := 106

## A frame, in seconds.
const FRAME := 1.0 / 60.0


## v′ as the mistake with this number has it, in px/s, where [param impact] is right. [param tip] is
## the velocity of the far end of what turns.
static func velocity(number: int, impact: SurfaceImpact, bounciness: float, tip: Vec2) -> Vec2:
	var reflected := impact.coming.reflected(impact.normal, bounciness)
	match number:
		IGNORED:
			return reflected
		ADDED_ONCE:
			return reflected.plus(impact.touched)
		ADDED_TWICE:
			return reflected.plus(impact.touched.scaled(2.0))
		TIP:
			return impact.coming.minus(tip).reflected(impact.normal, bounciness).plus(tip)
	return impact.leaving.copy()


## The speed after so many bounces off the moving wall of a press, in px/s.
static func press_speed(number: int, ball_speed: float, wall_speed: float, bounces: float) -> float:
	match number:
		IGNORED:
			return ball_speed
		ADDED_ONCE:
			return ball_speed + bounces * wall_speed
	return Press.speed_after(bounces, ball_speed, wall_speed)


## What the bug gallery says of each, translated.
static func infos() -> Array[MistakeInfo]:
	var tests := "test_moving_platforms_mistakes.test_"
	return [
		MistakeInfo.new(
			IGNORED,
			LabText.translate("the wall taken to rest"),
			LabText.translate(
				"v is reflected as it is. The ball has to be seen from the wall first."
			),
			tests + "a_wall_that_comes_makes_the_ball_faster",
			LabText.translate("The test lets a wall come to the ball and wants more than v.")
		),
		MistakeInfo.new(
			ADDED_ONCE,
			LabText.translate("wall added once"),
			LabText.translate(
				"v is reflected and w added, but w was never subtracted before the reflection."
			),
			tests + "what_is_added_after_is_subtracted_before",
			LabText.translate("The test wants 400 px/s from −200 against a wall with 100.")
		),
		MistakeInfo.new(
			ADDED_TWICE,
			LabText.translate("wall added twice"),
			LabText.translate("2 w is right for C = 1 only: in general it is (1 + C) w."),
			tests + "a_soft_ball_gets_less_than_twice_the_wall",
			LabText.translate("The test repeats the impact with C = 0.5 and wants 250 px/s.")
		),
		MistakeInfo.new(
			TIP,
			LabText.translate("the tip's velocity"),
			LabText.translate(
				"Each point of the paddle has its own velocity: ω times its distance."
			),
			tests + "the_touched_point_counts_not_the_tip",
			LabText.translate("The test touches the paddle below its tip.")
		),
		MistakeInfo.new(
			BELT_SPEED,
			LabText.translate("the belt's speed"),
			LabText.translate(
				"The disc begins to turn, too. It rolls when a third of the slip has gone into v."
			),
			tests + "a_disc_on_a_belt_ends_at_a_third_of_its_speed",
			LabText.translate("The test puts a disc at rest on a belt with 90 px/s and wants 30.")
		),
		MistakeInfo.new(
			FRAME_LATE,
			LabText.translate("one frame late"),
			LabText.translate(
				"The ball is moved as the platform was a frame before: it is V / 60 behind."
			),
			tests + "a_ball_that_is_carried_is_not_a_frame_late",
			LabText.translate("The test compares ball and platform at the same moment.")
		),
	]
