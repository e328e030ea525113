extends SceneTree
## Writes the mutants below build/mutants/: list.tsv with a line for each (number; named, equivalent
## or other; file; line; title), and the code of each that compiles in the file of its number. Ends
## with 1 when an entry of the two written lists no longer fits the code.
## Usage: godot --headless --path . -s tools/mutants/write_mutants.gd -- [--quick] [PATTERN]

const Mutant := preload("mutant.gd")
const MutantList := preload("mutant_list.gd")

const FOLDER := "res://build/mutants"

## This many of the small changes make up --quick, spread evenly over all.
const QUICK_COUNT := 40

var _pattern := ""
var _is_quick := false
var _count := 0
var _list := FileAccess.open(FOLDER.path_join("list.tsv"), FileAccess.WRITE)


func _init() -> void:
	for argument: String in OS.get_cmdline_user_args():
		if argument == "--quick":
			_is_quick = true
		else:
			_pattern = argument
	var mutants := MutantList.new()
	if mutants.problems.is_empty():
		_write_all(mutants)
	for line: String in "\n".join(mutants.problems).split("\n", false):
		print("problem " + line)
	quit(mini(mutants.problems.size(), 1))


func _write_all(mutants: MutantList) -> void:
	var others := _wanted("other", mutants.others)
	_write("named", _wanted("named", mutants.named))
	_write("other", _evenly_chosen(others) if _is_quick else others)
	if not _is_quick:
		_write("equivalent", _wanted("equivalent", mutants.equivalent))


## Those whose kind, file, line and title hold the pattern.
func _wanted(kind: String, mutants: Array[Mutant]) -> Array[Mutant]:
	if _pattern == "":
		return mutants
	return mutants.filter(
		func(mutant: Mutant) -> bool: return _about(kind, mutant).containsn(_pattern)
	)


func _evenly_chosen(mutants: Array[Mutant]) -> Array[Mutant]:
	var chosen: Array[Mutant] = []
	var step := maxf(1.0, float(mutants.size()) / QUICK_COUNT)
	var next := 0.0
	for index: int in mutants.size():
		if index >= next and mutants[index].compiles():
			chosen.append(mutants[index])
			next += step
	return chosen


func _write(kind: String, mutants: Array[Mutant]) -> void:
	for mutant: Mutant in mutants:
		_count += 1
		_list.store_line("%d\t%s" % [_count, _about(kind, mutant)])
		if mutant.compiles():
			var file := FileAccess.open(FOLDER.path_join(str(_count)), FileAccess.WRITE)
			file.store_string(mutant.code)


func _about(kind: String, mutant: Mutant) -> String:
	return "%s\t%s\t%d\t%s" % [kind, mutant.file, mutant.line, mutant.title]
