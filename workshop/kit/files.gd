class_name WorkshopFiles
extends RefCounted
## The student's files: their names, and the starters that they begin as.

## The folder in which the student writes.
const FOLDER := "res:/" + "/workshop"
## The class that each of his files holds, in the order in which they are compiled.
const CLASSES: Dictionary[String, String] = {
	"my_vec2.gd": "MyVec2",
	"my_line.gd": "MyLine",
	"my_impact.gd": "MyImpact",
	"my_bounce.gd": "MyBounce",
	"my_aim.gd": "MyAim",
}
## What the names of his tests begin with.
const TEST_PREFIX := "test_my_"

## Where the starters are. In two parts, because they are no scripts that an export would look for.
const STARTERS := "res:/" + "/workshop/starters"


## The names of all starters.
static func starters() -> PackedStringArray:
	return DirAccess.get_files_at(STARTERS)


## The text of a starter.
static func starter(file: String) -> String:
	return FileAccess.get_file_as_string(STARTERS.path_join(file))


## Copies the starters to where a file is missing; a file that is there stays as it is. Returns what
## was copied: nothing where the project cannot be written.
static func put_starters(folder: String = FOLDER) -> PackedStringArray:
	var copied: PackedStringArray = []
	for file in starters():
		var place := folder.path_join(file)
		if file.get_extension() == "gd" and not FileAccess.file_exists(place):
			if DirAccess.copy_absolute(STARTERS.path_join(file), place) == OK:
				copied.append(file)
	return copied


## The student's files in [param folder]: those with classes in their order, then his tests.
static func of_student(folder: String) -> PackedStringArray:
	var found: PackedStringArray = []
	for file: String in CLASSES:
		if FileAccess.file_exists(folder.path_join(file)):
			found.append(file)
	return found + tests(folder)


## His test files in [param folder].
static func tests(folder: String) -> PackedStringArray:
	var found: PackedStringArray = []
	for file in DirAccess.get_files_at(folder):
		if file.begins_with(TEST_PREFIX) and file.get_extension() == "gd":
			found.append(file)
	return found


## Whether these files are as the starters of the same names.
static func are_starters(folder: String, files: PackedStringArray) -> bool:
	for file in files:
		if FileAccess.get_file_as_string(folder.path_join(file)) != starter(file):
			return false
	return true


## One text that differs whenever one of these files does; a missing file counts, too. The time of a
## file would not do: some file systems keep whole seconds only.
static func fingerprint(folder: String, files: PackedStringArray) -> String:
	var sums: PackedStringArray = []
	for file in files:
		sums.append(file + FileAccess.get_md5(folder.path_join(file)))
	return " ".join(sums)


## The file that holds a class, such as `my_vec2.gd` for `MyVec2`.
static func file_of(of_class: String) -> String:
	return CLASSES.find_key(of_class)
