class_name PrimitiveProjection
extends RefCounted
## The projection by angles, for those who do not know the dot product: slower, longer and less
## exact.


## |a| cos(angle of a - angle of onto), with both angles from atan2. 0 for a zero onto.
static func scalar(a: Vec2, onto: Vec2) -> float:
	if onto.length() == 0.0:
		return 0.0
	var angle_of_a := atan2(a.y, a.x)
	var angle_of_onto := atan2(onto.y, onto.x)
	return a.length() * cos(angle_of_a - angle_of_onto)
