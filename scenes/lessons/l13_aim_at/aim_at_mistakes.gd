class_name AimAtMistakes
extends RefCounted
## The wrong angles of the bug gallery. The right one is that of [Turn].

## Hands degrees to a method that wants radians.
const DEGREES := 4
## Swaps the arguments of atan2.
const SWAPPED := 30
## Gives the barrel the angle of the target, though it is mounted on a hull that has turned.
const NOT_REDUCED := 101
## Eases without bringing the turn into half a turn: the long way round.
const LONG_WAY := 102


## The direction on the ground in which the mistake with this number leaves the barrel, in degrees;
## the right one for any other number. [param way] leads to the target.
static func direction(number: int, way: Vec2, hull_degrees: float) -> float:
	var seen := way.angle_degrees()
	match number:
		DEGREES:
			return hull_degrees + Vec2.rad_to_deg(seen - hull_degrees)
		SWAPPED:
			return Vec2.rad_to_deg(atan2(way.x, way.y))
		NOT_REDUCED:
			return hull_degrees + seen
	return seen


## What the gallery shows.
static func infos() -> Array[MistakeInfo]:
	return [
		(
			MistakeInfo
			. new(
				NOT_REDUCED,
				LabText.translate("the hull's angle not taken off"),
				LabText.translate(
					"The barrel turns with its hull: what the hull has turned comes on top."
				),
				"test_aim_at_model.test_a_barrel_that_is_not_reduced_is_off_by_the_hull",
				(
					LabText
					. translate(
						"The test turns the hull by 30° and the target to 90°: the barrel's own angle is 60°."
					)
				)
			)
		),
		MistakeInfo.new(
			DEGREES,
			LabText.translate("degrees for radians"),
			LabText.translate("A method that wants radians takes 60 for 60 rad: almost ten turns."),
			"test_aim_at_model.test_degrees_for_radians",
			LabText.translate("The test wants the barrel to point at the target.")
		),
		MistakeInfo.new(
			SWAPPED,
			LabText.translate("atan2(x, y)"),
			LabText.translate(
				"y comes first: atan2(y, x). Swapped, it counts from the y axis, and the other way."
			),
			"test_aim_at_model.test_atan2_with_its_arguments_swapped",
			LabText.translate("The test looks along the y axis: 90°, not 0°.")
		),
		(
			MistakeInfo
			. new(
				LONG_WAY,
				LabText.translate("the long way round"),
				(
					LabText
					. translate(
						"From 135° to −135° it is 90° further, not 270° back: bring the turn into half a turn."
					)
				),
				"test_aim_at_model.test_the_long_way_round",
				LabText.translate("The test wants no turn to be longer than half a turn.")
			)
		),
	]
