class_name RealRoots
extends RefCounted
## The real zeros of a polynomial or another function in a range: between two neighbouring zeros of
## the derivative there is one at most, and bisection finds it to the last bit.


## The zeros in ([param low], [param high]] of the polynomial whose coefficients are given from t^0
## on, in order. A zero that only touches is found, or not, as rounding has it.
static func of_polynomial(
	coefficients: PackedFloat64Array, low: float, high: float
) -> PackedFloat64Array:
	if coefficients.size() < 2:
		return []
	return of_function(
		func(t: float) -> float: return value(coefficients, t),
		of_polynomial(derivative(coefficients), low, high),
		low,
		high
	)


## The zeros of [param function], which takes and gives a number, between these turning points, in
## order.
static func of_function(
	function: Callable, turning_points: PackedFloat64Array, low: float, high: float
) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	var left := low
	var left_value: float = function.call(left)
	for right in turning_points + PackedFloat64Array([high]):
		var right_value: float = function.call(right)
		if left_value != 0.0 and (right_value == 0.0 or (left_value < 0.0) != (right_value < 0.0)):
			found.append(_bisected(function, left, right, left_value < 0.0))
		left = right
		left_value = right_value
	return found


## The value of the polynomial at [param t].
static func value(coefficients: PackedFloat64Array, t: float) -> float:
	var sum := 0.0
	for place in range(coefficients.size() - 1, -1, -1):
		sum = sum * t + coefficients[place]
	return sum


## The coefficients of the polynomial's derivative.
static func derivative(coefficients: PackedFloat64Array) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	for place in range(1, coefficients.size()):
		found.append(place * coefficients[place])
	return found


# The last number before the zero, or that behind it: whichever is nearer to zero.
static func _bisected(function: Callable, left: float, right: float, rises: bool) -> float:
	while true:
		var middle := left + 0.5 * (right - left)
		if middle <= left or middle >= right:
			break
		var at_middle: float = function.call(middle)
		if (at_middle < 0.0) == rises and at_middle != 0.0:
			left = middle
		else:
			right = middle
	var at_left: float = function.call(left)
	var at_right: float = function.call(right)
	return left if absf(at_left) < absf(at_right) else right
