class_name ExactProjection
extends RefCounted
## The dot product and the scalar projection to about 100 bits: the exact answers for readouts.
##
## The components are taken as exact. They must be 0 or have a magnitude between 1e-150 and 1e150.

## Both vectors are scaled to about 2 to this power, in the middle of the range of a double, so that
## the products of large and of small components stay in range.
const _EXPONENT_OF_LENGTH := 400.0


## The dot product a . b. The products of the components must lie in the range of [DoubleDouble].
static func dot(a: Vec2, b: Vec2) -> DoubleDouble:
	return DoubleDouble.product_of(a.x, b.x).plus(DoubleDouble.product_of(a.y, b.y))


## The scalar projection of a on b, in pixels: (a . b) / |b|. 0 for a zero b.
static func scalar_projection(a: Vec2, b: Vec2) -> DoubleDouble:
	if b.x == 0.0 and b.y == 0.0:
		return DoubleDouble.from_float(0.0)
	var factor := _factor_to_middle(a)
	var middle_a := a.scaled(factor)
	var middle_b := b.scaled(_factor_to_middle(b))
	var projection := dot(middle_a, middle_b).divided(dot(middle_b, middle_b).square_root())
	return DoubleDouble.new(projection.high / factor, projection.low / factor)


## The error of [param value] as the scalar projection of a on b, in pixels; negative if it is too
## small.
static func error_of_scalar_projection(value: float, a: Vec2, b: Vec2) -> float:
	return scalar_projection(a, b).error_of(value)


## A power of two, so that multiplying by it changes no digit.
static func _factor_to_middle(vector: Vec2) -> float:
	var exponent := log(maxf(absf(vector.x), absf(vector.y))) / log(2.0)
	return pow(2.0, clampf(_EXPONENT_OF_LENGTH - floorf(exponent), -1000.0, 1000.0))
