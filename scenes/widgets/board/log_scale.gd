class_name LogScale
extends RefCounted
## An axis on which each power of ten takes the same room. Zero has no place on such an axis, nor
## has what is not finite: both are told apart, so that a plot can show them beside it.

## Values above this count as no answer: a method that has blown up must not press all the others
## into one corner.
const LARGEST := 1e12
## Values below this count as zero, so that one of them does not press the others together, either.
const SMALLEST := 1e-40

## The power of ten at which the axis begins.
var from_exponent := 0
## The power of ten at which it ends; always above [member from_exponent].
var to_exponent := 1
## Some value is zero, and needs a place below the axis.
var has_zero := false
## Some value is no answer, and needs a place above the axis.
var has_no_answer := false


## The axis for these values: from the power of ten below the smallest to the one above the largest.
static func around(values: PackedFloat64Array) -> LogScale:
	var scale := LogScale.new()
	var least := INF
	var most := 0.0
	for value in values:
		if is_no_answer(value):
			scale.has_no_answer = true
		elif is_zero(value):
			scale.has_zero = true
		else:
			least = minf(least, value)
			most = maxf(most, value)
	if most > 0.0:
		scale.from_exponent = floori(_exponent(least))
		scale.to_exponent = maxi(ceili(_exponent(most)), scale.from_exponent + 1)
	return scale


## Whether the value has its place below the axis.
static func is_zero(value: float) -> bool:
	return absf(value) < SMALLEST


## Whether the value has its place above the axis: too large, infinite, or no number.
static func is_no_answer(value: float) -> bool:
	return not absf(value) <= LARGEST


## Where a value lies on the axis: 0 at its beginning, 1 at its end. Only for one that is neither
## zero nor no answer.
func share(value: float) -> float:
	return (_exponent(value) - from_exponent) / (to_exponent - from_exponent)


## The powers of ten that get a number, at most [param most] of them, evenly spaced.
func ticks(most: int) -> PackedInt32Array:
	var found: PackedInt32Array = []
	var step := ceili((to_exponent - from_exponent) / maxf(most - 1.0, 1.0))
	for exponent in range(from_exponent, to_exponent + 1):
		if posmod(exponent, step) == 0:
			found.append(exponent)
	return found


# A power of ten itself must not fall just below its own exponent by rounding.
static func _exponent(value: float) -> float:
	var exponent := log(value) / log(10.0)
	return roundf(exponent) if absf(exponent - roundf(exponent)) < 1e-9 else exponent
