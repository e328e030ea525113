class_name Quadratic
extends RefCounted
## The quadratic equation a t^2 + b t + c = 0.


## Its real roots, the smaller one first. Empty if there is none, or if every t is a root. The root
## whose digits would cancel is computed from the product of both roots, c / a (Numerical Recipes,
## section 5.6).
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
