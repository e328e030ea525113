extends RefCounted
## A student's files in a hand-in, found by their names at any depth: in a folder or in a zip, with
## or without the lab around them. Nothing is written, and no link is followed.

const ZipEntries := preload("zip_entries.gd")

## More test files than this are not looked at.
const MOST_TESTS := 20

const _DEEPEST := 12
# Only the lab's own project has this file; what lies elsewhere in it is not the student's.
const _MARK_OF_LAB := "workshop/kit/judge.gd"
const _NAME_OF_TEST := r"^test_my_\w+\.gd$"
const _MOST_NAMED := 5

static var _name_of_test := RegEx.create_from_string(_NAME_OF_TEST)

## Their bytes by their names, never more than the judge looks at.
var files: Dictionary[String, PackedByteArray] = {}
## One sentence for each thing that is wrong with the hand-in itself, in English.
var problems: PackedStringArray = []

var _paths: PackedStringArray = []
var _root := ""


## Looks into the hand-in at [param path].
func _init(path: String) -> void:
	_root = path
	var folder := DirAccess.open(path.get_base_dir())
	if folder.is_link(path):
		problems.append("It is a link, which is not followed.")
	elif DirAccess.dir_exists_absolute(path):
		_look_into_folder()
	elif path.get_extension().to_lower() == "zip":
		_look_into_zip(path)
	else:
		problems.append("It is neither a folder nor a .zip: each hand-in must be one of them.")
	if not files and not problems:
		problems.append(_what_is_missing())


func _look_into_folder() -> void:
	_walk("", 0)
	var found := _chosen()
	for name in found:
		var path := _root.path_join(found[name])
		var file := FileAccess.open(path, FileAccess.READ)
		if file:
			files[name] = file.get_buffer(WorkshopCode.LARGEST + 1)
		else:
			problems.append("%s cannot be read: is there a right to read it?" % found[name])
	if not found and not problems:
		for path in _paths:
			if path.get_extension().to_lower() == "zip" and not files:
				_look_into_zip(_root.path_join(path))


func _look_into_zip(path: String) -> void:
	var entries := ZipEntries.new(path)
	if entries.problem:
		problems.append(entries.problem)
		return
	_paths = entries.names()
	var found := _chosen()
	for name in found:
		var bytes := entries.bytes_of(found[name], WorkshopCode.LARGEST)
		if entries.problem:
			problems.append("%s: %s" % [found[name], entries.problem])
		else:
			files[name] = bytes


func _walk(below: String, depth: int) -> void:
	var folder := DirAccess.open(_root.path_join(below))
	if not folder:
		problems.append(
			"%s cannot be opened: is there a right to read it?" % (below if below else "It")
		)
		return
	var folders: PackedStringArray = []
	folder.list_dir_begin()
	var name := folder.get_next()
	while name and _paths.size() < ZipEntries.MOST:
		var path := below.path_join(name)
		if folder.is_link(name):
			if _is_wanted(name):
				problems.append("%s is a link, which is not followed." % path)
		elif folder.current_is_dir():
			folders.append(path)
		else:
			_paths.append(path)
		name = folder.get_next()
	if _paths.size() >= ZipEntries.MOST:
		problems.append("It holds more than %d files." % ZipEntries.MOST)
		return
	for path in folders:
		if depth < _DEEPEST:
			_walk(path, depth + 1)


# The path for each name: of several the one that is least deep.
func _chosen() -> Dictionary[String, String]:
	var places: Dictionary[String, PackedStringArray] = {}
	for path in _of_student(_paths):
		var name := path.get_file()
		if _is_wanted(name):
			var before: PackedStringArray = places.get(name, PackedStringArray())
			if not before or path.count("/") < before[0].count("/"):
				places[name] = [path]
			elif path.count("/") == before[0].count("/"):
				places[name] = before + PackedStringArray([path])
		elif _meant_by(name):
			problems.append("%s is not looked at: its name must be %s." % [path, _meant_by(name)])
	var found: Dictionary[String, String] = {}
	for name in places:
		if places[name].size() > 1:
			problems.append("There is more than one %s: %s." % [name, ", ".join(places[name])])
		else:
			found[name] = places[name][0]
	return _with_few_tests(found)


func _with_few_tests(found: Dictionary[String, String]) -> Dictionary[String, String]:
	var tests := found.keys().filter(func(name: String) -> bool: return name.begins_with("test_"))
	if tests.size() > MOST_TESTS:
		problems.append("There are more than %d test files: none is run." % MOST_TESTS)
		for name: String in tests:
			found.erase(name)
	return found


func _what_is_missing() -> String:
	var wanted := " ".join(WorkshopFiles.CLASSES.keys())
	var scripts: PackedStringArray = []
	for path in _paths:
		if path.get_extension() in ["gd", "zip", "cs", "txt"] and scripts.size() < _MOST_NAMED:
			scripts.append(path)
	var there := ", ".join(scripts) if scripts else "nothing like that"
	return "None of the student's files is there (%s test_my_*.gd); there is: %s." % [wanted, there]


# Those that can be the student's: in a copy of the lab only the ones in its workshop.
static func _of_student(paths: PackedStringArray) -> PackedStringArray:
	var labs: PackedStringArray = []
	for path in paths:
		if path == _MARK_OF_LAB or path.ends_with("/" + _MARK_OF_LAB):
			labs.append(path.trim_suffix(_MARK_OF_LAB))
	var found: PackedStringArray = []
	for path in paths:
		var is_his := not ("/" + path).contains("/__MACOSX/")
		# Neither what is hidden, nor what a zip would put elsewhere.
		is_his = is_his and not ("/" + path).contains("/.") and not path.begins_with("/")
		for lab in labs:
			if path.begins_with(lab):
				is_his = is_his and path.get_base_dir() == lab + "workshop"
		if is_his:
			found.append(path)
	return found


static func _is_wanted(name: String) -> bool:
	return WorkshopFiles.CLASSES.has(name) or _name_of_test.search(name) != null


# Such as my_vec2.gd for My_Vec2.gd, my_vec2 (1).gd, my_vec2.gd.txt; "" where none is meant.
static func _meant_by(name: String) -> String:
	var plain := name.to_lower().replace("_", "")
	if plain.contains(".gd") and not plain.ends_with(".uid"):
		for file: String in WorkshopFiles.CLASSES:
			var stem := file.get_basename().replace("_", "")
			if plain.begins_with(stem):
				return file
			if plain.begins_with("test" + stem):
				return "test_" + file
	return ""
