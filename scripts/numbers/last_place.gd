class_name LastPlace
extends RefCounted
## Units in the last place: how many doubles two results are apart.
##
## A double has 53 binary digits. One unit in the last place of a number is its distance from the
## next double away from 0.


## The distance from the size of [param value] to the next larger double: 2.2e-16 for 1, 5e-324 for
## 0. Not finite if the value is not.
static func unit_of(value: float) -> float:
	var bytes := PackedByteArray()
	bytes.resize(8)
	bytes.encode_double(0, absf(value))
	bytes.encode_s64(0, bytes.decode_s64(0) + 1)
	return bytes.decode_double(0) - absf(value)


## The difference of both numbers in units in the last place of the larger one; 0 only if they are
## equal to the last bit, or are 0 and -0.
static func units_between(one: float, other: float) -> float:
	if one == other:
		return 0.0
	return absf(one - other) / unit_of(maxf(absf(one), absf(other)))
