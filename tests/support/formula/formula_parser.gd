class_name FormulaParser
extends RefCounted
## Reads one statement of a formula by recursive descent: sides with relations between them.
##
## [codeblock]
## sum     = product (("+" | "−") product)*
## product = row (("·" | "/") row)*
## row     = signed factor*                      side by side: a product
## signed  = "−" signed | factor
## factor  = atom ("²" | "°" | ".x" | ".y" | ".copy()")*
## atom    = number | share of pi | symbol | "(" sum ("," sum)* ")" | "|" sum "|"
##         | "√" factor | function factor
## [/codeblock]

## Stands for words that are listed for a lesson.
const WORDS := "¶"
const RELATIONS: PackedStringArray = ["=", "<", ">", "≤", "≥", "≈"]

const _FUNCTIONS: PackedStringArray = ["Vec2.new", "atan2", "cos", "sin", "log", "int"]
const _NUMBER := "\\d+(?:\\.\\d+)?(?:e[-−+]?\\d+)?"
# A share of pi is one number, so that `cos π/2` is no half of a cosine.
const _SHARE_OF_PI := "\\d*π(?:/\\d+)?"
const _TOKEN := (
	"\\(rounding: [^)]*\\)|"
	+ _SHARE_OF_PI
	+ "|"
	+ _NUMBER
	+ "|NaN|∞|Vec2\\.new|atan2|\\.x\\b|\\.y\\b|\\.copy\\(\\)|[\\p{L}_][\\p{L}\\p{M}_′₀-₉]*|\\S"
)
const _LEAST_DIGITS := 4
# A shorter number is read right by the engine.
const _MANY_LETTERS := 15

static var _finder := RegEx.create_from_string(_TOKEN)

## The sides in the order of reading; null for one that is only words.
var sides: Array[FormulaNode] = []
## The relation before each side but the first.
var relations: PackedStringArray = []
## What cannot be read; "" where all could be.
var problem := ""

var _tokens: PackedStringArray = []
var _at := 0
var _least_digits := _LEAST_DIGITS
# Within bars a bar ends what is between them.
var _bars := 0


## Reads the statements of [param text], in which listed words are [constant WORDS]; words in the
## middle of a side and a colon end a statement. A number that shows fewer than
## [param least_digits] digits could have shown so many.
static func read(text: String, least_digits: int = _LEAST_DIGITS) -> Array[FormulaParser]:
	var tokens: PackedStringArray = []
	for found in _finder.search_all(text):
		tokens.append(found.get_string())
	var statements: Array[FormulaParser] = []
	var at := 0
	while at < tokens.size():
		var statement := FormulaParser.new()
		statement._tokens = tokens
		statement._at = at
		statement._least_digits = least_digits
		statement._read_statement()
		statements.append(statement)
		at = statement._at
		if statement.problem:
			statement.problem = "cannot read “%s”" % " ".join(tokens.slice(maxi(at - 1, 0)))
			break
	return statements


## The number that [param text] shows.
static func number(text: String) -> FormulaNode:
	var parser := FormulaParser.new()
	var node := parser._number(text.trim_prefix("−").trim_prefix("-"))
	if text[0] in ["−", "-"]:
		node.number = -node.number
	return node


func _read_statement() -> void:
	while true:
		_skip_words()
		var is_empty := _next() in RELATIONS or _next() in ["", ":"]
		sides.append(null if is_empty else _sum())
		if problem:
			return
		_skip_words()
		if not _next() in RELATIONS:
			break
		relations.append(_take())
	if _next() == ":":
		_at += 1
	elif _next() != "" and _tokens[_at - 1] != WORDS:
		problem = "unread"


func _skip_words() -> void:
	while _next() == WORDS:
		_at += 1


func _sum() -> FormulaNode:
	var sum := _product()
	while _next() in ["+", "−"] and not problem:
		var kind := FormulaNode.Kind.SUM if _take() == "+" else FormulaNode.Kind.DIFFERENCE
		sum = FormulaNode.new(kind, [sum, _product()])
	return sum


func _product() -> FormulaNode:
	var product := _row()
	while _next() in ["·", "/"] and not problem:
		var kind := FormulaNode.Kind.PRODUCT if _take() == "·" else FormulaNode.Kind.QUOTIENT
		product = FormulaNode.new(kind, [product, _row()])
	return product


func _row() -> FormulaNode:
	var row := _signed()
	while _is_begin() and not problem:
		row = FormulaNode.new(FormulaNode.Kind.SIDE_BY_SIDE, [row, _factor()])
	return row


func _signed() -> FormulaNode:
	if _next() == "−":
		_at += 1
		return FormulaNode.new(FormulaNode.Kind.NEGATIVE, [_signed()])
	return _factor()


func _factor() -> FormulaNode:
	var factor := _atom()
	while not problem:
		match _next():
			"²":
				factor = FormulaNode.new(FormulaNode.Kind.SQUARE, [factor])
			"°":
				factor = FormulaNode.new(FormulaNode.Kind.DEGREES, [factor])
			".x", ".y":
				factor = FormulaNode.new(FormulaNode.Kind.COMPONENT, [factor], _next()[1])
			".copy()":
				pass
			_:
				break
		_at += 1
	if _next().begins_with("(rounding"):
		factor.rounding = _rounding(_take())
	return factor


# What it says, and half a unit of its last digit.
static func _rounding(remark: String) -> float:
	var told := number(remark.get_slice(": ", 1).trim_suffix(")"))
	return told.number * (1.0 + 0.5 / 10.0 ** (told.digits - 1))


func _atom() -> FormulaNode:
	var token := _take()
	if token == "(":
		return _parentheses()
	if token == "|":
		_bars += 1
		var inside := _sum()
		_bars -= 1
		_expect("|")
		return FormulaNode.new(FormulaNode.Kind.SIZE, [inside])
	if token == "√":
		return FormulaNode.new(FormulaNode.Kind.ROOT, [_factor()])
	if token in _FUNCTIONS:
		return FormulaNode.new(FormulaNode.Kind.CALL, [_factor()], token)
	if _is_symbol(token):
		return FormulaNode.new(FormulaNode.Kind.SYMBOL, [], token)
	return _number(token)


# One number in parentheses is itself, several are a list.
func _parentheses() -> FormulaNode:
	var bars := _bars
	_bars = 0
	var parts: Array[FormulaNode] = [_sum()]
	while _next() == "," and not problem:
		_at += 1
		parts.append(_sum())
	_expect(")")
	_bars = bars
	return parts[0] if parts.size() == 1 else FormulaNode.new(FormulaNode.Kind.LIST, parts)


func _number(token: String) -> FormulaNode:
	var node := FormulaNode.new(FormulaNode.Kind.NUMBER)
	var text := token.replace("−", "-")
	if token.contains("π"):
		_read_share_of_pi(node, token)
	elif token == "NaN" or token == "∞":
		node.number = NAN if token == "NaN" else INF
	elif text.is_valid_float():
		node.number = _value_of(text)
		_count_digits(node, text)
	else:
		problem = "not a number"
	return node


# The engine reads every fourth number with many digits with another last bit.
static func _value_of(text: String) -> float:
	var exact := DecimalText.value_of(text) if text.length() > _MANY_LETTERS else NAN
	return text.to_float() if is_nan(exact) else exact


# It is exact; where it is a result, the other sides may be off by what 4 digits would hide.
func _read_share_of_pi(node: FormulaNode, token: String) -> void:
	var times := token.get_slice("π", 0)
	var below := token.get_slice("/", 1) if token.contains("/") else "1"
	node.number = (times.to_float() if times else 1.0) * PI / below.to_float()
	node.is_exact = true
	node.unit = 10.0 ** (floori(log(node.number) / log(10.0)) - _LEAST_DIGITS + 1)


func _count_digits(node: FormulaNode, text: String) -> void:
	node.digits = text.get_slice("e", 0).replace(".", "").lstrip("0").length()
	if node.number == 0.0:
		return
	var first := floori(log(absf(node.number)) / log(10.0) + 1e-12)
	var last := first - maxi(node.digits, _least_digits) + 1
	node.unit = 10.0 ** (last if text.contains("e") else mini(last, 0))


func _expect(token: String) -> void:
	if _take() != token:
		problem = "no " + token


# Whether the next token begins a factor that stands beside the last one.
func _is_begin() -> bool:
	var token := _next()
	if token == "|":
		return _bars == 0
	if token.begins_with("(rounding"):
		return false
	return (
		token in ["(", "√", "NaN", "∞"]
		or token in _FUNCTIONS
		or token.left(1).is_valid_int()
		or token.begins_with("π")
		or _is_symbol(token)
	)


static func _is_symbol(token: String) -> bool:
	if token in ["NaN", "∞"] or token == "" or token == WORDS or token.contains("π"):
		return false
	return token[0] == "_" or token[0].to_upper() != token[0].to_lower()


func _next() -> String:
	return _tokens[_at] if _at < _tokens.size() else ""


func _take() -> String:
	_at += 1
	return _tokens[_at - 1] if _at <= _tokens.size() else ""
