class_name BallFlight
extends RefCounted
## The way of a ball through one frame with at most one elastic bounce, in closed form: any fraction
## of the frame can be asked for, in any order.

## The centre at the beginning of the frame.
var start: Vec2
## The way of the whole frame, before the bounce.
var motion: Vec2
## Where and when it bounces.
var impact: Impact


## A flight from [param from] by [param by] that bounces as [param with] says, if that is a hit.
func _init(from: Vec2, by: Vec2, with: Impact) -> void:
	start = from.copy()
	motion = by.copy()
	impact = with


## The motion per frame after the bounce; as before where there is none, or no normal for it.
func motion_after() -> Vec2:
	var has_normal := impact.hit and absf(impact.normal.length() - 1.0) < 1e-9
	return motion.reflected(impact.normal) if has_normal else motion.copy()


## The centre after [param fraction] of the frame.
func position_at(fraction: float) -> Vec2:
	if not impact.hit or fraction < impact.fraction:
		return start.plus(motion.scaled(fraction))
	return impact.position.plus(motion_after().scaled(fraction - impact.fraction))


## The corners of the way from the beginning of the frame to [param fraction] of it.
func corners(fraction: float) -> Array[Vec2]:
	var found: Array[Vec2] = [start]
	if impact.hit and fraction > impact.fraction:
		found.append(impact.position)
	found.append(position_at(fraction))
	return found


## False for a flight that a mistake has spoiled: its bounce has no place.
func is_finite() -> bool:
	return not impact.hit or impact.position.is_finite()
