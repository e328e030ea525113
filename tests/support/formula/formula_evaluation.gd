class_name FormulaEvaluation
extends RefCounted
## Works out what a side of a formula comes to, from the numbers that are shown.

## What each defined symbol is, and each side that was given a value, by [method FormulaNode.text].
var values: Dictionary[String, FormulaValue] = {}
## The meanings of symbols that stand for an expression.
var meanings: Dictionary[String, FormulaNode] = {}
## Why the last side has no value: what cannot be done with its numbers; "" for nothing.
var problem := ""
## Symbols without a value in the last side.
var missing: PackedStringArray = []

var _is_exact := false


## What [param node] comes to; null where it has no value. If [param is_exact], with exactly the
## numbers that it shows; else each may be off by half a unit of its last digit.
func value_of(node: FormulaNode, is_exact: bool) -> FormulaValue:
	problem = ""
	missing = []
	_is_exact = is_exact
	return _value(node)


## How much [param node], which shows its numbers with many digits, may be off by their rounding.
## Few digits are not rounded: the number would show more.
func spread_of(node: FormulaNode, component: int, fewest_digits: int) -> float:
	var shown := node.numbers()
	var units: Array[float] = []
	for number in shown:
		units.append(number.unit)
		if number.digits < fewest_digits:
			number.unit = 0.0
	var value := value_of(node, false)
	for i in shown.size():
		shown[i].unit = units[i]
	return (value.high[component] - value.low[component]) / 2.0 if value else 0.0


func _value(node: FormulaNode) -> FormulaValue:
	if node.kind == FormulaNode.Kind.NUMBER:
		return _number(node)
	if node.kind == FormulaNode.Kind.SYMBOL:
		return _symbol(node)
	var known := missing.size()
	var parts: Array[FormulaValue] = []
	for part in node.parts:
		parts.append(_value(part))
	if parts.has(null):
		# Such as e₁ / e₂, where only the quotient is shown.
		if not problem and values.has(node.text()):
			missing.resize(known)
			return values[node.text()]
		return null
	return _computed(node, parts)


func _number(node: FormulaNode) -> FormulaValue:
	if is_nan(node.number):
		problem = "NaN is shown"
		return null
	return FormulaValue.of(node.number, 0.0 if _is_exact or node.is_exact else node.unit / 2.0)


func _symbol(node: FormulaNode) -> FormulaValue:
	if values.has(node.name):
		return values[node.name]
	if meanings.has(node.name):
		return _value(meanings[node.name])
	var value := _joined(node.name)
	if not value:
		missing.append(node.name)
	return value


# Letters side by side: `bx` is a component of b, `ac` a product.
func _joined(letters: String) -> FormulaValue:
	if letters.length() < 2 or not values.has(letters[0]):
		return null
	var first := values[letters[0]]
	if first.is_list:
		var at := ["x", "y", "z"].find(letters.substr(1))
		return first.component(at) if at >= 0 and at < first.count() else null
	var product := first
	for letter in letters.substr(1):
		if not values.has(letter) or values[letter].is_list:
			return null
		product = product.scaled(values[letter])
	return product


func _computed(node: FormulaNode, parts: Array[FormulaValue]) -> FormulaValue:
	match node.kind:
		FormulaNode.Kind.LIST:
			return FormulaValue.list(parts)
		FormulaNode.Kind.SUM, FormulaNode.Kind.DIFFERENCE:
			return _sum(parts[0], parts[1], node.kind == FormulaNode.Kind.DIFFERENCE)
		FormulaNode.Kind.PRODUCT, FormulaNode.Kind.SIDE_BY_SIDE:
			return _product(parts[0], parts[1], node.kind == FormulaNode.Kind.PRODUCT)
		FormulaNode.Kind.QUOTIENT:
			return _quotient(parts[0], parts[1])
		FormulaNode.Kind.CALL:
			return _called(node.name, parts[0])
	return _changed(node, parts[0])


func _changed(node: FormulaNode, one: FormulaValue) -> FormulaValue:
	match node.kind:
		FormulaNode.Kind.NEGATIVE:
			return one.negated()
		FormulaNode.Kind.SIZE:
			return one.length()
		FormulaNode.Kind.SQUARE:
			return one.squared()
		FormulaNode.Kind.ROOT:
			return _root(one)
		FormulaNode.Kind.DEGREES:
			return one.scaled(FormulaValue.of(PI / 180.0))
	return _component(one, node.name)


func _sum(one: FormulaValue, other: FormulaValue, is_difference: bool) -> FormulaValue:
	if one.is_list != other.is_list or one.count() != other.count():
		return _impossible("a sum of a number and a list, or of lists that differ in length")
	return one.plus(other.negated() if is_difference else other)


func _product(one: FormulaValue, other: FormulaValue, has_dot: bool) -> FormulaValue:
	if one.is_list and other.is_list:
		if not has_dot or one.count() != other.count():
			return _impossible("two lists side by side")
		return one.dot(other)
	return one.scaled(other) if one.is_list else other.scaled(one)


func _quotient(one: FormulaValue, other: FormulaValue) -> FormulaValue:
	if other.is_list:
		return _impossible("division by a list")
	if other.low[0] == 0.0 and other.high[0] == 0.0:
		return _impossible("division by 0")
	return one.divided(other)


func _root(one: FormulaValue) -> FormulaValue:
	if one.is_list or one.high[0] < 0.0:
		return _impossible("the root of what is below 0")
	return one.root()


func _component(one: FormulaValue, axis: String) -> FormulaValue:
	if not one.is_list:
		return _impossible("a component of a number")
	return one.component(["x", "y"].find(axis))


func _called(function: String, argument: FormulaValue) -> FormulaValue:
	match function:
		"Vec2.new":
			return argument
		"atan2":
			return _angle(argument)
		"cos", "sin":
			return _wave(argument, cos if function == "cos" else sin)
		"log":
			if argument.low[0] <= 0.0:
				return _impossible("the logarithm of what is not above 0")
			return argument.mapped(func(x: float) -> float: return log(x))
	return argument.mapped(func(x: float) -> float: return float(int(x)))


# No more than the argument moves does a sine or cosine move.
func _wave(argument: FormulaValue, function: Callable) -> FormulaValue:
	var middle: float = function.call(argument.middle())
	var spread := (argument.high[0] - argument.low[0]) / 2.0
	return FormulaValue.between(middle - spread, middle + spread, 1.0)


func _angle(argument: FormulaValue) -> FormulaValue:
	var angles: PackedFloat64Array = []
	for y: float in [argument.low[0], argument.high[0]]:
		for x: float in [argument.low[1], argument.high[1]]:
			angles.append(atan2(y, x))
	angles.sort()
	return FormulaValue.between(angles[0], angles[-1], PI)


func _impossible(what: String) -> FormulaValue:
	if not problem:
		problem = what
	return null
