extends LabTest
## Who may name whom: no circle of files or folders, one order inside scripts/, and unit tests in
## folders that mirror what they test. For each rule a test shows that it finds a breach.

const SCRIPTS := "res://scripts"
const UNIT_TESTS := "res://tests/unit"

## From the ground up. What is in one layer names nothing in a later one.
const LAYERS: PackedStringArray = [
	"res://scripts/refusal.gd",
	"res://scripts/vec2.gd",
	"res://scripts/shapes",
	"res://scripts/numbers",
	"res://scripts/collision",
	"res://scripts/friction",
	"res://scripts/world/segments",
	"res://scripts/world/motion",
	"res://scripts/world/event",
	"res://scripts/aiming",
	"res://scripts/world/stepped",
	"res://scripts/lesson",
	"res://scripts/report",
	"res://scripts/report/cases",
	"res://scripts/report/problems",
	"res://scripts/report/pictures",
	"res://scripts/report/text",
	"res://scripts/report/stability",
]

## Where a folder of unit tests may have what it tests; `lessons/` is a case of its own.
const MIRRORED: PackedStringArray = ["res://scripts", "res://scenes", "res://", "res://tests"]

var _all: Dependencies


func before_all() -> void:
	_all = Dependencies.below(
		[SCRIPTS, "res://scenes", "res://assets", "res://tools", "res://workshop/kit"]
	)


func test_files_name_each_other_in_no_circle() -> void:
	assert_gt(_all.named_by.size(), 300)
	assert_eq(_all.circles(), PackedStringArray())


func test_a_circle_of_files_is_found() -> void:
	var texts: Dictionary[String, String] = {
		"res://a/one.gd": "class_name One\nvar two: Two # Four",
		"res://b/two.gd": 'class_name Two\nconst THREE := preload("three.gd")',
		"res://b/three.gd": 'extends Node\nconst SCENE := "res://b/scene.tscn"',
		"res://b/scene.tscn": '[ext_resource type="Script" path="res://a/one.gd" id="1"]',
		"res://b/four.gd": 'class_name Four\nvar one: One\nvar text := "Four"',
	}
	var found := Dependencies.of_texts(texts).circles()
	var members: PackedStringArray = [
		"res://a/one.gd", "res://b/scene.tscn", "res://b/three.gd", "res://b/two.gd"
	]
	assert_eq(found, PackedStringArray([", ".join(members)]))


func test_folders_name_each_other_in_no_circle() -> void:
	assert_eq(_all.of_folders().circles(), PackedStringArray())


func test_a_circle_of_folders_without_a_circle_of_files_is_found() -> void:
	var texts: Dictionary[String, String] = {
		"res://a/one.gd": "class_name One\nvar two: Two",
		"res://b/two.gd": "class_name Two",
		"res://b/three.gd": "class_name Three\nvar four: Four",
		"res://a/four.gd": "class_name Four",
	}
	var dependencies := Dependencies.of_texts(texts)
	assert_eq(dependencies.circles(), PackedStringArray())
	assert_eq(dependencies.of_folders().circles(), PackedStringArray(["res://a, res://b"]))


func test_scripts_name_only_lower_layers() -> void:
	assert_eq(Dependencies.below([SCRIPTS]).arrows_up(LAYERS), PackedStringArray())


func test_an_arrow_to_a_higher_layer_is_found() -> void:
	var texts: Dictionary[String, String] = {
		"res://scripts/vec2.gd": "class_name Vec2\nvar ball: Ball",
		"res://scripts/shapes/ball.gd": "class_name Ball\nvar position: Vec2",
		"res://scripts/report/row.gd": "class_name Row\nvar made_by: RowCase",
		"res://scripts/report/cases/row_case.gd": "class_name RowCase\nvar row: Row",
		"res://scripts/other.gd": "extends RefCounted",
	}
	var found := Array(Dependencies.of_texts(texts).arrows_up(LAYERS))
	found.sort()
	var wanted := [
		"res://scripts/other.gd is in no layer",
		"res://scripts/report/row.gd names res://scripts/report/cases/row_case.gd",
		"res://scripts/vec2.gd names res://scripts/shapes/ball.gd",
	]
	assert_eq(found, wanted)


func test_unit_tests_are_in_the_folders_of_what_they_test() -> void:
	var files := SourceCode.files_below(UNIT_TESTS, ["gd"])
	assert_gt(files.size(), 100)
	for file: String in files:
		var folder := file.get_base_dir().trim_prefix(UNIT_TESTS).trim_prefix("/")
		assert_true(_is_mirrored(folder), file)


func test_a_folder_that_mirrors_nothing_is_found() -> void:
	for folder: String in ["", "collision", "world/event", "widgets/board", "tools", "assets"]:
		assert_true(_is_mirrored(folder), folder)
	assert_true(_is_mirrored("lessons/dot_product"))
	for folder: String in ["impacts", "world/ball", "lessons/dot", "lessons/l04_dot_product/a"]:
		assert_false(_is_mirrored(folder), folder)


## Whether scripts/, scenes/, tools/, assets/ or tests/ holds the folder. That of a lesson may have
## its number before its name: lessons/dot_product is scenes/lessons/l04_dot_product.
func _is_mirrored(folder: String) -> bool:
	if folder.begins_with("lessons/"):
		var id := folder.trim_prefix("lessons/")
		for lesson: String in SourceCode.folders_in("res://scenes/lessons"):
			if RegEx.create_from_string(r"^l\d\d_").sub(lesson.get_file(), "") == id:
				return true
		return false
	for parent: String in MIRRORED:
		if DirAccess.dir_exists_absolute(parent.path_join(folder)):
			return true
	return false
