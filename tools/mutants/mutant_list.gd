extends RefCounted
## All mutants in three lists, and what of the written lists does not fit. The small changes are
## made in scripts/vec2.gd and scripts/collision/.

const Mutant := preload("mutant.gd")
const Replacement := preload("replacement.gd")
const ReplacementList := preload("replacement_list.gd")
const SmallChanges := preload("small_changes.gd")

const NAMED_MISTAKES := "res://tools/mutants/named_mistakes.txt"
const EQUIVALENT := "res://tools/mutants/equivalent.txt"

## The mistakes of the course, each written down.
var named: Array[Mutant] = []

## The small changes by rule, without those that are named or equivalent.
var others: Array[Mutant] = []

## The small changes that make no difference, with the reason as their title.
var equivalent: Array[Mutant] = []

## A sentence for each entry of the two lists that no longer fits the code.
var problems := PackedStringArray()


func _init() -> void:
	for mistake: Replacement in ReplacementList.read(NAMED_MISTAKES):
		_add(mistake, named)
	for same: Replacement in ReplacementList.read(EQUIVALENT):
		_add(same, equivalent)
	_add_small_changes()


func _add(replacement: Replacement, list: Array[Mutant]) -> void:
	var code := _code(replacement.file)
	var problem := replacement.problem(code)
	if problem == "":
		list.append(replacement.mutant(code))
	else:
		problems.append(problem)


func _add_small_changes() -> void:
	var known: Dictionary[String, bool] = {}
	for mutant: Mutant in named + equivalent:
		known[mutant.code] = false
	for file: String in _files():
		for mutant: Mutant in SmallChanges.of(file, _code(file)):
			if known.has(mutant.code):
				known[mutant.code] = true
			else:
				others.append(mutant)
	for mutant: Mutant in equivalent:
		if not known[mutant.code]:
			problems.append("%s: '%s' is none of the small changes." % [mutant.file, mutant.title])


func _files() -> PackedStringArray:
	var files: PackedStringArray = ["scripts/vec2.gd"]
	for file: String in DirAccess.get_files_at("res://scripts/collision"):
		if file.get_extension() == "gd":
			files.append("scripts/collision/" + file)
	return files


func _code(file: String) -> String:
	return FileAccess.get_file_as_string("res://" + file)
