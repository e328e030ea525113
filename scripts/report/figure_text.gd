class_name FigureText
extends RefCounted
## Numbers as the report writes them: two or three digits, with a power of ten if they are far from
## 1.


## Such as 12.3, 0.45 or 3.1e-13; "-" for a number that is not finite.
static func short(value: float) -> String:
	if value == 0.0:
		return "0"
	if not is_finite(value):
		return "-"
	var power := floori(log(absf(value)) / log(10.0) + 1e-12)
	if power < -3 or power > 5:
		return "%.1fe%d" % [value / 10.0 ** power, power]
	return String.num(value, maxi(2 - power, 0))


## The error of a measurement with its unit, or "no answer".
static func of(row: Measurement) -> String:
	return "%s %s" % [short(row.error), row.error_unit] if row.has_answer() else "no answer"


## The ratio of two numbers, such as 2.7; "-" where there is none.
static func ratio(one: float, other: float) -> String:
	if other == 0.0 or not is_finite(one) or not is_finite(other):
		return "-"
	return short(one / other)
