class_name ExactAngle
extends RefCounted
## Directions as angles, to about 100 bits.

## A quarter of a turn, in radians: its rounding error is below 1e-48.
const _QUARTER: PackedFloat64Array = [
	1.5707963267948966, 6.123233995736766e-17, -1.4973849048591833e-33
]
# Of the series for sine and cosine: the next one is below 1e-32 for an eighth of a turn.
const _TERMS := 28


## The vector of length 1 at [param angle] radians, clockwise on screen from the x axis. The angle
## is within -10000..10000.
static func unit(angle: DoubleDouble) -> ExactVector:
	var quarters := roundf(angle.high / _QUARTER[0])
	var rest := angle
	for part in _QUARTER:
		rest = rest.minus(DoubleDouble.product_of(part, quarters))
	var vector := _near_zero(rest)
	for turn in posmod(int(quarters), 4):
		vector = vector.turned()
	return vector


# Cosine and sine by their series: each term is the one before times x over the next whole number.
static func _near_zero(x: DoubleDouble) -> ExactVector:
	var sums: Array[DoubleDouble] = [DoubleDouble.from_float(0.0), DoubleDouble.from_float(0.0)]
	var term := DoubleDouble.from_float(1.0)
	for place in _TERMS:
		# The signs are +, +, -, -.
		sums[place % 2] = sums[place % 2].plus(term if place % 4 < 2 else term.negated())
		term = term.times(x).divided(DoubleDouble.from_float(place + 1))
	return ExactVector.new(sums[0], sums[1])
