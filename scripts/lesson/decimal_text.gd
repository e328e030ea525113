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

const _PATTERN := "^([+-]?)(?=\\.?\\d)(\\d*)(?:\\.(\\d*))?(?:e([+-]?0*\\d{1,3}))?\\z"
# More digits change nothing in a double: DoubleDouble has 31.
const _MOST_DIGITS := 36
# So many digits at once are read into an int.
const _DIGITS_AT_ONCE := 9
# Letters of full width, as East Asian keyboards write them, and their distance from ASCII.
const _FULL_WIDTH := 0xff01
const _FROM_ASCII := 0xfee0

static var _pattern := RegEx.create_from_string(_PATTERN)


## [param value], which must be finite, with as few digits as tell it from every other double (in
## one of 1000 numbers one more): `7`, `-0.1`, `3e15`.
static func of(value: float) -> String:
	if value == 0.0:
		return "-0" if 1.0 / value < 0.0 else "0"
	return String.num_scientific(value).replace("e+", "e").replace("e-0", "e-")


## The number that [param text] says, rounded correctly, in any of the ways in which people write
## it: `-2.5`, `+3`, `1,5`, `.5`, `3E8`, with a true minus, with spaces around it. NaN for what is
## no decimal number, or is neither 0 nor within [constant SMALLEST] to [constant LARGEST] in size.
static func value_of(text: String) -> float:
	var found := _pattern.search(_in_ascii(text))
	if not found:
		return NAN
	var decimals := found.get_string(3)
	var digits := (found.get_string(2) + decimals).lstrip("0")
	var size := _size_of(digits, found.get_string(4).to_int() - decimals.length())
	return -size if found.get_string(1) == "-" else size


static func _in_ascii(text: String) -> String:
	# A space that breaks no line, as it is copied from pages: the engine does not take it for one.
	var plain := text.replace("\u00a0", " ").strip_edges()
	for i in plain.length():
		var code := plain.unicode_at(i)
		if code == 0x2212 or code == 0xfe63 or (code >= 0x2010 and code <= 0x2014):
			# A minus sign or dash, as word processors and people who write formulas put it.
			plain[i] = "-"
		elif code >= _FULL_WIDTH:
			plain[i] = String.chr(code - _FROM_ASCII)
	return plain.to_lower().replace(",", ".")


# digits * 10^exponent, for digits that do not begin with 0.
static func _size_of(digits: String, exponent: int) -> float:
	if not digits:
		return 0.0
	# 10^power is just above the number. Far beyond the range it could not be computed.
	var power := digits.length() + exponent
	if absi(power) > 101:
		return NAN
	var kept := digits.left(_MOST_DIGITS)
	var places := power - kept.length()
	var scale := _power_of_ten(absi(places))
	var whole := _exactly(kept)
	var size := (whole.times(scale) if places >= 0 else whole.divided(scale)).to_float()
	return size if size >= SMALLEST and size <= LARGEST else NAN


static func _exactly(digits: String) -> DoubleDouble:
	var number := DoubleDouble.from_float(0.0)
	for at in range(0, digits.length(), _DIGITS_AT_ONCE):
		var part := digits.substr(at, _DIGITS_AT_ONCE)
		number = number.times(DoubleDouble.from_float(10.0 ** part.length()))
		number = number.plus(DoubleDouble.from_float(part.to_int()))
	return number


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
