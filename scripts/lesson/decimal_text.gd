class_name DecimalText
extends RefCounted
## A double as a short decimal text, and back to the last bit.
##
## The engine's own [method String.to_float] is not correctly rounded: one number in four comes back
## with another last bit. Here the text is read with the 106 bits of [DoubleDouble].

## No number but 0 is smaller in size than this.
const SMALLEST := 1e-100
## No number is larger in size than this.
const LARGEST := 1e100

const _PATTERN := "^(-?)(?=\\.?\\d)(\\d{0,30})(?:\\.(\\d{0,30}))?(?:[eE]([+-]?\\d{1,3}))?\\z"
# More digits do not fit into an int; no double needs more than 17.
const _MOST_DIGITS := 18

static var _pattern := RegEx.create_from_string(_PATTERN)


## [param value], which must be finite, with as few digits as tell it from every other double (in
## one of 1000 numbers one more): `7`, `-0.1`, `3e15`.
static func of(value: float) -> String:
	if value == 0.0:
		return "-0" if 1.0 / value < 0.0 else "0"
	return String.num_scientific(value).replace("e+", "e").replace("e-0", "e-")


## The number that [param text] says, rounded correctly. NaN for what is no decimal number, has more
## than 18 digits, or is neither 0 nor within [constant SMALLEST] to [constant LARGEST] in size.
static func value_of(text: String) -> float:
	var found := _pattern.search(text)
	if not found:
		return NAN
	var decimals := found.get_string(3)
	var digits := (found.get_string(2) + decimals).lstrip("0")
	if digits.length() > _MOST_DIGITS:
		return NAN
	var size := _size_of(digits.to_int(), found.get_string(4).to_int() - decimals.length())
	return -size if found.get_string(1) else size


# whole * 10^exponent.
static func _size_of(whole: int, exponent: int) -> float:
	if whole == 0:
		return 0.0
	var rough := log(float(whole)) / log(10.0) + exponent
	# Beyond this 10^exponent would be out of range, too.
	if absf(rough) > 101.0:
		return NAN
	var power := _power_of_ten(absi(exponent))
	var number := _exactly(whole)
	number = number.times(power) if exponent >= 0 else number.divided(power)
	var size := number.to_float()
	return size if size >= SMALLEST and size <= LARGEST else NAN


# An int can have more bits than a double, so it is split into two parts.
static func _exactly(whole: int) -> DoubleDouble:
	var lower := whole % 1_000_000_000
	return DoubleDouble.sum_of(float(whole - lower), float(lower))


static func _power_of_ten(exponent: int) -> DoubleDouble:
	var power := DoubleDouble.from_float(1.0)
	var factor := DoubleDouble.from_float(10.0)
	var left := exponent
	while left > 0:
		if left % 2 == 1:
			power = power.times(factor)
		left >>= 1
		if left > 0:
			factor = factor.times(factor)
	return power
