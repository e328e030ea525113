class_name NormalByFormula
## The unit normal by the bare formula (-y, x) / |v|, as fast as it can be. [method Vec2.normal]
## does the same for vectors of any size.


## (-y, x) divided by the length of [param v]; zero for a zero v.
static func unit(v: Vec2) -> Vec2:
	var size := sqrt(v.x * v.x + v.y * v.y)
	return Vec2.new(-v.y / size, v.x / size) if size > 0.0 else Vec2.new()
