class_name ExactNormal
## The unit normal to about 100 bits: the readout compares both ways with it.


## The distance of [param got] from the exact (-y, x) / |v|, in pixels. Each component is compared
## by [ExactProjection]: it is the projection of the unit vector of its axis on the normal. For a
## zero v the exact answer is zero.
static func error_of(got: Vec2, v: Vec2) -> float:
	var normal := Vec2.new(-v.y, v.x)
	var x := ExactProjection.error_of_scalar_projection(got.x, Vec2.new(1.0, 0.0), normal)
	var y := ExactProjection.error_of_scalar_projection(got.y, Vec2.new(0.0, 1.0), normal)
	return Vec2.new(x, y).length()
