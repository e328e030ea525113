extends LabTest
## "Take it into your game" in README.md: the files of each row are all that its snippet needs. They
## are copied into an empty project, and there the snippet prints what the README says.

const NeededFiles := preload("res://tools/export/needed_files.gd")

const PROJECT := "res://build/take_into_your_game"
const SCRIPT := "main.gd"

const _ROW := (
	r"(?m)^\| \[(?<want>[^\]]+)\]\((?<link>#[^)]+)\)" + r" \| (?<files>[^|]+) \| (?<call>[^|]+) \|$"
)
const _SECTION := r"(?s)\n### %s\n.*?```gdscript\n(?<code>.*?)```\n\n```text\n(?<output>.*?)```\n"
const _IN_BACKTICKS := "`([^`]+)`"


class Row:
	var want: String
	var link: String
	## What is listed: paths of scripts, and of folders of which every script is meant.
	var listed: PackedStringArray
	## The call, as the table writes it.
	var calls: PackedStringArray
	var code: String
	var output: String

	## Every script that is listed, sorted.
	func files() -> PackedStringArray:
		var found: PackedStringArray = []
		for path: String in listed:
			var full := "res://" + path
			found.append_array(
				(
					SourceCode.files_below(full.trim_suffix("/"), ["gd"])
					if path.ends_with("/")
					else PackedStringArray([full])
				)
			)
		found.sort()
		return found


func test_every_row_has_a_section_with_a_snippet_that_makes_its_calls() -> void:
	var rows := _rows()
	assert_gt(rows.size(), 4, "rows are found")
	for row: Row in rows:
		assert_eq(row.link, "#" + row.want.to_lower().replace(",", "").replace(" ", "-"))
		assert_ne(row.code, "", "a section named " + row.want)
		for listed: String in row.calls:
			assert_string_contains(row.code, listed.get_slice("(", 0) + "(")


func test_every_row_lists_what_its_snippet_needs_and_nothing_else() -> void:
	for row: Row in _rows():
		_make_project(row)
		var needed := NeededFiles.new([PROJECT.path_join(SCRIPT)])
		assert_eq(needed.problems, PackedStringArray(), row.want)
		var wanted := Array(needed.files)
		wanted.erase(PROJECT.path_join(SCRIPT))
		var listed := Array(row.files())
		var missing := wanted.filter(func(file: String) -> bool: return not listed.has(file))
		var superfluous := listed.filter(func(file: String) -> bool: return not wanted.has(file))
		assert_eq(missing, [], row.want + ": missing in the README")
		assert_eq(superfluous, [], row.want + ": superfluous in the README")


func test_every_snippet_prints_in_an_empty_project_what_the_readme_says() -> void:
	for row: Row in _rows():
		_make_project(row)
		_copy(row.files())
		assert_eq(_output(), row.output, row.want)


func test_a_missing_file_is_noticed() -> void:
	var row := _rows()[1]
	var files := row.files()
	files.remove_at(files.find("res://scripts/shapes/line_segment.gd"))
	_make_project(row)
	_copy(files)
	assert_string_contains(_output(), 'Identifier "LineSegment" not declared')


# An empty project with the snippet of a row in a script that ends when it is done.
func _make_project(row: Row) -> void:
	_remove(PROJECT)
	DirAccess.make_dir_recursive_absolute(PROJECT)
	_write("project.godot", "config_version=5\n")
	_write(
		SCRIPT, "extends SceneTree\n\n\nfunc _init() -> void:\n%s\tquit()\n" % row.code.indent("\t")
	)


# Copies scripts to folders without `scripts/`, and lists their classes as Godot's import does,
# which takes 6 s a project.
func _copy(files: PackedStringArray) -> void:
	var classes: Array[Dictionary] = []
	for file: String in files:
		var copy := PROJECT.path_join(file.trim_prefix("res://scripts/"))
		DirAccess.make_dir_recursive_absolute(copy.get_base_dir())
		assert_eq(DirAccess.copy_absolute(file, copy), OK, file)
		for global_class: Dictionary in ProjectSettings.get_global_class_list():
			if global_class["path"] == file:
				# A copy, because the engine hands out its own list.
				var copied := global_class.duplicate()
				copied["path"] = "res://" + file.trim_prefix("res://scripts/")
				classes.append(copied)
	DirAccess.make_dir_recursive_absolute(PROJECT.path_join(".godot"))
	_write(".godot/global_script_class_cache.cfg", "list=%s\n" % var_to_str(classes))


# What Godot prints in the project, its errors included.
func _output() -> String:
	var words: PackedStringArray = ["--headless", "--no-header", "--quit-after", "100"]
	words.append_array(["--path", ProjectSettings.globalize_path(PROJECT), "-s", SCRIPT])
	var said := []
	OS.execute(OS.get_executable_path(), words, said, true)
	var output: String = said[0]
	return output


static func _rows() -> Array[Row]:
	var text := FileAccess.get_file_as_string("res://README.md")
	var rows: Array[Row] = []
	for hit: RegExMatch in RegEx.create_from_string(_ROW).search_all(text):
		var row := Row.new()
		row.want = hit.get_string("want")
		row.link = hit.get_string("link")
		row.listed = _in_backticks(hit.get_string("files"))
		row.calls = _in_backticks(hit.get_string("call"))
		var section := RegEx.create_from_string(_SECTION % row.want).search(text)
		if section:
			row.code = section.get_string("code")
			row.output = section.get_string("output")
		rows.append(row)
	return rows


static func _in_backticks(text: String) -> PackedStringArray:
	var found: PackedStringArray = []
	for hit: RegExMatch in RegEx.create_from_string(_IN_BACKTICKS).search_all(text):
		found.append(hit.get_string(1))
	return found


static func _write(file: String, text: String) -> void:
	FileAccess.open(PROJECT.path_join(file), FileAccess.WRITE).store_string(text)


static func _remove(folder: String) -> void:
	if not DirAccess.dir_exists_absolute(folder):
		return
	for inner: String in DirAccess.get_directories_at(folder):
		_remove(folder.path_join(inner))
	for file: String in DirAccess.get_files_at(folder):
		DirAccess.remove_absolute(folder.path_join(file))
	DirAccess.remove_absolute(folder)
