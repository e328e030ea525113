class_name CarlsonIntegral
extends RefCounted
## The elliptic integral of the first kind in its symmetric form. It gives times of motions whose
## speed follows from the energy, such as sliding on a circle.
##
## Sources: Carlson, Numerical Computation of Real or Complex Elliptic Integrals, 1995; NIST Digital
## Library of Mathematical Functions, 19.16.1, 19.36.1.

## The three numbers are close enough for the series when they differ by less than this part of
## their mean: what the series leaves out is then below 1e-16.
const _CLOSE := 0.004

## Each doubling makes the differences four times smaller: from 1e300 to 1e-300 it takes 1000.
const _MOST_DOUBLINGS := 1100


## Half the integral of 1 / sqrt((s + x) (s + y) (s + z)) over s from 0 to infinity. None of the
## numbers may be negative, and at most one of them 0: otherwise the result is not a number. The
## relative error is a few units in the last place.
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


# Taylor series about three equal numbers, in the parts by which two of them fall short of the mean.
static func _series(x: float, y: float) -> float:
	var z := -x - y
	var two := x * y - z * z
	var three := x * y * z
	var sixth := 3.0 * three * three / 104.0 - 5.0 * two * two * two / 208.0
	return 1.0 - two / 10.0 + three / 14.0 + two * two / 24.0 - 3.0 * two * three / 44.0 + sixth
