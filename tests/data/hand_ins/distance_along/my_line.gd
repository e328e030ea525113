class_name MyLine
extends RefCounted
## A ball and an infinite line, with the methods of your [MyVec2].


## Exercise 5: the signed distance of [param point] from the line through [param start] and
## [param end], along the normal of the line. It is positive on the side to which the normal points.
static func distance_to_line(point: MyVec2, start: MyVec2, end: MyVec2) -> float:
	return point.minus(start).scalar_projection(end.minus(start))


## Exercise 6: whether a ball with this [param radius] touches the line. [param distance] is the
## signed one of exercise 5. The line has one good side: behind it the ball counts as touching.
static func is_touching(distance: float, radius: float) -> bool:
	return false


## Exercise 7: where the ball is put back to, along the normal, so that it just touches. The result
## is a new vector; [param position] stays as it is.
static func position_reset(
	position: MyVec2, normal: MyVec2, distance: float, radius: float
) -> MyVec2:
	return null
