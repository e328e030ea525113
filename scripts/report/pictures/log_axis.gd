class_name LogAxis
extends RefCounted
## A logarithmic axis over whole decades. If needed, it has a row for 0 at its low end and a row for
## "no answer" at its high end.

## The label of the row for [constant Measurement.NO_ANSWER].
const NONE_TEXT := "none"

const _SUPERSCRIPTS := "⁰¹²³⁴⁵⁶⁷⁸⁹"
# The height of each extra row, as a fraction of the height of all decades.
const _ROW_SHARE := 0.1
## The power of ten at the low end of the decades.
var first := 0
## The power of ten at their high end, above [member first].
var last := 1
## Whether there is a row for 0.
var has_zero := false
## Whether there is a row for no answer.
var has_none := false


## An axis for these values, which are 0 or more, or [constant Measurement.NO_ANSWER].
func _init(values: PackedFloat64Array) -> void:
	var least := INF
	var greatest := 0.0
	for value in values:
		has_none = has_none or not is_finite(value)
		has_zero = has_zero or value == 0.0
		if value > 0.0 and is_finite(value):
			least = minf(least, value)
			greatest = maxf(greatest, value)
	if greatest > 0.0:
		first = floori(_power(least))
		last = maxi(ceili(_power(greatest)), first + 1)


## The position of a value: 0 at the low end of the axis, 1 at its high end.
func place(value: float) -> float:
	if value == 0.0:
		return 0.0
	if not is_finite(value):
		return 1.0
	return (_power(value) - first + _rows_below()) / _length()


## The values that have a mark and a label. With more than [param most] decades, only every second
## or third has one.
func ticks(most: int) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	if has_zero:
		found.append(0.0)
	var stride := ceili(float(last - first) / most)
	for power in range(first, last + 1, stride):
		found.append(10.0 ** power)
	if has_none:
		found.append(Measurement.NO_ANSWER)
	return found


## The label of a value of [method ticks], such as 10⁻⁹.
static func label(value: float) -> String:
	if value == 0.0:
		return "0"
	if not is_finite(value):
		return NONE_TEXT
	var text := ""
	for digit in str(roundi(_power(value))):
		text += "⁻" if digit == "-" else _SUPERSCRIPTS[digit.to_int()]
	return "10" + text


func _row() -> float:
	return maxf(1.0, _ROW_SHARE * (last - first))


func _rows_below() -> float:
	return _row() if has_zero else 0.0


func _length() -> float:
	return last - first + _rows_below() + (_row() if has_none else 0.0)


static func _power(value: float) -> float:
	return log(value) / log(10.0)
