class_name ComponentLists
extends RefCounted
## The dot product of two equally long lists of components, whatever their number.

## The names of the components that a picture of them has.
const LETTERS := "xyzwu"


## a1 b1 + a2 b2 + ...; 0 for empty lists.
static func dot(one: PackedFloat64Array, other: PackedFloat64Array) -> float:
	var sum := 0.0
	for i in one.size():
		sum += one[i] * other[i]
	return sum


## The same to about 100 bits: what the readout compares it with.
static func exact_dot(one: PackedFloat64Array, other: PackedFloat64Array) -> DoubleDouble:
	var sum := DoubleDouble.from_float(0.0)
	for i in one.size():
		sum = sum.plus(DoubleDouble.product_of(one[i], other[i]))
	return sum


## The root of a . a, in units; 0 for a list of zeros.
static func length(one: PackedFloat64Array) -> float:
	return sqrt(dot(one, one))
