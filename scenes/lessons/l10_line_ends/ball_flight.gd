class_name BallFlight
extends RefCounted
## The path of a ball in one frame with at most one elastic bounce, in closed form: its place can be
## asked for after any fraction of the frame, in any order.

## The centre at the beginning of the frame.
var start: Vec2
## The motion of the whole frame, before the bounce.
var motion: Vec2
## The bounce, or a miss.
var impact: Impact
## The ball stays where it touches: what the bounce makes of its motion is not told yet.
var stops_at_touch := false


## A flight from [param from] by [param by] that bounces at [param with], if that is a hit.
func _init(from: Vec2, by: Vec2, with: Impact) -> void:
	start = from.copy()
	motion = by.copy()
	impact = with


## The motion per frame after the bounce; the same as before where there is no bounce, or a bounce
## without a normal of length 1. 0 where it stops.
func motion_after() -> Vec2:
	if impact.hit and stops_at_touch:
		return Vec2.new()
	var has_normal := impact.hit and absf(impact.normal.length() - 1.0) < 1e-9
	return motion.reflected(impact.normal) if has_normal else motion.copy()


## The centre after [param fraction] of the frame.
func position_at(fraction: float) -> Vec2:
	if not impact.hit or fraction < impact.fraction:
		return start.plus(motion.scaled(fraction))
	return impact.position.plus(motion_after().scaled(fraction - impact.fraction))


## The corners of the path from the beginning of the frame to [param fraction] of it.
func corners(fraction: float) -> Array[Vec2]:
	var found: Array[Vec2] = [start]
	if impact.hit and fraction > impact.fraction:
		found.append(impact.position)
	found.append(position_at(fraction))
	return found


## False where a mistake has led to a bounce at a place that is not finite.
func is_finite() -> bool:
	return not impact.hit or impact.position.is_finite()
