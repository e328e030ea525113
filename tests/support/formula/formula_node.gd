class_name FormulaNode
extends RefCounted
## A part of a formula as it is read: a number, a symbol, or an operation on other parts.

## What a part is.
enum Kind {
	NUMBER,
	SYMBOL,
	LIST,
	SUM,
	DIFFERENCE,
	PRODUCT,
	SIDE_BY_SIDE,
	QUOTIENT,
	NEGATIVE,
	SIZE,
	ROOT,
	SQUARE,
	DEGREES,
	COMPONENT,
	CALL
}

## What this is.
var kind: Kind
## A symbol's letters, a function's name, or `x` and `y` of a component.
var name := ""
## What it is made of, in the order of reading.
var parts: Array[FormulaNode] = []
## The number that is shown.
var number := 0.0
## One unit of the last digit that a number could show with 4 digits, or of those it shows if more;
## 0 for 0.
var unit := 0.0
## The number is not rounded, such as π/2.
var is_exact := false
## How many digits the number shows.
var digits := 0
## The most that the remark `(rounding: 4e−16)` behind it can mean; 0 without one.
var rounding := 0.0


## A part of [param its_kind], made of [param its_parts].
func _init(its_kind: Kind, its_parts: Array[FormulaNode] = [], its_name: String = "") -> void:
	kind = its_kind
	parts = its_parts
	name = its_name


## A number or a list of numbers alone, with or without a sign and a degree sign: a result.
func is_result() -> bool:
	match kind:
		Kind.NUMBER:
			return true
		Kind.NEGATIVE, Kind.DEGREES:
			return parts[0].kind != Kind.LIST and parts[0].is_result()
		Kind.LIST:
			return parts.all(func(part: FormulaNode) -> bool: return part.is_result())
	return false


## The symbols in it.
func symbols() -> PackedStringArray:
	var found: PackedStringArray = []
	if kind == Kind.SYMBOL:
		found.append(name)
	for part in parts:
		found.append_array(part.symbols())
	return found


## The numbers in it.
func numbers() -> Array[FormulaNode]:
	var found: Array[FormulaNode] = []
	if kind == Kind.NUMBER:
		found.append(self)
	for part in parts:
		found.append_array(part.numbers())
	return found


## The same text for the same formula.
func text() -> String:
	if kind == Kind.NUMBER:
		return str(number)
	if kind == Kind.SYMBOL:
		return name
	var texts := parts.map(func(part: FormulaNode) -> String: return part.text())
	return "%s%s(%s)" % [Kind.keys()[kind], name, ", ".join(texts)]
