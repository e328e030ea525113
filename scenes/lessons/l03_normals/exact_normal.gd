class_name ExactNormal
## The unit normal to about 100 bits: what the readout compares both ways with.


## How many pixels [param got] is away from the exact (-y, x) / |v|: both components by
## [ExactProjection], as the projections of the axes' unit vectors on the normal. For a zero v the
## exact answer is zero.
static func error_of(got: Vec2, v: Vec2) -> float:
	var normal := Vec2.new(-v.y, v.x)
	var x := ExactProjection.error_of_scalar_projection(got.x, Vec2.new(1.0, 0.0), normal)
	var y := ExactProjection.error_of_scalar_projection(got.y, Vec2.new(0.0, 1.0), normal)
	return Vec2.new(x, y).length()
