class_name CarlsonIntegral
extends RefCounted
## The elliptic integral of the first kind in its symmetric form. It gives the times of motions
## whose speed follows from their energy, such as sliding on a circle.
##
## Sources: Carlson, Numerical Computation of Real or Complex Elliptic Integrals, 1995; NIST Digital
## Library of Mathematical Functions, 19.16.1, 19.36.1.

## The three numbers are close enough for the series when they differ from their mean by less than
## this fraction of it: the terms that the series omits are then below 1e-16.
const _CLOSE := 0.004

## The most doublings. Each makes the differences four times smaller, so 1000 lead from 1e300 to
## 1e-300.
const _MOST_DOUBLINGS := 1100


## Half the integral of 1 / sqrt((s + x) (s + y) (s + z)) over s from 0 to infinity. No number may
## be negative, and at most one may be 0: otherwise the result is not a number. The relative error
## is a few units in the last place.
static func first_kind(x: float, y: float, z: float) -> float:
	for _count in _MOST_DOUBLINGS:
		var mean := (x + y + z) / 3.0
		if maxf(absf(mean - x), maxf(absf(mean - y), absf(mean - z))) <= _CLOSE * mean:
			return _series(1.0 - x / mean, 1.0 - y / mean) / sqrt(mean)
		var root_x := sqrt(x)
		var root_y := sqrt(y)
		var root_z := sqrt(z)
		var shift := root_x * root_y + root_x * root_z + root_y * root_z
		x = 0.25 * (x + shift)
		y = 0.25 * (y + shift)
		z = 0.25 * (z + shift)
	return INF


# The Taylor series about three equal numbers. x and y are the fractions of the mean by which two of
# them are too small.
static func _series(x: float, y: float) -> float:
	var z := -x - y
	var two := x * y - z * z
	var three := x * y * z
	var sixth := 3.0 * three * three / 104.0 - 5.0 * two * two * two / 208.0
	return 1.0 - two / 10.0 + three / 14.0 + two * two / 24.0 - 3.0 * two * three / 44.0 + sixth
