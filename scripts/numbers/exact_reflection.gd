class_name ExactReflection
extends RefCounted
## The reflection off a line to about 100 bits: the exact answer for readouts.
##
## The components are taken as exact. They must be 0 or have a magnitude between 1e-140 and 1e140.


## The distance of [param value] from v - times (v . n) n, where n is the exact unit normal of a
## line along [param along]: with 2 as times it is the law of reflection, with 1 the ball slides.
## For a zero along it is the distance from v.
static func error_of(value: Vec2, velocity: Vec2, along: Vec2, times: float) -> float:
	var normal := Vec2.new(-along.y, along.x)
	var subtracted := _times_of_normal(velocity, normal, times)
	var error_of_x := _error_of(value.x, velocity.x, normal.x, subtracted)
	var error_of_y := _error_of(value.y, velocity.y, normal.y, subtracted)
	return Vec2.new(error_of_x, error_of_y).length()


# times (v . n) / |n|²: the factor of the normal, whose length need not be 1.
static func _times_of_normal(velocity: Vec2, normal: Vec2, times: float) -> DoubleDouble:
	if normal.length() == 0.0:
		return DoubleDouble.from_float(0.0)
	var product := ExactProjection.dot(velocity, normal).times(DoubleDouble.from_float(times))
	return product.divided(ExactProjection.dot(normal, normal))


static func _error_of(
	value: float, component: float, normal_component: float, subtracted: DoubleDouble
) -> float:
	var change := subtracted.times(DoubleDouble.from_float(normal_component))
	return DoubleDouble.from_float(component).minus(change).error_of(value)
