class_name MyImpact
extends RefCounted
## When a moving ball touches a line within one frame.

## What both methods give back when there is no impact in this frame.
const NO_IMPACT := INF


## Exercise 8: the fraction of the frame, 0 to 1, after which the ball touches the line.
## [param old] and [param new] are its signed distances before and after the frame.
## [constant NO_IMPACT] if the fraction is not within 0 to 1.
static func time_of_impact(old: float, new: float, radius: float) -> float:
	var t := (old - radius) / (old - new)
	if t < 0.0 or t > 1.0:
		return NO_IMPACT
	return t


## Exercise 11: the same for a ball that moves by [param motion] from [param position], with a line
## that ends at [param start] and [param end]. Both sides count, and so do the ends: the ball
## bounces off them. Only what the ball comes nearer to can be hit. [constant NO_IMPACT] if there is
## none.
static func segment_impact(
	position: MyVec2, motion: MyVec2, radius: float, start: MyVec2, end: MyVec2
) -> float:
	return NO_IMPACT
