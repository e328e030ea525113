class_name ReflectionMistakes
extends RefCounted
## Four ways in which students get the reflection wrong, by their numbers in the course's list.
##
## Only the bug gallery uses them; the right way is in `scripts/collision/bounce.gd`.

## The normal is not of length 1.
const NOT_UNIT := 11
## The normal of the normal is taken.
const NORMAL_OF_NORMAL := 12
## The bounciness acts along the line.
const BOUNCY_TANGENT := 13
## A ball that moves away already is reflected again.
const REFLECTED_AGAIN := 14

## The course's frame, in seconds. Once a frame, mistake 14 reflects the ball again.
const FRAME_SECONDS := 1.0 / 60.0


## Mistake 11: the formula with a normal that is not of length 1.
static func with_normal_as_it_is(velocity: Vec2, normal: Vec2, bounciness: float) -> Vec2:
	return velocity.minus(normal.scaled((1.0 + bounciness) * velocity.dot(normal)))


## Mistake 12: reflected off the normal of the normal, which lies along the line.
static func off_the_normal_of_the_normal(velocity: Vec2, normal: Vec2, bounciness: float) -> Vec2:
	return velocity.reflected(normal.normal(), bounciness)


## Mistake 13: the bounciness takes speed along the line, and none along the normal.
static func bouncy_along_the_line(velocity: Vec2, normal: Vec2, bounciness: float) -> Vec2:
	var part := velocity.vector_projection(normal)
	return velocity.minus(part).scaled(bounciness).minus(part)


## The wrong velocity to which the mistake with this number leads; the velocity as it was for 0.
## [param normal] has length 1; mistake 11 takes one of [param normal_length] instead.
static func velocity_after(
	number: int, velocity: Vec2, normal: Vec2, normal_length: float, bounciness: float
) -> Vec2:
	match number:
		NOT_UNIT:
			return with_normal_as_it_is(velocity, normal.scaled(normal_length), bounciness)
		NORMAL_OF_NORMAL:
			return off_the_normal_of_the_normal(velocity, normal, bounciness)
		BOUNCY_TANGENT:
			return bouncy_along_the_line(velocity, normal, bounciness)
		REFLECTED_AGAIN:
			return velocity.reflected(normal, bounciness).reflected(normal, bounciness)
	return velocity.copy()


## Mistake 14: how far the ball has come [param seconds] after it touched the line, where each frame
## finds it still at the line and reflects it once more.
static func way_reflected_again(
	velocity: Vec2, normal: Vec2, bounciness: float, seconds: float
) -> Vec2:
	var way := Vec2.new()
	var leaving := velocity.copy()
	var left := seconds
	while left > 0.0:
		leaving.reflect(normal, bounciness)
		way.add(leaving.scaled(minf(left, FRAME_SECONDS)))
		left -= FRAME_SECONDS
	return way


## What the bug gallery says of each, translated.
static func infos() -> Array[MistakeInfo]:
	return [
		MistakeInfo.new(
			NOT_UNIT,
			LabText.translate("normal not of length 1"),
			LabText.translate(
				"With n twice as long, v · n and n both double: four times as much is subtracted."
			),
			"test_bounce.test_mistake_11_a_normal_that_is_not_unit_is_refused",
			LabText.translate("The test gives a normal of another length and wants it refused.")
		),
		(
			MistakeInfo
			. new(
				NORMAL_OF_NORMAL,
				LabText.translate("normal of the normal"),
				(
					LabText
					. translate(
						"That lies along the line: its motion along the line turns back. It goes on into the line."
					)
				),
				"test_bounce.test_mistake_12_the_normal_of_the_normal_is_not_used",
				LabText.translate("The test wants the part of v along the line to stay.")
			)
		),
		MistakeInfo.new(
			BOUNCY_TANGENT,
			LabText.translate("bounciness on the tangent"),
			LabText.translate(
				"C must act along the normal. Here it brakes the ball along the line."
			),
			"test_bounce.test_mistake_13_bounciness_leaves_the_tangent_alone",
			LabText.translate("The test wants the same speed along the line for every C.")
		),
		(
			MistakeInfo
			. new(
				REFLECTED_AGAIN,
				LabText.translate("reflected while moving away"),
				(
					LabText
					. translate(
						"Next frame the ball still overlaps the line, and is sent back in: it sticks, jittering."
					)
				),
				"test_bounce.test_mistake_14_a_ball_that_moves_away_is_left_alone",
				LabText.translate("The test reflects a ball that moves away and wants v unchanged.")
			)
		),
	]
