class_name FormulaReader
extends RefCounted
## Reads the lines of a formula as a student does, and works them out again: with the numbers that
## are shown, each line must give what it says.
##
## Knows nothing of how the lab computes.
##
## A side with numbers alone must give the result, the last number or pair that stands alone on its
## side, to within one unit of the last digit that it could show with 4 digits. A side with symbols
## is worked out with the numbers of the other lines; each may be off by half a unit of its last
## digit.

## A sum of at most this share of its terms is rounding; it has to be shown as 0.
const ROUNDING := 1.0 / 2.0 ** 50
## Where 0 is shown, a sum is at most this share of its terms, or what is said to be rounding.
const ZERO := 1e-12
## A number with so many digits has been rounded: else it would show less.
const MANY_DIGITS := 6

const _GAP := "\\s{3,}|\\t|→"
# A remark that a line is wrong on purpose.
const _CROSS := "✗ "
const _SLACK := 1.0001
# What has a value of its own wherever it stands in a chain; an expression has one at its beginning.
const _NAMES: Array[FormulaNode.Kind] = [
	FormulaNode.Kind.SYMBOL,
	FormulaNode.Kind.COMPONENT,
	FormulaNode.Kind.CALL,
	FormulaNode.Kind.SIZE,
]
const _MOST_KEPT := 5000

static var _gap_finder := RegEx.create_from_string(_GAP)

# What was read, by line: the same lines come at every step.
var _read: Dictionary[String, Array] = {}

var _words: FormulaWords
var _evaluation: FormulaEvaluation
var _problems: PackedStringArray = []
# The statements of each line; one that begins with a relation goes on with the one before.
var _statements: Array[FormulaParser] = []
var _lines: PackedStringArray = []


## Reads formulas with these words.
func _init(words: FormulaWords = FormulaWords.new()) -> void:
	_words = words


## What is false in [param lines], a sentence each with the line.
func problems(lines: PackedStringArray) -> PackedStringArray:
	_problems = []
	_statements = []
	_lines = []
	_evaluation = FormulaEvaluation.new()
	for symbol in _words.meanings:
		_evaluation.meanings[symbol] = _parsed(_words.meanings[symbol])[0].sides[0]
	for line in lines:
		_add_line(line)
	for statement in _statements:
		_define(statement)
	for i in _statements.size():
		_judge(_statements[i], _lines[i])
	return _problems


func _add_line(line: String) -> void:
	for statement in _parsed(line):
		if statement.problem:
			_tell(line, statement.problem)
			continue
		var goes_on := statement.sides[0] == null and statement.relations and _statements
		if goes_on and line.strip_edges().begins_with(statement.relations[0]):
			var whole := FormulaParser.new()
			whole.sides = _statements[-1].sides + statement.sides.slice(1)
			whole.relations = _statements[-1].relations + statement.relations
			_statements[-1] = whole
			_lines[-1] += "  " + line.strip_edges()
		else:
			_statements.append(statement)
			_lines.append(line)


func _parsed(line: String) -> Array[FormulaParser]:
	if _read.size() > _MOST_KEPT:
		_read.clear()
	if not _read.has(line):
		_read[line] = _newly_parsed(line)
	return _read[line]


func _newly_parsed(line: String) -> Array[FormulaParser]:
	var text := line.replace(_CROSS, "")
	for phrase in _words.words:
		text = _without(text, phrase)
	var statements: Array[FormulaParser] = []
	for part in _gap_finder.sub(text.strip_edges(), "\t", true).split("\t", false):
		statements.append_array(FormulaParser.read(part, _words.digits))
	return statements


# A phrase is not found within a longer word.
static func _without(text: String, phrase: String) -> String:
	var at := text.find(phrase)
	while at >= 0:
		var end := at + phrase.length()
		if _is_letter(text, at - 1, phrase[0]) or _is_letter(text, end, phrase[-1]):
			at = text.find(phrase, end)
		else:
			text = text.left(at) + FormulaParser.WORDS + text.substr(end)
			at = text.find(phrase, at)
	return text


static func _is_letter(text: String, at: int, beside: String) -> bool:
	if at < 0 or at >= text.length() or beside.to_upper() == beside.to_lower():
		return false
	return text[at].to_upper() != text[at].to_lower()


# Gives the first sides of a chain the value of its result.
func _define(statement: FormulaParser) -> void:
	var named := _named(statement)
	if named:
		_give(named[0], _evaluation.value_of(named[1], false))
		return
	var value := _shown_value(statement)
	if value and statement.relations and statement.relations[0] == "=":
		for i in statement.sides.size():
			var side := statement.sides[i]
			if side and (i == 0 or side.kind in _NAMES):
				_give(side, value)


func _give(side: FormulaNode, value: FormulaValue) -> void:
	if value and side.symbols() and not _evaluation.value_of(side, false):
		_evaluation.values[side.text()] = value


# The result of a chain; else what its first side with numbers alone comes to.
func _shown_value(statement: FormulaParser) -> FormulaValue:
	var result := _result(statement)
	if result >= 0:
		var shown := statement.sides[result]
		var value := _evaluation.value_of(shown, false)
		return value
	for side in statement.sides:
		if side and side.numbers() and side.symbols().is_empty():
			return _evaluation.value_of(side, false)
	return null


# A symbol with its number or pair beside it: `old (6, −13)`. Empty where it is none.
static func _named(statement: FormulaParser) -> Array[FormulaNode]:
	var side := statement.sides[0]
	if statement.relations or not side or side.kind != FormulaNode.Kind.SIDE_BY_SIDE:
		return []
	if side.parts[0].kind == FormulaNode.Kind.SYMBOL and side.parts[1].is_result():
		return side.parts
	return []


static func _result(statement: FormulaParser) -> int:
	for i in range(statement.sides.size() - 1, -1, -1):
		if statement.sides[i] and statement.sides[i].is_result():
			return i
	return -1


func _judge(statement: FormulaParser, line: String) -> void:
	for side in statement.sides:
		if side and side.numbers().any(func(one: FormulaNode) -> bool: return is_nan(one.number)):
			_tell(line, "NaN is shown")
			return
	var named := _named(statement)
	if named:
		_compare(named[0], named[1], line)
	elif statement.relations.is_empty():
		_judge_alone(statement.sides[0], line)
	elif statement.relations.count("=") < statement.relations.size():
		_judge_relations(statement, line)
	else:
		_judge_chain(statement, line)


# Says nothing by itself, but all of it must be known.
func _judge_alone(side: FormulaNode, line: String) -> void:
	if side and not _evaluation.value_of(side, false):
		for symbol in _evaluation.missing:
			if symbol.length() > 2 and not symbol in _words.not_shown:
				_tell(line, "cannot read “%s”" % symbol)
		if _evaluation.problem:
			_tell(line, _evaluation.problem)


func _judge_chain(statement: FormulaParser, line: String) -> void:
	var result := _result(statement)
	if result >= 0:
		for i in statement.sides.size():
			if i != result and statement.sides[i]:
				var is_first := i == 0
				_compare(statement.sides[i], statement.sides[result], line, is_first)
		return
	_judge_without_result(statement, line)


# All sides that have a value must be able to be the same.
func _judge_without_result(statement: FormulaParser, line: String) -> void:
	var first: FormulaValue = null
	for side in statement.sides:
		if not side:
			continue
		var value := _evaluation.value_of(side, false)
		if _evaluation.problem:
			_tell(line, _evaluation.problem)
		if not value:
			continue
		if first and first.count() == value.count():
			for i in value.count():
				var slack := ROUNDING * maxf(value.size[i], first.size[i])
				if value.low[i] > first.high[i] + slack or value.high[i] < first.low[i] - slack:
					_tell(line, "%s and %s" % [_text(first), _text(value)])
					return
		first = first if first else value


func _judge_relations(statement: FormulaParser, line: String) -> void:
	for i in statement.relations.size():
		var left := statement.sides[i]
		var right := statement.sides[i + 1]
		if not left or not right:
			continue
		var one := _evaluation.value_of(left, false)
		var other := _evaluation.value_of(right, false)
		if not one or not other or one.is_list or other.is_list:
			continue
		if not _can_hold(one, statement.relations[i], other):
			_tell(line, "%s %s %s" % [_text(one), statement.relations[i], _text(other)])


static func _can_hold(one: FormulaValue, relation: String, other: FormulaValue) -> bool:
	match relation:
		"<":
			return one.low[0] < other.high[0]
		">":
			return one.high[0] > other.low[0]
		"≤":
			return one.low[0] <= other.high[0]
		"≥":
			return one.high[0] >= other.low[0]
	return one.low[0] <= other.high[0] and one.high[0] >= other.low[0]


# Whether a side can be what is shown as the result.
func _compare(
	side: FormulaNode, result: FormulaNode, line: String, is_definition: bool = true
) -> void:
	var is_exact := side.symbols().is_empty()
	var value := _evaluation.value_of(side, is_exact)
	var problem := _evaluation.problem
	if not problem and not value and not is_definition:
		for symbol in _evaluation.missing:
			if not symbol in _words.not_shown:
				problem = "“%s” is not shown" % symbol
	if problem:
		_tell(line, problem)
	if not value:
		return
	var shown := _evaluation.value_of(result, true)
	if not shown:
		_tell(line, _evaluation.problem)
		return
	if shown.count() != value.count() or shown.is_list != value.is_list:
		_tell(line, "a number and a list")
		return
	for i in value.count():
		if not _is_shown_as(value, i, shown.middle(i), side, result):
			_tell(line, "%s, not %s" % [_text(value), _text(shown)])
			return


func _is_shown_as(
	value: FormulaValue, at: int, shown: float, side: FormulaNode, result: FormulaNode
) -> bool:
	var low := value.low[at]
	var high := value.high[at]
	var size := value.size[at]
	if shown == low and shown == high:
		return true
	if shown == 0.0:
		var off := ZERO * size
		if low == high and absf(low) > off:
			off += maxf(_evaluation.spread_of(side, at, MANY_DIGITS), result.rounding)
		return low <= off and high >= -off
	if absf(shown) <= ROUNDING * size:
		return false
	var tolerance := _unit(result, at) * _SLACK + ROUNDING * size
	return low <= shown + tolerance and high >= shown - tolerance


static func _unit(result: FormulaNode, at: int) -> float:
	match result.kind:
		FormulaNode.Kind.LIST:
			return _unit(result.parts[at], 0)
		FormulaNode.Kind.NEGATIVE:
			return _unit(result.parts[0], at)
		FormulaNode.Kind.DEGREES:
			return _unit(result.parts[0], at) * PI / 180.0
	return result.unit


static func _text(value: FormulaValue) -> String:
	var texts: PackedStringArray = []
	for i in value.count():
		var text := String.num_scientific(value.low[i])
		if value.low[i] != value.high[i]:
			text = "%s..%s" % [text, String.num_scientific(value.high[i])]
		texts.append(text)
	return "(%s)" % ", ".join(texts) if value.is_list else texts[0]


func _tell(line: String, what: String) -> void:
	var sentence := "“%s”: %s" % [line, what]
	if not sentence in _problems:
		_problems.append(sentence)
