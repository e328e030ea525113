class_name FormulaStatement
extends RefCounted
## One statement of a formula, such as `a · b = 7·8 + 1·(−6) = 50`: finds how many digits its
## numbers need, so that it holds as it is shown.
##
## `6.0001·8 + 8·(−6) = 0.0008` holds; with `6·8` it would not. The result, a number alone on its
## side, has [constant RESULT_DIGITS] digits. The numbers on the other sides have as many, or more,
## until those numbers, as they are shown, give the result to within one unit of its last digit.
## A result that is nothing but rounding is written `0 (rounding: 4e−16)`.

## Digits of a result, and of other numbers unless the statement needs more.
const RESULT_DIGITS := 4
## A sum of at most this share of its terms is rounding: a few units in the last place.
const ROUNDING := 1.0 / 2.0 ** 50
## Where the result is 0, the numbers as they are shown must give less than this share of the terms,
## or what is called rounding; with few digits next to nothing: they would look exact.
const NEARLY_ZERO := 1e-8
const _ZERO := 1e-12
const _FEW_DIGITS := 5
# One unit of a single digit is as much as the number itself: 0 would do for 1e17.
const _FEWEST_RESULT_DIGITS := 2

# What a student types is this long at most; a longer number comes from a drag or a turn.
const _LONGEST_TYPED := 11
# The numbers of digits to try; a double needs 17 at most.
const _DIGITS: Array[int] = [4, 5, 6, 7, 8, 9, 10, 12, 15, 17]
const _NAME := "\\{(\\w+)\\}"
# What stands alone at an end of a pair, or of the two arguments of a function.
const _ARGUMENT := "(?<=\\()n(\\d+)(?=, )|(?<=, )n(\\d+)(?=\\))"
# A pair; before and after its comma there is at most one level of parentheses.
const _PAIR := "(?<![a-z2])\\(((?:[^(),]|\\([^()]*\\))*),((?:[^(),]|\\([^()]*\\))*)\\)"
# How to spell a side for [Expression], one after the other. Its names are n0, n1, ...
const _SPELLINGS: Dictionary[String, String] = {
	"−": "-",
	"·": "*",
	"²": "**2.0",
	"√(n\\d+)": "sqrt($1)",
	"√\\(": "sqrt(",
	"\\|([^|]*)\\|": "abs($1)",
	"cos (n\\d+)": "cos($1)",
	"2π": "(2.0 * PI)",
	"(?<=[\\d)])\\s+(?=[n(\\d])": " * ",
	"(?<![\\w.])(\\d+)(?![\\w.])": "$1.0",
}
# What may be in a side that can be computed, besides its names and functions.
const _NOT_COMPUTED := "[^-−+·*/(),.√²|\\d\\s]"
# The same before, where the statement has its angles in degrees.
const _SPELLINGS_OF_DEGREES: Dictionary[String, String] = {
	"atan2\\(": "180 / PI * atan2(",
	"cos (n\\d+)°": "cos(deg_to_rad($1))",
	"360°": "360",
}
# What is none of this can be computed, too.
const _COMPUTED := "cos n\\d+°?|atan2|360°|2π|\\bn\\d+"
const _OPERATOR := "[-−+·/√²|]|cos "

# The names in the order of the text; one may occur more than once.
var _names: PackedStringArray = []
var _variables: PackedStringArray = []
# Between the signs of equality, with n0, n1, ... for the names.
var _sides: PackedStringArray = []
# Angles are in degrees, and not in radians.
var _has_degrees := false
# The places of what stands alone between the parentheses and commas of a function or a pair.
var _arguments: PackedInt32Array = []
# How many components each name had when the following was found: 0 for a text.
var _sizes: PackedInt32Array = []
# For each side the place of its only number; -1 for a side that is more than one number.
var _alone: PackedInt32Array = []
# The place of the result among the names; -1 where nothing can be checked.
var _result := -1
# How many digits the result has now.
var _result_digits := RESULT_DIGITS
# For each component the sides that can be computed, and the same with the sizes of all terms added.
var _computed: Array[Array] = [[], []]
var _added: Array[Array] = [[], []]


## A number, or a pair of numbers, of a formula.
class Number:
	extends RefCounted
	## One component, or the two of a pair.
	var components: PackedFloat64Array
	## For each component the sum of the sizes of the terms that were added to get it; 0 where
	## nothing was added.
	var scales: PackedFloat64Array
	## The student can type over it: the field shows what was typed.
	var is_typed := false
	## How it is written where that is exact, such as `π/2`; "" for its digits.
	var written := ""


## Reads [param template], with names in braces.
func _init(template: String) -> void:
	var text := ""
	var at := 0
	for found in RegEx.create_from_string(_NAME).search_all(template):
		_variables.append("n%d" % _names.size())
		_names.append(found.get_string(1))
		text += template.substr(at, found.get_start() - at) + _variables[-1]
		at = found.get_end()
	text += template.substr(at)
	for found in RegEx.create_from_string(_ARGUMENT).search_all(text):
		_arguments.append((found.get_string(1) + found.get_string(2)).to_int())
	_sides = text.split(" = ")
	_has_degrees = text.contains("°")


## How the names are written, in the order of the template, where [param numbers] has the numbers
## by name; "" for a name without a number.
func texts(numbers: Dictionary[String, Number]) -> PackedStringArray:
	_read_sides(numbers)
	var terms := _terms(numbers)
	var digits := _digits_that_hold(numbers, terms)
	var found: PackedStringArray = []
	for place in _names.size():
		if _sizes[place] == 0:
			found.append("")
		elif place == _result:
			found.append(
				_text(numbers[_names[place]], _scales(numbers, terms), _result_digits, true)
			)
		else:
			var number := numbers[_names[place]]
			var is_alone := number.is_typed or place in _alone or place in _arguments
			found.append(_text(number, number.scales, _digits_of(number, digits), is_alone))
	return found


# Finds the result and the sides that can be computed; they depend on which names are numbers.
func _read_sides(numbers: Dictionary[String, Number]) -> void:
	var sizes: PackedInt32Array = []
	for name in _names:
		sizes.append(numbers[name].components.size() if numbers.has(name) else 0)
	if sizes == _sizes:
		return
	_sizes = sizes
	_result = -1
	_alone.clear()
	for side in _sides:
		_alone.append(_lone_number(side))
	_computed = [[], []]
	_added = [[], []]
	var last := _sides.size() - 1
	while last > 0 and _alone[last] < 0:
		last -= 1
	if last > 0:
		_result = _alone[last]
		for side in _sides.slice(0, last):
			_add_computed(side)


# The place of the only number in a side without operators; -1 where there are more, or none.
func _lone_number(side: String) -> int:
	var lone := -1
	if RegEx.create_from_string(_OPERATOR).search(side):
		return -1
	for place in _names_in(side):
		if _sizes[place] > 0:
			if lone >= 0:
				return -1
			lone = place
	return lone


func _names_in(side: String) -> PackedInt32Array:
	var places: PackedInt32Array = []
	for found in RegEx.create_from_string("\\bn(\\d+)").search_all(side):
		places.append(found.get_string(1).to_int())
	return places


# What is before a colon are words.
func _add_computed(whole_side: String) -> void:
	var side := whole_side.get_slice(": ", whole_side.get_slice_count(": ") - 1)
	for place in _names_in(side):
		if _sizes[place] == 0:
			return
	var without_names := RegEx.create_from_string(_COMPUTED).sub(side, "", true)
	if RegEx.create_from_string(_NOT_COMPUTED).search(without_names) or not _names_in(side):
		return
	for component in _sizes[_result]:
		var spelled := RegEx.create_from_string(_PAIR).sub(side, "($%d)" % (component + 1), true)
		if _has_degrees:
			spelled = _spelled(spelled, _SPELLINGS_OF_DEGREES)
		spelled = _spelled(spelled, _SPELLINGS)
		_append_parsed(_computed[component], spelled)
		_append_parsed(_added[component], spelled.replace("-", "+"))


static func _spelled(side: String, spellings: Dictionary[String, String]) -> String:
	var spelled := side
	for pattern in spellings:
		spelled = RegEx.create_from_string(pattern).sub(spelled, spellings[pattern], true)
	return spelled


func _append_parsed(expressions: Array, text: String) -> void:
	var expression := Expression.new()
	if expression.parse(text, _variables) == OK:
		expressions.append(expression)


# For each component of the result the sum of the sizes of the terms that the statement shows.
func _terms(numbers: Dictionary[String, Number]) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	if _result >= 0:
		var result := numbers[_names[_result]]
		for component in result.components.size():
			var terms := 0.0
			for expression: Expression in _added[component]:
				terms = maxf(terms, _value(expression, _inputs(numbers, component, 17, true)))
			found.append(terms)
	return found


# The same, with the terms that it does not show.
func _scales(numbers: Dictionary[String, Number], terms: PackedFloat64Array) -> PackedFloat64Array:
	var scales := terms.duplicate()
	for component in scales.size():
		scales[component] = maxf(terms[component], numbers[_names[_result]].scales[component])
	return scales


# Where rounding leaves little of the result, only its first digits hold. Those of a whole number
# are all shown: where too few hold, the other numbers have all that they have.
func _digits_that_hold(numbers: Dictionary[String, Number], terms: PackedFloat64Array) -> int:
	for result_digits in range(RESULT_DIGITS, _FEWEST_RESULT_DIGITS - 1, -1):
		_result_digits = result_digits
		for digits in _DIGITS:
			if _holds(numbers, terms, digits):
				return digits
	_result_digits = RESULT_DIGITS
	return _DIGITS[-1]


# Whether the numbers as they are shown with so many digits give the result as it is shown.
func _holds(numbers: Dictionary[String, Number], terms: PackedFloat64Array, digits: int) -> bool:
	var scales := _scales(numbers, terms)
	for component in terms.size():
		var result := numbers[_names[_result]].components[component]
		var shown := _shown(result, scales[component], _result_digits)
		shown = result if numbers[_names[_result]].written else shown
		var tolerance := NumberText.last_digit(result, _result_digits)
		if shown == 0.0 and digits <= _FEW_DIGITS:
			tolerance = terms[component] * _ZERO
		elif shown == 0.0:
			tolerance = maxf(terms[component] * NEARLY_ZERO, absf(result))
		for expression: Expression in _computed[component]:
			var value := _value(expression, _inputs(numbers, component, digits, false))
			# Rounded to 0 / 0, the numbers give no result at all.
			if is_finite(shown) and not absf(value - shown) <= tolerance * 1.0001:
				return false
	return true


func _inputs(
	numbers: Dictionary[String, Number], component: int, digits: int, are_sizes: bool
) -> Array[float]:
	var inputs: Array[float] = []
	for place in _names.size():
		var value := 0.0
		if _sizes[place] > 0:
			var number := numbers[_names[place]]
			var at := mini(component, _sizes[place] - 1)
			value = _shown(number.components[at], number.scales[at], _digits_of(number, digits))
			value = number.components[at] if number.written else value
		inputs.append(absf(value) if are_sizes else value)
	return inputs


static func _value(expression: Expression, inputs: Array[float]) -> float:
	var value: Variant = expression.execute(inputs, null, false)
	return value if value is float else NAN


# A number that is alone, an argument, or a pair, needs no parentheses around a minus sign.
static func _text(number: Number, terms: PackedFloat64Array, digits: int, is_alone: bool) -> String:
	var parts: PackedStringArray = []
	var rounding := 0.0
	for component in number.components.size():
		var value := number.components[component]
		if _is_rounding(value, terms[component]):
			rounding = maxf(rounding, absf(value))
			value = 0.0
		parts.append(NumberText.short(value, digits))
	var text := parts[0] if parts.size() == 1 else "(%s)" % ", ".join(parts)
	if number.written:
		text = number.written
		rounding = 0.0
	if rounding > 0.0 and is_alone:
		text += " " + LabText.translate("(rounding: %s)") % NumberText.size(rounding)
	elif parts.size() == 1 and text.begins_with(NumberText.MINUS) and not is_alone:
		text = "(%s)" % text
	return text


# What was typed is shown as it was typed.
static func _digits_of(number: Number, digits: int) -> int:
	if number.is_typed and NumberText.typed(number.components[0]).length() <= _LONGEST_TYPED:
		return 12
	return digits


static func _is_rounding(value: float, terms: float) -> bool:
	return absf(value) <= ROUNDING * terms


static func _shown(value: float, terms: float, digits: int) -> float:
	return 0.0 if _is_rounding(value, terms) else NumberText.rounded(value, digits)
