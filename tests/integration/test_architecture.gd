extends LabTest
## Keeps the layers of docs/implementation_notes.md apart, and checks what every script must have.
## For each rule a test shows that it finds a text that breaks it.

const SCRIPTS := "res://scripts"
const SCENES := "res://scenes"
const WIDGETS := "res://scenes/widgets"
const LESSONS := "res://scenes/lessons"
const WORKSHOP := "res://workshop/kit"

const OWN_FOLDERS: Array[String] = [
	SCRIPTS,
	SCENES,
	"res://tests",
	"res://assets",
	"res://benchmarks",
	"res://docs",
	"res://tools",
	WORKSHOP
]

## Classes from which nothing below scripts/ may use anything: what needs a scene, and what the
## engine knows of input and physics.
const FORBIDDEN_PARENTS: Array[StringName] = [
	&"Node",
	&"MainLoop",
	&"InputEvent",
	&"Shape2D",
	&"PhysicsServer2D",
	&"PhysicsDirectSpaceState2D"
]

## The engine's vectors, and singletons that the classes above do not cover.
const FORBIDDEN_NAMES: Array[String] = [
	"Vector2",
	"Vector2i",
	"Vector3",
	"PackedVector2Array",
	"Transform2D",
	"Rect2",
	"Geometry2D",
	"Input",
	"InputMap",
	"PhysicsServer2DManager",
]

## The two methods that may name Vector2, in the one file that may.
const VECTOR2_BRIDGE := r"(?m)^(?:static )?func (?:from_vector2|to_vector2)\(.*\n(?:\t.*\n)+"


func test_scripts_need_no_scene_no_input_and_no_engine_vector() -> void:
	for file: String in SourceCode.files_below(SCRIPTS, ["gd"]):
		var code := FileAccess.get_file_as_string(file)
		if file == SCRIPTS.path_join("vec2.gd"):
			code = RegEx.create_from_string(VECTOR2_BRIDGE).sub(code, "", true)
		assert_eq(_engine_names_in(code), PackedStringArray(), file)


func test_a_script_with_a_node_or_an_engine_vector_is_found() -> void:
	assert_eq(_engine_names_in('extends RefCounted # Node\nvar a := "Node"'), PackedStringArray())
	for forbidden: String in ["Node2D", "Control", "Input", "Vector2", "RigidBody2D", "SceneTree"]:
		assert_eq(_engine_names_in("var a: " + forbidden), PackedStringArray([forbidden]))


# A chain of classes that is longer is read by nobody.
func test_no_class_of_scripts_has_more_than_four_bases_of_ours() -> void:
	for file: String in SourceCode.files_below(SCRIPTS, ["gd"]):
		var depth := 0
		var script := load(file) as GDScript
		while script:
			depth += 1
			script = script.get_base_script() as GDScript
		assert_lt(depth, 6, file)


func test_scripts_name_no_scene() -> void:
	assert_eq(_references_between(SCRIPTS, SCENES), PackedStringArray())


func test_scripts_name_nothing_of_the_workshop_and_the_workshop_names_no_scene() -> void:
	assert_eq(_references_between(SCRIPTS, WORKSHOP), PackedStringArray())
	assert_eq(_references_between(WORKSHOP, SCENES), PackedStringArray())


func test_the_workshop_alone_gives_no_warnings_for_what_a_student_writes() -> void:
	var rules: Dictionary = ProjectSettings.get_setting("debug/gdscript/warnings/directory_rules")
	var of_student: int = rules["res://workshop"]
	var of_kit: int = rules[WORKSHOP]
	assert_eq(of_student, 0)
	assert_eq(of_kit, 1)


func test_widgets_name_no_lesson() -> void:
	assert_eq(_references_between(WIDGETS, LESSONS), PackedStringArray())


func test_lessons_never_name_each_other() -> void:
	var references := PackedStringArray()
	for lesson: String in SourceCode.folders_in(LESSONS):
		for other: String in SourceCode.folders_in(LESSONS):
			if other != lesson:
				references.append_array(_references_between(lesson, other))
	assert_eq(references, PackedStringArray())


func test_a_reference_by_path_or_by_class_is_found() -> void:
	var by_path := 'var a := preload("res://tests/support/lab_test.gd") # LabTest'
	assert_eq(
		_references(by_path, "res://tests/support"), PackedStringArray(["res://tests/support/"])
	)
	assert_eq(_references("var a: LabTest", "res://tests/support"), PackedStringArray(["LabTest"]))
	assert_eq(
		_references("# res://tests/support/ LabTest", "res://tests/support"), PackedStringArray()
	)


func test_every_public_member_of_scripts_is_documented() -> void:
	var files := SourceCode.files_below(SCRIPTS, ["gd"])
	files.append_array(SourceCode.files_below(WORKSHOP, ["gd"]))
	assert_has(files, SCRIPTS.path_join("vec2.gd"))
	for file: String in files:
		var undocumented := SourceCode.undocumented_members(FileAccess.get_file_as_string(file))
		assert_eq(undocumented, PackedStringArray(), file)


func test_each_kind_of_undocumented_member_is_found() -> void:
	var code := "extends RefCounted\n\nsignal s\nenum E { A }\nconst C := 1\n@export var v: int\n"
	code += "static var w: int\n@export\nvar x: int\nfunc f() -> void:\n\tvar local := 1\n"
	code += "static func g() -> void:\n\tpass\nclass Inner:\n\tpass\nvar _private: int\n"
	var wanted := PackedStringArray("the class|s|E|C|v|w|x|f|g|Inner".split("|"))
	assert_eq(SourceCode.undocumented_members(code), wanted)


func test_documented_members_are_accepted() -> void:
	var code := "class_name A\nextends RefCounted\n## Class.\n\n## Member.\n@export\nvar v: int\n"
	assert_eq(SourceCode.undocumented_members(code), PackedStringArray())


func test_untyped_declarations_are_errors() -> void:
	for warning: String in [
		"untyped_declaration", "unsafe_method_access", "unsafe_property_access"
	]:
		var level: int = ProjectSettings.get_setting("debug/gdscript/warnings/" + warning)
		assert_eq(level, 2, warning)


func test_files_and_folders_are_named_in_snake_case() -> void:
	for folder: String in OWN_FOLDERS:
		for file: String in SourceCode.files_below(
			folder, ["gd", "tscn", "tres", "json", "md", "sh"]
		):
			assert_true(_is_snake_case(file.trim_prefix("res://")), file)


func test_a_name_that_is_not_snake_case_is_found() -> void:
	assert_true(_is_snake_case("scripts/l01_easy_bounce/vec2.gd"))
	assert_false(_is_snake_case("scripts/Vec2.gd"))
	assert_false(_is_snake_case("scripts/two-words.gd"))
	assert_false(_is_snake_case("Scripts/vec2.gd"))


func _engine_names_in(code: String) -> PackedStringArray:
	var forbidden := PackedStringArray()
	for candidate: String in SourceCode.names_in(code):
		if FORBIDDEN_NAMES.has(candidate) or _has_forbidden_parent(candidate):
			forbidden.append(candidate)
	return forbidden


func _has_forbidden_parent(candidate: String) -> bool:
	for parent: StringName in FORBIDDEN_PARENTS:
		if ClassDB.class_exists(candidate) and ClassDB.is_parent_class(candidate, parent):
			return true
	return false


## What the text names of a folder: the folder's path, or the classes declared below it.
func _references(text: String, folder: String) -> PackedStringArray:
	var references := PackedStringArray()
	if SourceCode.without_comments(text).contains(folder + "/"):
		references.append(folder + "/")
	var names := SourceCode.names_in(text)
	for declared: String in SourceCode.classes_below(folder):
		if names.has(declared):
			references.append(declared)
	return references


## The same for all files below a folder, each with the file's path.
func _references_between(from: String, to: String) -> PackedStringArray:
	var references := PackedStringArray()
	for file: String in SourceCode.files_below(from, ["gd", "tscn", "tres"]):
		for reference: String in _references(FileAccess.get_file_as_string(file), to):
			references.append("%s names %s" % [file, reference])
	return references


func _is_snake_case(path: String) -> bool:
	return RegEx.create_from_string("^[a-z0-9_]+(?:[./][a-z0-9_]+)*$").search(path) != null
