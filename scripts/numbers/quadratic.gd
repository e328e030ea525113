class_name Quadratic
extends RefCounted
## The equation a t^2 + b t + c = 0 in plain numbers.


## Its real roots, the smaller one first; none where there is none, or where every t would do. The
## root that would cancel is taken from the product of both (c / a), as in Numerical Recipes,
## section 5.6.
static func roots(a: float, b: float, c: float) -> PackedFloat64Array:
	if a == 0.0:
		return PackedFloat64Array([-c / b]) if b != 0.0 else PackedFloat64Array()
	var discriminant := b * b - 4.0 * a * c
	if not discriminant >= 0.0:
		return PackedFloat64Array()
	var larger := -0.5 * (b + (sqrt(discriminant) if b >= 0.0 else -sqrt(discriminant)))
	if larger == 0.0:
		return PackedFloat64Array([0.0, 0.0])
	var one := larger / a
	var other := c / larger
	return PackedFloat64Array([minf(one, other), maxf(one, other)])
