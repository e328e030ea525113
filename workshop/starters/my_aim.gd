class_name MyAim
extends RefCounted
## Your own aiming, with the methods of your [MyVec2]: in which direction must a shot go to hit? All
## directions that you give back have length 1.

## What [method MyAim.lead_time] gives back when no shot hits. The others give (0, 0) then.
const NO_SHOT := INF


## Exercise 13: after how many seconds the first shot hits a target that moves. [param place] is the
## way from you to the target, [param velocity] is the target's. The bullet flies with
## [param speed], which is above 0. [constant NO_SHOT] if the target gets away.
static func lead_time(place: MyVec2, velocity: MyVec2, speed: float) -> float:
	return 0.0


## Exercise 13: the direction of that shot.
static func lead(place: MyVec2, velocity: MyVec2, speed: float) -> MyVec2:
	return null


## Exercise 14: the direction of the flat arc to a target that rests. [param place] is the way from
## you to the target. [param gravity] pulls down, so along y; it is above 0. (0, 0) if the target is
## out of reach.
static func flat_arc(place: MyVec2, gravity: float, speed: float) -> MyVec2:
	return null


## Exercise 14: the same for the high arc.
static func high_arc(place: MyVec2, gravity: float, speed: float) -> MyVec2:
	return null


## Exercise 15: the direction in which a ball starts that comes to [param target] after one bounce
## off the line. [param bounciness] is C, above 0. Start and target are on the same side of the
## line, and both are farther from it than [param radius].
static func bank(
	start: MyVec2,
	target: MyVec2,
	radius: float,
	bounciness: float,
	line_start: MyVec2,
	line_end: MyVec2
) -> MyVec2:
	return null


## Exercise 15: the same for a ball that bounces off the first line and then off the second one,
## with bounciness 1.
static func bank_twice(
	start: MyVec2,
	target: MyVec2,
	radius: float,
	first_start: MyVec2,
	first_end: MyVec2,
	second_start: MyVec2,
	second_end: MyVec2
) -> MyVec2:
	return null
