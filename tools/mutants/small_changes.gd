extends RefCounted
## Small mistakes made by rule: wherever a rule fits in a line of code, one mutant.

const Mutant := preload("mutant.gd")

## What is found in a line, and what comes in its place, FOUND being the found text itself. Binary
## operators have a space on both sides, a sign has none behind it: gdformat sees to that.
const RULES: Array[Array] = [
	[r" \+ ", " - "],
	[r" - ", " + "],
	[r" \* ", " / "],
	[r" / ", " * "],
	[r" \+= ", " -= "],
	[r" -= ", " += "],
	[r" \*= ", " /= "],
	[r" /= ", " *= "],
	[r"(?<!\de)-(?=[\w(])", ""],
	[r" < ", " <= "],
	[r" < ", " > "],
	[r" <= ", " < "],
	[r" <= ", " >= "],
	[r" > ", " >= "],
	[r" > ", " < "],
	[r" >= ", " > "],
	[r" >= ", " <= "],
	[r" == ", " != "],
	[r" != ", " == "],
	[r"\band\b", "or"],
	[r"\bor\b", "and"],
	[r"\bnot ", ""],
	[r"\btrue\b", "false"],
	[r"\bfalse\b", "true"],
	[r"\bmaxf\b", "minf"],
	[r"\bminf\b", "maxf"],
	[r"\bcos\(", "sin("],
	[r"\bsin\(", "cos("],
	[r"\bsqrt\(", "("],
	[r"\babsf\(", "("],
	[r"\.plus\(", ".minus("],
	[r"\.minus\(", ".plus("],
	[r"\.subtract\(", ".add("],
	[r"\.normalized\(\)", ""],
	[r"\.copy\(\)", ""],
	[r"\.x\b", ".y"],
	[r"\.y\b", ".x"],
	[r"\.start\b", ".end"],
	[r"\.end\b", ".start"],
	[r"(?<![\w.]|e-)0\.0(?![\w.])", "1.0"],
	[r"(?<![\w.]|e-)0(?![\w.])", "1"],
	[r"(?<![\w.]|e-)([1-9]\d*)(?![\w.])", "(2 * FOUND)"],
	[r"(?<![\w.]|e-)((?!0\.0\b)\d+(?:\.\d+|e-?\d+)+)(?![\w.])", "(2.0 * FOUND)"],
]

const _STRING_OR_COMMENT := r'"(?:\\.|[^"\\])*"|#.*'


## All small mistakes in a file with this [param code], in the order of its lines.
static func of(file: String, code: String) -> Array[Mutant]:
	var mutants: Array[Mutant] = []
	var lines := code.split("\n")
	for index: int in lines.size():
		var bare_line := _blanked(lines[index])
		for rule: Array in RULES:
			var pattern: String = rule[0]
			var new_text: String = rule[1]
			for found: RegExMatch in RegEx.create_from_string(pattern).search_all(bare_line):
				mutants.append(_mutant(file, lines, index, found, new_text))
	return mutants


static func _mutant(
	file: String, lines: PackedStringArray, index: int, found: RegExMatch, rule_text: String
) -> Mutant:
	var line := lines[index]
	var old_text := found.get_string()
	var new_text := rule_text.replace("FOUND", old_text)
	var changed := line.substr(0, found.get_start()) + new_text + line.substr(found.get_end())
	var mutated := lines.duplicate()
	mutated[index] = changed
	var said: PackedStringArray = [old_text.strip_edges(), new_text.strip_edges()]
	var title := "'%s' to '%s' in: %s" % [said[0], said[1], changed.strip_edges()]
	return Mutant.new(file, title, index + 1, "\n".join(mutated))


## The line with every string and comment blanked out, so that places stay what they are.
static func _blanked(line: String) -> String:
	for found: RegExMatch in RegEx.create_from_string(_STRING_OR_COMMENT).search_all(line):
		var blanks := " ".repeat(found.get_end() - found.get_start())
		line = line.substr(0, found.get_start()) + blanks + line.substr(found.get_end())
	return line
