class_name Dependencies
extends RefCounted
## Which file names which: by a class, by a path, or by a name beside it. For the tests that look
## for circles and for arrows that point up.

const WrittenCode := preload("res://tools/export/written_code.gd")

const _ENDINGS: Array[String] = ["gd", "tscn", "tres"]

## File -> the files that it names, itself left out.
var named_by: Dictionary[String, PackedStringArray] = {}

var _class_paths: Dictionary[String, String] = {}


## Reads all files below [param folders]; only arrows between those files count.
static func below(folders: PackedStringArray) -> Dependencies:
	var texts: Dictionary[String, String] = {}
	for folder: String in folders:
		for file: String in SourceCode.files_below(folder, _ENDINGS):
			texts[file] = FileAccess.get_file_as_string(file)
	return of_texts(texts)


## The same for files that need not exist: path -> content.
static func of_texts(texts: Dictionary[String, String]) -> Dependencies:
	var made := Dependencies.new()
	for file: String in texts:
		var declared := SourceCode.class_in(texts[file])
		if declared:
			made._class_paths[declared] = file
	for file: String in texts:
		var named: Dictionary[String, bool] = {}
		for path: String in made._names(file, texts[file]):
			if texts.has(path) and path != file:
				named[path] = true
		made.named_by[file] = PackedStringArray(named.keys())
	return made


## The same with folders in place of files.
func of_folders() -> Dependencies:
	var folders := Dependencies.new()
	for file: String in named_by:
		var named: PackedStringArray = folders.named_by.get_or_add(
			file.get_base_dir(), PackedStringArray()
		)
		for path: String in named_by[file]:
			var folder := path.get_base_dir()
			if folder != file.get_base_dir() and not named.has(folder):
				named.append(folder)
		folders.named_by[file.get_base_dir()] = named
	return folders


## Every group in which each member leads to each other one, as one text: `a.gd, b.gd`.
func circles() -> PackedStringArray:
	var found: PackedStringArray = []
	var reached: Dictionary[String, Dictionary] = {}
	for start: String in named_by:
		reached[start] = _reached_from(start)
	for start: String in named_by:
		var members: PackedStringArray = [start]
		for other: String in reached[start]:
			if other != start and reached[other].has(start):
				members.append(other)
		members.sort()
		if members.size() > 1 and members[0] == start:
			found.append(", ".join(members))
	return found


## Every arrow from a file to one of a later layer. [param layers] are folders or files, the lowest
## first; a file belongs to the longest one that its path begins with. A file in no layer is listed,
## too.
func arrows_up(layers: PackedStringArray) -> PackedStringArray:
	var found: PackedStringArray = []
	for file: String in named_by:
		var from := _layer_of(file, layers)
		if from < 0:
			found.append("%s is in no layer" % file)
		for path: String in named_by[file]:
			if from < _layer_of(path, layers):
				found.append("%s names %s" % [file, path])
	return found


func _names(file: String, text: String) -> PackedStringArray:
	var paths: PackedStringArray = []
	if file.get_extension() != "gd":
		for found: RegExMatch in RegEx.create_from_string('path="([^"]+)"').search_all(text):
			paths.append(found.get_string(1))
		return paths
	for word: String in WrittenCode.names_in(text):
		if _class_paths.has(word):
			paths.append(_class_paths[word])
	for string: String in WrittenCode.strings_in(text):
		paths.append(string)
		paths.append(file.get_base_dir().path_join(string).simplify_path())
	return paths


func _reached_from(start: String) -> Dictionary[String, bool]:
	var reached: Dictionary[String, bool] = {}
	var waiting: PackedStringArray = [start]
	while not waiting.is_empty():
		var next := waiting[-1]
		waiting.remove_at(waiting.size() - 1)
		for path: String in named_by.get(next, PackedStringArray()):
			if not reached.has(path):
				reached[path] = true
				waiting.append(path)
	return reached


func _layer_of(file: String, layers: PackedStringArray) -> int:
	var found := -1
	for index: int in layers.size():
		var is_in := file == layers[index] or file.begins_with(layers[index] + "/")
		if is_in and (found < 0 or layers[index].length() > layers[found].length()):
			found = index
	return found
