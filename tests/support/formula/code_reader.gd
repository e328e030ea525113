class_name CodeReader
extends RefCounted
## Runs the code that a lesson shows, line by line as a student does, and compares what its names
## then hold with what is shown: `position (9, −4)`.
##
## `Vec2.new` makes an object, which a second name shares; `Vector2` is a value, which is copied.

const _NUMBER := "([-−]?\\d+(?:\\.\\d+)?(?:e[-−]?\\d+)?)"
const _PAIR := "\\(\\s*" + _NUMBER + "\\s*,\\s*" + _NUMBER + "\\s*\\)"

# What each name holds; a list of two numbers, which names can share.
var _held: Dictionary[String, Array] = {}
var _is_object: Dictionary[String, bool] = {}
var _problem := ""
# The forms of a line, and what each does with what was found.
var _forms: Dictionary[String, Callable] = {
	"^(\\w+) = (Vec2\\.new|Vector2)" + _PAIR + "$": _make,
	"^(\\w+) = (\\w+)(\\.copy\\(\\))?$": _assign,
	"^(\\w+)\\.set_xy" + _PAIR + "$": _set_both,
	"^(\\w+) " + _PAIR + "$": _compare,
}


## What is false in [param lines], a sentence each with the line.
func problems(lines: PackedStringArray) -> PackedStringArray:
	var found: PackedStringArray = []
	_held.clear()
	for line in lines:
		for statement in line.strip_edges().split("   ", false):
			_problem = ""
			_run(statement.strip_edges())
			if _problem:
				found.append("“%s”: %s" % [statement, _problem])
	return found


func _run(statement: String) -> void:
	for form in _forms:
		var hit := RegEx.create_from_string(form).search(statement)
		if hit:
			_forms[form].call(hit)
			return
	_problem = "cannot read it"


func _make(hit: RegExMatch) -> void:
	_held[hit.get_string(1)] = _pair(hit, 3)
	_is_object[hit.get_string(1)] = hit.get_string(2) == "Vec2.new"


func _assign(hit: RegExMatch) -> void:
	var name_of_new := hit.get_string(1)
	var name_of_old := hit.get_string(2)
	if not _is_known(name_of_old):
		return
	var shares := _is_object[name_of_old] and not hit.get_string(3)
	_held[name_of_new] = _held[name_of_old] if shares else _held[name_of_old].duplicate()
	_is_object[name_of_new] = _is_object[name_of_old]


func _set_both(hit: RegExMatch) -> void:
	if _is_known(hit.get_string(1)):
		_held[hit.get_string(1)].assign(_pair(hit, 2))


func _compare(hit: RegExMatch) -> void:
	if not _is_known(hit.get_string(1)):
		return
	var held := _held[hit.get_string(1)]
	var shown := _pair(hit, 2)
	for i in 2:
		var one: FormulaNode = held[i]
		var other: FormulaNode = shown[i]
		# Either may have been rounded where it is shown.
		if absf(one.number - other.number) > maxf(one.unit, other.unit) / 2.0 * 1.0001:
			_problem = "%s, not %s" % [one.number, other.number]
			return


func _is_known(name_in_code: String) -> bool:
	if not _held.has(name_in_code):
		_problem = "nothing is called “%s”" % name_in_code
	return _held.has(name_in_code)


static func _pair(hit: RegExMatch, first: int) -> Array[FormulaNode]:
	var pair: Array[FormulaNode] = []
	for i in 2:
		pair.append(FormulaParser.number(hit.get_string(first + i)))
	return pair
