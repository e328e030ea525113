class_name NumberText
extends RefCounted
## Numbers as a student reads them, and typed text as a number.

## The true minus sign, as wide as a plus.
const MINUS := "\u2212"


## [param value] with at most [param digits] significant digits, or as many as there are before the
## point, and without trailing zeros: `7`, `0.8`, `-3.25`, `12346`; below 1e-4 and from 1e7 on as
## `3e15`. NaN and infinity by name.
static func short(value: float, digits: int = 4) -> String:
	if is_nan(value):
		return "NaN"
	if is_inf(value):
		return MINUS + "\u221e" if value < 0.0 else "\u221e"
	if value == 0.0:
		return "0"
	var text := _scientific(value, digits) if _is_unhandy(value) else _decimal(value, digits)
	return text.replace("-", MINUS)


## What [method short] writes, with plain ASCII signs, for a field that is typed into.
static func typed(value: float) -> String:
	return short(value, 12).replace(MINUS, "-")


## Two components in parentheses: `(4, -3)`.
static func pair(x: float, y: float, digits: int = 4) -> String:
	return "(%s, %s)" % [short(x, digits), short(y, digits)]


## [param value] with all the digits that tell it from the next double: `5.000000000000001`.
static func all_digits(value: float) -> String:
	return String.num_scientific(value).replace("-", MINUS)


## A size that needs no sign and no more than two digits, such as an error: `0`, `8.9e-16`.
static func size(value: float) -> String:
	return short(absf(value), 2)


## A number in a sum or product: a negative one is put in parentheses.
static func factor(value: float, digits: int = 4) -> String:
	return "(%s)" % short(value, digits) if value < 0.0 else short(value, digits)


## The number that [method short] shows, to a unit in the last place: [param value] with
## [param digits] digits. Called many times a frame, so the engine reads the text.
static func rounded(value: float, digits: int = 4) -> float:
	if not is_finite(value):
		return value
	return short(value, digits).replace(MINUS, "-").to_float()


## One unit of the last digit that [method short] shows of [param value], if no zero were left out:
## 0.01 for 12.5 with 4 digits, and 1 from 1000 on; 0 for 0 and for what is not finite.
static func last_digit(value: float, digits: int = 4) -> float:
	if value == 0.0 or not is_finite(value):
		return 0.0
	var exponent := floori(log(absf(value)) / log(10.0) + 1e-12)
	var last := exponent - digits + 1
	return pow(10.0, last if _is_unhandy(value) else mini(last, 0))


## "" if [param text] is a number that [DecimalText] takes; else one sentence with the text and what
## is allowed.
static func problem(text: String) -> String:
	if not is_nan(parse(text)):
		return ""
	var sentence := (
		LabText
		. translate(
			"“%s” cannot be taken: type 0 or a number from 1e-100 to 1e100 in size, like 7, -2.5 or 3e8."
		)
	)
	return sentence % LessonLink.quoted(text)


## The number in [param text], for a text without a [method problem]. A fraction of two numbers such
## as `2/5` is one, too.
static func parse(text: String) -> float:
	var parts := text.split("/")
	if parts.size() != 2:
		return DecimalText.value_of(text)
	var divisor := DecimalText.value_of(parts[1])
	var fraction := DecimalText.value_of(parts[0]) / divisor if divisor != 0.0 else NAN
	# As small and as large as a number that is typed without a fraction.
	return fraction if not is_nan(DecimalText.value_of(DecimalText.of(fraction))) else NAN


static func _is_unhandy(value: float) -> bool:
	return absf(value) < 1e-4 or absf(value) >= 1e7


static func _decimal(value: float, digits: int) -> String:
	var whole_digits := floori(log(absf(value)) / log(10.0)) + 1
	var text := String.num(value, maxi(digits - whole_digits, 0))
	if text.contains("."):
		text = text.rstrip("0").rstrip(".")
	return "0" if text == "-0" else text


static func _scientific(value: float, digits: int) -> String:
	var exponent := floori(log(absf(value)) / log(10.0) + 1e-12)
	# In two parts: 10^-324 itself is too small for a double.
	var half := floori(exponent / 2.0)
	var mantissa := _decimal(value / pow(10.0, half) / pow(10.0, exponent - half), digits)
	if mantissa.trim_prefix("-") == "10":
		mantissa = mantissa.replace("10", "1")
		exponent += 1
	return "%se%d" % [mantissa, exponent]
