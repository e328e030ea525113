class_name WorkshopCompiler
extends RefCounted
## Compiles a student's files from their text, all of them together, as classes inside one script.
## So it does not matter what stands in his files on the disk, nor whether the editor knows his
## classes already, and each file sees the others. Only a child may run them, unless they are
## guarded.

# In two parts, because no export has to look for them.
const _PLACE := "res:/" + "/workshop/judged.gd"
const _TEST_PLACE := "res:/" + "/workshop/judged_test.gd"
# Only GUT itself has this name; its stand-in has a file in the same place.
const _BY_NAME := r"(?m)^extends[ \t]+GutTest\b"
const _BY_PLACE := 'extends "res://addons/gut/test.gd"'

## Whether what is compiled has guards in it, see [WorkshopGuard].
var is_guarded := false

## The compiled classes by their names, such as `MyVec2`.
var classes: Dictionary[String, GDScript] = {}
## The texts of all files.
var codes: Dictionary[String, WorkshopCode] = {}
## For each file that was not compiled a verdict without a number that says why.
var problems: Dictionary[String, WorkshopVerdict] = {}

var _errors: WorkshopHeardErrors
var _declared: Dictionary[String, bool] = {}
# What has been compiled without a mistake so far.
var _texts: Dictionary[String, String] = {}
# The same with guards, and what the functions in it give back.
var _guarded: Dictionary[String, WorkshopGuardedCode] = {}
var _types: Dictionary[String, String] = {}


## Prepares with [param errors], which hears the engine already.
func _init(errors: WorkshopHeardErrors, with_guards: bool = false) -> void:
	_errors = errors
	is_guarded = with_guards


## Compiles the classes among these files, by their names.
func compile(files: Dictionary[String, PackedByteArray]) -> void:
	for file in files:
		codes[file] = WorkshopCode.new(files[file])
	for file in codes:
		_declared.merge(WorkshopAllowed.declared_in(codes[file].tokens()))
	for file: String in WorkshopFiles.CLASSES:
		if codes.has(file):
			_compile_class(file)


## Compiles the text of a test file with [param companions], the texts of the classes that it tests;
## null where that cannot be done, see [member problems].
func compile_test(file: String, companions: Dictionary[String, String]) -> GDScript:
	for of_class in companions:
		var companion := WorkshopCode.new(companions[of_class].to_utf8_buffer())
		_declared.merge(WorkshopAllowed.declared_in(companion.tokens()))
	if not _may_be_compiled(file, true):
		return null
	var its_text := RegEx.create_from_string(_BY_NAME).sub(codes[file].text, _BY_PLACE)
	var together := WorkshopTogether.new(its_text)
	for of_class in companions:
		together.add(WorkshopFiles.file_of(of_class), companions[of_class])
	return _compiled(file, together, _TEST_PLACE)


func _compile_class(file: String) -> void:
	if not _may_be_compiled(file, false):
		return
	if file != "my_vec2.gd" and not classes.has("MyVec2"):
		_add_problem(
			file,
			WorkshopVerdict.Kind.WAITING,
			0,
			LabText.translate("my_vec2.gd cannot be used yet: mend it first.")
		)
		return
	var script := _compiled(file, _together_with(file), _PLACE)
	if script and is_guarded:
		script = _compiled_with_guards(file)
	if script:
		_texts[file] = codes[file].text
		for compiled in _texts:
			var of_class: String = WorkshopFiles.CLASSES[compiled]
			var constants := script.get_script_constant_map()
			classes[of_class] = WorkshopAny.script(constants[WorkshopTogether.inside(of_class)])


# This file behind all that are compiled.
func _together_with(file: String) -> WorkshopTogether:
	var together := WorkshopTogether.new("")
	for earlier in _texts:
		together.add(earlier, _texts[earlier])
	together.add(file, codes[file].text)
	return together


# The file can be compiled as it is; only what comes of this is ever run.
func _compiled_with_guards(file: String) -> GDScript:
	_types.merge(WorkshopGuardedCode.types_in(codes[file].text), true)
	_guarded[file] = WorkshopGuardedCode.new(codes[file].text, _types)
	if not _guarded[file].problem:
		var script := _compiled(file, _together_guarded(), _PLACE)
		if script:
			return script
	var sentence := _guarded[file].problem
	if not sentence:
		sentence = LabText.translate("This cannot be run safely in the browser; in Godot it can.")
	_add_problem(file, WorkshopVerdict.Kind.REFUSED, _guarded[file].problem_line, sentence)
	_guarded.erase(file)
	return null


func _together_guarded() -> WorkshopTogether:
	var together := WorkshopTogether.new("")
	for file in _guarded:
		together.add(file, _guarded[file].text)
	return together


func _may_be_compiled(file: String, is_test: bool) -> bool:
	var code := codes[file]
	if code.problem:
		_add_problem(file, WorkshopVerdict.Kind.UNREADABLE, 0, code.problem)
		return false
	if not code.text.strip_edges():
		_add_problem(file, WorkshopVerdict.Kind.MISSING, 0, LabText.translate("The file is empty."))
		return false
	var colon := WorkshopSentences.line_without_colon(code.text)
	if colon > 0:
		var missing := LabText.translate("The colon (:) at the end of this line is missing.")
		_add_problem(file, WorkshopVerdict.Kind.UNREADABLE, colon, missing)
		return false
	var mixed := WorkshopSentences.line_with_mixed_indent(code.text)
	if mixed > 0:
		var sentence := LabText.translate("Tabs and spaces are mixed: indent every line with tabs.")
		_add_problem(file, WorkshopVerdict.Kind.UNREADABLE, mixed, sentence)
		return false
	if not (_is_his_own(file) and _uses_known_names(file, is_test) and _has_its_name(file)):
		return false
	return not is_guarded or _can_be_guarded(file)


func _can_be_guarded(file: String) -> bool:
	var limits := WorkshopGuardLimits.new(codes[file].text)
	if limits.sentence:
		_add_problem(file, WorkshopVerdict.Kind.REFUSED, limits.line, limits.sentence)
	return not limits.sentence


func _uses_known_names(file: String, is_test: bool) -> bool:
	var allowed := WorkshopAllowed.new(codes[file].tokens(), _declared, is_test)
	if not allowed.sentence:
		return true
	var nearest := WorkshopSentences.nearest_to(allowed.unknown, _names())
	if allowed.unknown and nearest:
		var sentence := WorkshopSentences.unknown_name(allowed.unknown, _names())
		_add_problem(file, WorkshopVerdict.Kind.UNREADABLE, allowed.line, sentence)
	else:
		_add_problem(file, WorkshopVerdict.Kind.REFUSED, allowed.line, allowed.sentence)
	return false


# A method of the answer key, written down again, tells nothing of the student.
func _is_his_own(file: String) -> bool:
	for function in codes[file].functions():
		if WorkshopAnswerKey.has(codes[file].shape_of(function)):
			var sentence := LabText.translate("%s is the lab's own code: write it yourself.")
			var line := codes[file].line_of(function)
			_add_problem(file, WorkshopVerdict.Kind.REFUSED, line, sentence % function)
			return false
	return true


func _has_its_name(file: String) -> bool:
	if not WorkshopFiles.CLASSES.has(file):
		return true
	var wanted: String = WorkshopFiles.CLASSES[file]
	var pattern := RegEx.create_from_string(r"(?m)^[ \t]*class_name[ \t]+(\w+)")
	var hit := pattern.search(codes[file].text)
	if hit and hit.get_string(1) == wanted:
		return true
	var line := codes[file].text.substr(0, hit.get_start()).count("\n") + 1 if hit else 1
	var sentence := LabText.translate("The class must be called %s: class_name %s.")
	_add_problem(file, WorkshopVerdict.Kind.UNREADABLE, line, sentence % [wanted, wanted])
	return false


func _compiled(file: String, together: WorkshopTogether, place: String) -> GDScript:
	var script := GDScript.new()
	script.source_code = together.text
	script.take_over_path(place)
	_errors.begin()
	if script.reload() == OK:
		return script
	var line := 0
	var sentence := LabText.translate("Godot cannot read this file.")
	if _errors.heard and not _guarded.has(file):
		line = together.line_in(file, _errors.heard[0].line)
		var message := WorkshopTogether.with_his_names(_errors.heard[0].message)
		sentence = WorkshopSentences.of_form(message, _names())
	if not _guarded.has(file):
		_add_problem(file, WorkshopVerdict.Kind.UNREADABLE, line, sentence)
	return null


func _add_problem(file: String, kind: WorkshopVerdict.Kind, line: int, sentence: String) -> void:
	var verdict := WorkshopVerdict.new()
	verdict.kind = kind
	verdict.file = file
	verdict.line = line
	verdict.sentence = sentence
	problems[file] = verdict


# What a misspelt name may have been meant to be.
func _names() -> PackedStringArray:
	var names := PackedStringArray(_declared.keys())
	for words: String in [
		WorkshopAllowed.FUNCTIONS, WorkshopAllowed.MEMBERS, WorkshopAllowed.LANGUAGE
	]:
		names.append_array(words.split(" "))
	return names


## The line in a student's file that [param heard] means.
func line_in(heard: WorkshopHeardErrors.Heard, file: String) -> int:
	if not heard.file:
		return heard.line
	if _guarded.has(file):
		return _guarded[file].line_of(_together_guarded().line_in(file, heard.line))
	var with_all := WorkshopTogether.new("")
	for compiled in _texts:
		with_all.add(compiled, _texts[compiled])
	return with_all.line_in(file, heard.line)
