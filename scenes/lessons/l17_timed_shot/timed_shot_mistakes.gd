class_name TimedShotMistakes
extends RefCounted
## Three ways in which the moment to fire goes wrong.
##
## Only the bug gallery uses them; the right way is in `scripts/aiming/timed_aim.gd`.

## Fired when the target is in front of the barrel.
const IN_FRONT := 101
## The time of flight is added, not taken away.
const FLIGHT_ADDED := 102
## The firing window without the bullet's own motion.
const BULLET_FORGOTTEN := 103


## The moment at which the mistake with this number fires at a target that crosses the bullet's way,
## in seconds, where [param shot] is right.
static func fire(number: int, shot: TimedShot) -> float:
	match number:
		IN_FRONT:
			return shot.fire + shot.flight
		FLIGHT_ADDED:
			return shot.fire + 2.0 * shot.flight
	return shot.fire


## Half of the window, in seconds, that [constant BULLET_FORGOTTEN] makes of it: R / |V|.
static func half_window(radius: float, velocity: Vec2) -> float:
	return radius / velocity.length() if velocity.length() > 0.0 else INF


## What the bug gallery says of each, translated.
static func infos() -> Array[MistakeInfo]:
	var tests := "test_timed_shot_mistakes.test_"
	return [
		MistakeInfo.new(
			IN_FRONT,
			LabText.translate("fired when it is in front"),
			LabText.translate(
				"When the bullet comes, the target has gone on. The bullet needs time, too."
			),
			tests + "fired_when_it_is_in_front_it_misses",
			LabText.translate("The test wants the bullet to meet the target, not its way.")
		),
		MistakeInfo.new(
			FLIGHT_ADDED,
			LabText.translate("flight added"),
			LabText.translate("The time of flight is added. It must be taken away: fire earlier."),
			tests + "the_flight_is_taken_away",
			LabText.translate("The test wants the shot before the target is in X.")
		),
		MistakeInfo.new(
			BULLET_FORGOTTEN,
			LabText.translate("window without the bullet"),
			LabText.translate(
				"R / |V| is how long the target stays. The bullet moves along it: it has longer."
			),
			tests + "the_window_has_the_bullet_s_motion",
			LabText.translate("The test fires at the edge of the window and wants a touch.")
		),
	]
