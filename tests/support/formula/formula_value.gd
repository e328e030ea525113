class_name FormulaValue
extends RefCounted
## What a formula's side comes to: for each component an interval, as shown numbers are rounded.
## Exact numbers have intervals without width.

## The least that each component can be.
var low: PackedFloat64Array = []
## The most that each component can be.
var high: PackedFloat64Array = []
## The sum of the sizes of the terms that were added for each component.
var size: PackedFloat64Array = []
## It is a pair or a list, not a number.
var is_list := false


## The number [param number], uncertain by [param spread].
static func of(number: float, spread: float = 0.0) -> FormulaValue:
	return between(number - spread, number + spread, absf(number))


## A number from [param least] to [param most]; its terms add up to [param terms] in size.
static func between(least: float, most: float, terms: float) -> FormulaValue:
	var value := FormulaValue.new()
	value._append(least, most, terms)
	return value


## A list of numbers.
static func list(numbers: Array[FormulaValue]) -> FormulaValue:
	var value := FormulaValue.new()
	value.is_list = true
	for number in numbers:
		value._append(number.low[0], number.high[0], number.size[0])
	return value


## How many components it has.
func count() -> int:
	return low.size()


## The component [param at] as a number.
func component(at: int) -> FormulaValue:
	return between(low[at], high[at], size[at])


## The middle of the component [param at].
func middle(at: int = 0) -> float:
	return low[at] if low[at] == high[at] else low[at] / 2.0 + high[at] / 2.0


func plus(other: FormulaValue) -> FormulaValue:
	var sum := _like(self)
	for i in count():
		sum._append(low[i] + other.low[i], high[i] + other.high[i], size[i] + other.size[i])
	return sum


func negated() -> FormulaValue:
	var opposite := _like(self)
	for i in count():
		opposite._append(-high[i], -low[i], size[i])
	return opposite


## Each component times the number [param factor].
func scaled(factor: FormulaValue) -> FormulaValue:
	var product := _like(self)
	for i in count():
		var ends: PackedFloat64Array = [
			low[i] * factor.low[0],
			low[i] * factor.high[0],
			high[i] * factor.low[0],
			high[i] * factor.high[0]
		]
		product._append_range(ends, size[i] * factor.size[0])
	return product


## The sum of the products of the components of two lists.
func dot(other: FormulaValue) -> FormulaValue:
	var sum := of(0.0)
	for i in count():
		sum = sum.plus(component(i).scaled(other.component(i)))
	return sum


## Each component divided by the number [param divisor], which is not 0 but may come near it.
func divided(divisor: FormulaValue) -> FormulaValue:
	var quotient := _like(self)
	var is_near_zero := divisor.low[0] <= 0.0 and divisor.high[0] >= 0.0
	for i in count():
		var terms := size[i] / absf(divisor.middle()) if divisor.middle() != 0.0 else 0.0
		if is_near_zero:
			quotient._append(-INF, INF, terms)
			continue
		var ends: PackedFloat64Array = [
			low[i] / divisor.low[0],
			low[i] / divisor.high[0],
			high[i] / divisor.low[0],
			high[i] / divisor.high[0]
		]
		quotient._append_range(ends, terms)
	return quotient


## The number times itself, or the list's dot product with itself.
func squared() -> FormulaValue:
	var sum := of(0.0)
	for i in count():
		var far := maxf(absf(low[i]), absf(high[i]))
		sum = sum.plus(between(_nearest(i) ** 2.0, far * far, size[i] * size[i]))
	return sum


## The square root of a number that is not below 0.
func root() -> FormulaValue:
	return between(sqrt(maxf(low[0], 0.0)), sqrt(maxf(high[0], 0.0)), sqrt(size[0]))


## The size of a number, or the length of a list.
func length() -> FormulaValue:
	if is_list:
		return squared().root()
	return between(_nearest(0), maxf(absf(low[0]), absf(high[0])), size[0])


## What [param function], which grows or shrinks all the way, makes of a number.
func mapped(function: Callable) -> FormulaValue:
	var one: float = function.call(low[0])
	var other: float = function.call(high[0])
	var value := FormulaValue.new()
	value._append_range([one, other], maxf(absf(one), absf(other)))
	return value


# The least size that a component can have.
func _nearest(at: int) -> float:
	if low[at] <= 0.0 and high[at] >= 0.0:
		return 0.0
	return minf(absf(low[at]), absf(high[at]))


func _append_range(ends: PackedFloat64Array, terms: float) -> void:
	ends.sort()
	_append(ends[0], ends[-1], terms)


func _append(least: float, most: float, terms: float) -> void:
	low.append(least)
	high.append(most)
	size.append(terms)


static func _like(other: FormulaValue) -> FormulaValue:
	var value := FormulaValue.new()
	value.is_list = other.is_list
	return value
