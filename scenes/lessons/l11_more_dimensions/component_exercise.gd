class_name ComponentExercise
extends Exercise
## Asks for a dot product of three to five whole-number components, or for the component that makes
## the angle right.

## What is asked for.
enum Kind { DOT, MISSING }

## The vectors of the question, three to five components each.
var a: PackedFloat64Array
var b: PackedFloat64Array

var _solution := ""


## A question on the vectors [param one] and [param other], which are equally long; for
## [constant Kind.MISSING] the last component of a is 1 or -1, and that of b is asked for.
func _init(kind: Kind, one: PackedFloat64Array, other: PackedFloat64Array) -> void:
	a = one
	b = other
	if kind == Kind.DOT:
		_ask_dot()
	else:
		_ask_missing()


## A question with components drawn from [param rng], none of them 0; three to five of them.
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> ComponentExercise:
	var dimension := rng.randi_range(3, MoreDimensionsModel.MOST)
	var one := _random_list(dimension, rng)
	var other := _random_list(dimension, rng)
	if kind == Kind.MISSING:
		one[dimension - 1] = 1.0 if one[dimension - 1] > 0.0 else -1.0
	return new(kind, one, other)


## The vectors of the question; the other components stay as they are.
func board_state() -> Dictionary:
	var found := {
		"a": a.slice(0, MoreDimensionsModel.IN_LISTS),
		"b": b.slice(0, MoreDimensionsModel.IN_LISTS),
		"has_four": a.size() == 4,
		"has_five": a.size() == MoreDimensionsModel.MOST,
	}
	if a.size() == MoreDimensionsModel.MOST:
		found["fifth"] = PackedFloat64Array([a[-1], b[-1]])
	return found


func solution() -> String:
	return _solution


static func _random_list(dimension: int, rng: RandomNumberGenerator) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	for i in dimension:
		found.append(rng.randi_range(1, 6) * (1 if rng.randi_range(0, 1) == 1 else -1))
	return found


func _ask_dot() -> void:
	prompt = tr("a = %s, b = %s. What is a · b?") % [_text(a, a.size()), _text(b, b.size())]
	answer_titles = ["a · b ="]
	var right := ComponentLists.dot(a, b)
	right_answer = [right]
	_solution = "a · b = %s = %s" % [_products(), NumberText.short(right)]
	var last := a.size() - 1
	add_mistake([right - a[last] * b[last]], tr("The last component counts, too."))
	add_mistake([-right], tr("The sign is wrong: unlike signs make a product negative."))
	add_mistake([_sum_of_sizes()], tr("The signs are missing: some products are negative."))
	add_mistake([_sum(a) * _sum(b)], tr("Multiply first, component by component; then add."))
	add_mistake([_sum(a) + _sum(b)], tr("The components are multiplied, not added."))


func _ask_missing() -> void:
	var last := a.size() - 1
	var known := ComponentLists.dot(a.slice(0, last), b.slice(0, last))
	var wanted := -known / a[last]
	b[last] = wanted
	var question := tr("a = %s, b = %s. Which last component of b makes a right angle?")
	prompt = question % [_text(a, a.size()), _text(b, last)]
	answer_titles = [tr("last of b =")]
	right_answer = [wanted]
	_solution = (
		tr("The other products add up to %s, so the last component is −(%s) / %s = %s.")
		% [
			NumberText.short(known),
			NumberText.short(known),
			_in_product(a[last]),
			NumberText.short(wanted),
		]
	)
	add_mistake([-wanted], tr("The sign is wrong: the products must add up to 0."))
	add_mistake([-a[last]], tr("Not the opposite of a's: all products together must be 0."))
	add_mistake([0.0], tr("Then a · b is %s, not 0.") % NumberText.short(known))


func _sum_of_sizes() -> float:
	var sum := 0.0
	for i in a.size():
		sum += absf(a[i] * b[i])
	return sum


# 4·2 + (−3)·(−4) + ...
func _products() -> String:
	var parts: PackedStringArray = []
	for i in a.size():
		parts.append("%s·%s" % [_in_product(a[i]), _in_product(b[i])])
	return " + ".join(parts)


static func _in_product(value: float) -> String:
	var text := NumberText.short(value)
	return "(%s)" % text if value < 0.0 else text


static func _sum(list: PackedFloat64Array) -> float:
	var sum := 0.0
	for component in list:
		sum += component
	return sum


# The first [param known] components in parentheses, a question mark for each of the others.
static func _text(list: PackedFloat64Array, known: int) -> String:
	var parts: PackedStringArray = []
	for i in list.size():
		parts.append(NumberText.short(list[i]) if i < known else "?")
	return "(%s)" % ", ".join(parts)
