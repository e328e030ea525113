class_name PointOfImpactMistakes
extends RefCounted
## The wrong fractions of the bug gallery. The right one is [PointOfImpact].

## Divides by the new distance instead of the way of the frame.
const OVER_NEW := 15
## Takes distances without their sign, also behind the line.
const UNSIGNED := 16
## Believes every t, also beyond 0..1 and where b is 0.
const NOT_LIMITED := 17
## Computes the fraction from the new position and adds it to the old one.
const FROM_NEW := 20


## What the mistake with this number takes for the fraction of the frame until the contact; the
## right t = a / b, not limited, for 0. Infinite or NaN where it divides by 0.
static func fraction(number: int, old_distance: float, new_distance: float, radius: float) -> float:
	match number:
		OVER_NEW:
			return (old_distance - radius) / new_distance
		UNSIGNED:
			return PointOfImpact.fraction(absf(old_distance), absf(new_distance), radius)
		FROM_NEW:
			return (new_distance - radius) / (old_distance - new_distance)
	return PointOfImpact.fraction(old_distance, new_distance, radius)


## What the gallery shows.
static func infos() -> Array[MistakeInfo]:
	return [
		MistakeInfo.new(
			OVER_NEW,
			LabText.translate("a / new instead of a / b"),
			LabText.translate("b is the way of the frame: old − new."),
			"test_point_of_impact.test_b_is_old_less_new",
			LabText.translate("The test wants t = a / b for distances whose b is not new.")
		),
		MistakeInfo.new(
			UNSIGNED,
			LabText.translate("distances without a sign"),
			LabText.translate("Behind the line, the new distance is negative."),
			"test_point_of_impact.test_distances_are_signed",
			LabText.translate("The test ends the frame behind the line.")
		),
		MistakeInfo.new(
			NOT_LIMITED,
			LabText.translate("t not limited to 0..1"),
			LabText.translate("Outside 0..1, and for b = 0, nothing is hit."),
			"test_point_of_impact.test_share_is_limited",
			LabText.translate("The test wants no impact for t below 0, above 1, and for b = 0.")
		),
		MistakeInfo.new(
			FROM_NEW,
			LabText.translate("time from the new position"),
			LabText.translate("t counts from old: a is old − r."),
			"test_point_of_impact.test_time_is_from_old",
			LabText.translate("The test wants old + t v to be a radius from the line.")
		),
	]
