class_name SourceCode
extends RefCounted
## Reads the project's own files, for the tests that hold its layers apart.

## A string in one of its three forms, or a comment; only a string is captured.
const _STRING_OR_COMMENT := r'(?s)(""".*?"""|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\')|#[^\n]*'

## A public member, with the annotations before it on its line.
const _MEMBER := (
	r"^(?:@\w+(?:\([^)]*\))? )*(?:static )?" + r"(?:var|const|func|signal|enum|class) ([A-Za-z]\w*)"
)


## All files below [param folder] whose names end in one of [param endings], hidden ones left out;
## none if the folder does not exist.
static func files_below(folder: String, endings: Array[String]) -> PackedStringArray:
	var files := PackedStringArray()
	if not DirAccess.dir_exists_absolute(folder):
		return files
	for file: String in DirAccess.get_files_at(folder):
		if endings.has(file.get_extension()):
			files.append(folder.path_join(file))
	for subfolder: String in DirAccess.get_directories_at(folder):
		files.append_array(files_below(folder.path_join(subfolder), endings))
	return files


## The folders directly in [param folder]; none if it does not exist.
static func folders_in(folder: String) -> PackedStringArray:
	var folders := PackedStringArray()
	if DirAccess.dir_exists_absolute(folder):
		for subfolder: String in DirAccess.get_directories_at(folder):
			folders.append(folder.path_join(subfolder))
	return folders


## The code without its comments.
static func without_comments(code: String) -> String:
	return RegEx.create_from_string(_STRING_OR_COMMENT).sub(code, "$1", true)


## The names in the code, each once: neither those in strings nor those in comments.
static func names_in(code: String) -> PackedStringArray:
	var names: Dictionary[String, bool] = {}
	var bare := RegEx.create_from_string(_STRING_OR_COMMENT).sub(code, "", true)
	for found: RegExMatch in RegEx.create_from_string(r"[A-Za-z_]\w*").search_all(bare):
		names[found.get_string()] = true
	return PackedStringArray(names.keys())


## The class names that the scripts below [param folder] declare.
static func classes_below(folder: String) -> PackedStringArray:
	var classes := PackedStringArray()
	for file: String in files_below(folder, ["gd"]):
		var declared := class_in(FileAccess.get_file_as_string(file))
		if declared:
			classes.append(declared)
	return classes


## The class name that the code declares, "" if none.
static func class_in(code: String) -> String:
	var found := RegEx.create_from_string(r"(?m)^(?:@\w+ )*class_name (\w+)").search(code)
	return found.get_string(1) if found != null else ""


## The public members that have no documentation comment (##) above them, and "the class" if there
## is none below its "extends".
static func undocumented_members(code: String) -> PackedStringArray:
	var undocumented := PackedStringArray()
	if RegEx.create_from_string("(?m)^extends [^\n]+\n##").search(code) == null:
		undocumented.append("the class")
	var member_pattern := RegEx.create_from_string(_MEMBER)
	var lines := code.split("\n")
	for index: int in lines.size():
		var member := member_pattern.search(lines[index])
		if member != null and not _line_above(lines, index).begins_with("##"):
			undocumented.append(member.get_string(1))
	return undocumented


## The line above, annotations that have a line of their own left out.
static func _line_above(lines: PackedStringArray, index: int) -> String:
	var above := index - 1
	while above > 0 and lines[above].begins_with("@"):
		above -= 1
	return lines[above] if above >= 0 else ""
