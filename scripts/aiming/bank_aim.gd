class_name BankAim
extends RefCounted
## Aims over walls: a ball that bounces flies straight at the mirror image of its target.
##
## Each wall is moved by the ball's radius to the ball's side, and the target is mirrored in the
## last wall first, then backwards. Where a bounce keeps only C of the speed along the normal, the
## image lies 1/C times as far behind the wall: then the speed in the unfolded picture is constant,
## too.


## The way from [param start] to [param target], both places of the ball's centre, with exactly
## [param bounces] bounces that arrives first. Each bounce is on the line part of a wall, on either
## side, and the ball touches nothing else. [param bounciness] is C, above 0 and at most 1.
static func first(
	start: Vec2,
	target: Vec2,
	radius: float,
	bounciness: float,
	walls: Array[LineSegment],
	bounces: int
) -> BankWay:
	return BankSearch.new(start, target, radius, bounciness, walls).first(bounces)


## All orders of walls with that many bounces, each with what becomes of it.
static func ways(
	start: Vec2,
	target: Vec2,
	radius: float,
	bounciness: float,
	walls: Array[LineSegment],
	bounces: int
) -> Array[BankWay]:
	return BankSearch.new(start, target, radius, bounciness, walls).ways(bounces)
