class_name WorkshopCompiler
extends RefCounted
## Compiles a student's files from their text, in the child only: all of them together, as classes
## inside one script. So it does not matter what stands in his files on the disk, nor whether the
## editor knows his classes already, and each file sees the others.

const _PLACE := "res://workshop/judged.gd"
const _TEST_PLACE := "res://workshop/judged_test.gd"
# Only GUT itself has this name; its stand-in has a file in the same place.
const _BY_NAME := r"(?m)^extends[ \t]+GutTest\b"
const _BY_PLACE := 'extends "res://addons/gut/test.gd"'
# A body with this many tokens is not written the same way twice by chance.
const _LONG := 40
const _KEY_FILES: PackedStringArray = [
	"res://scripts/vec2.gd",
	"res://scripts/collision/segment_impact.gd",
	"res://scripts/collision/cap_impact.gd",
	"res://scripts/collision/point_of_impact.gd",
	"res://scripts/collision/straight_impact_finder.gd",
	"res://scripts/aiming/lead_aim.gd",
	"res://scripts/aiming/ballistic_aim.gd",
	"res://scripts/aiming/bank_aim.gd",
]

static var _shapes_of_key: Dictionary[String, bool] = {}

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


## Prepares with [param errors], which hears the engine already.
func _init(errors: WorkshopHeardErrors) -> void:
	_errors = errors


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
	var with_it := WorkshopTogether.new("")
	for earlier in _texts:
		with_it.add(earlier, _texts[earlier])
	with_it.add(file, codes[file].text)
	var script := _compiled(file, with_it, _PLACE)
	if script:
		_texts[file] = codes[file].text
		for compiled in _texts:
			var of_class: String = WorkshopFiles.CLASSES[compiled]
			var constants := script.get_script_constant_map()
			classes[of_class] = WorkshopAny.script(constants[WorkshopTogether.inside(of_class)])


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
	return _is_his_own(file) and _uses_known_names(file, is_test) and _has_its_name(file)


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
		var shape := codes[file].shape_of(function)
		if shape.size() >= _LONG and _key_shapes().has(" ".join(shape)):
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


static func _key_shapes() -> Dictionary[String, bool]:
	if _shapes_of_key:
		return _shapes_of_key
	var shapes: Dictionary[String, bool] = {}
	for path in _KEY_FILES:
		var code := WorkshopCode.new(FileAccess.get_file_as_bytes(path))
		for function in code.functions():
			shapes[" ".join(code.shape_of(function))] = true
	_shapes_of_key = shapes
	return shapes


func _compiled(file: String, together: WorkshopTogether, place: String) -> GDScript:
	var script := GDScript.new()
	script.source_code = together.text
	script.take_over_path(place)
	_errors.begin()
	if script.reload() == OK:
		return script
	var line := 0
	var sentence := LabText.translate("Godot cannot read this file.")
	if _errors.heard:
		line = together.line_in(file, _errors.heard[0].line)
		var message := WorkshopTogether.with_his_names(_errors.heard[0].message)
		sentence = WorkshopSentences.of_form(message, _names())
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


## The line in a student's file for a line of the script that holds all of them.
func line_in(file: String, line: int) -> int:
	var with_all := WorkshopTogether.new("")
	for compiled in _texts:
		with_all.add(compiled, _texts[compiled])
	return with_all.line_in(file, line)
