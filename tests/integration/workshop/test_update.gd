extends LabTest
## A newer copy of the project, unpacked over an older one or pulled by git, leaves what the student
## has written, and the lab goes on judging it.

const _OLD := "user://workshop_update_old"
const _NEW := "user://workshop_update_new"
const _OPEN := "(other: MyVec2) -> float:\n\treturn 0.0"
const _RIGHT := "(other: MyVec2) -> float:\n\treturn x * other.x + y * other.y"
const _OWN_TEST := "workshop/test_my_dot.gd"
# Files that the newer copy has changed, and one that it has not had before.
const _CHANGED: PackedStringArray = [
	"workshop/starters/my_vec2.gd", "workshop/starters/test_my_vec2.gd", "workshop/kit/judge.gd"
]
const _ADDED := "workshop/starters/my_second.gd"
# Frames in which a verdict must have come.
const _PATIENCE := 30_000

# The files that the project itself has in the workshop, and what tells git which are not its own.
var _own: PackedStringArray
var _watcher: WorkshopWatcher


func should_skip_script() -> bool:
	return not LabCommand.is_possible()


func before_each() -> void:
	_own = _listed()
	_unpack(_OLD)
	WorkshopFiles.put_starters(_OLD.path_join("workshop"))
	var text := WorkshopFiles.starter("my_vec2.gd")
	assert_string_contains(text, _OPEN)
	_write(_OLD.path_join("workshop/my_vec2.gd"), text.replace(_OPEN, _RIGHT))
	_write(_OLD.path_join(_OWN_TEST), "# mine\r\n")
	_watcher = WorkshopWatcher.new()
	_watcher.folder = _OLD.path_join("workshop")
	add_child(_watcher)


func after_each() -> void:
	_watcher.free()
	for folder: String in [_OLD, _NEW]:
		OS.execute("rm", ["-rf", ProjectSettings.globalize_path(folder)])


func test_nothing_of_the_project_has_a_name_of_the_student_s() -> void:
	assert_gt(_own.size(), WorkshopFiles.starters().size())
	for file in _own:
		var is_in_folder := file.get_base_dir() == "workshop"
		assert_false(is_in_folder and file.get_extension() == "gd", file)


func test_a_newer_copy_unpacked_over_it_leaves_his_files() -> void:
	assert_true((await _verdict()).is_right())
	var before := _sums_of_student()
	_unpack(_OLD)
	_change(_OLD)
	WorkshopFiles.put_starters(_OLD.path_join("workshop"))
	assert_eq(_sums_of_student(), before)
	assert_true((await _verdict()).is_right())


func test_a_pull_leaves_his_files() -> void:
	_begin_history(_OLD)
	assert_eq(_said_by_git(_OLD, ["status", "--short"]), "", "git does not see his files")
	_git(_OLD, ["clone", "-q", ".", ProjectSettings.globalize_path(_NEW)])
	_change(_NEW)
	_commit(_NEW)
	assert_true((await _verdict()).is_right())
	var before := _sums_of_student()
	_git(_OLD, ["pull", "-q", ProjectSettings.globalize_path(_NEW)])
	assert_true(FileAccess.file_exists(_OLD.path_join(_ADDED)), "the newer copy is there")
	WorkshopFiles.put_starters(_OLD.path_join("workshop"))
	assert_eq(_sums_of_student(), before)
	assert_true((await _verdict()).is_right())


# All files of the workshop but the student's own: not from git, because a ZIP has no history.
func _listed() -> PackedStringArray:
	var found: PackedStringArray = []
	for file in SourceCode.files_below("res://workshop", ["gd", "uid", "cfg", "tscn"]):
		var is_his := file.get_file().trim_prefix("test_").begins_with("my_")
		if not (is_his and file.get_base_dir() == "res://workshop"):
			found.append(file.trim_prefix("res://"))
	return found


func _unpack(folder: String) -> void:
	for file in _own + PackedStringArray([".gitignore"]):
		var place := folder.path_join(file)
		DirAccess.make_dir_recursive_absolute(place.get_base_dir())
		DirAccess.copy_absolute("res://".path_join(file), place)


# The newer copy differs, also in what the student's files began as.
func _change(folder: String) -> void:
	for file in _CHANGED:
		var text := FileAccess.get_file_as_string(folder.path_join(file))
		assert_ne(text, "", file)
		_write(folder.path_join(file), text + "\n# newer\n")
	_write(folder.path_join(_ADDED), "# newer\n")


func _begin_history(folder: String) -> void:
	_git(folder, ["init", "-q"])
	_commit(folder)


func _commit(folder: String) -> void:
	_git(folder, ["add", "-A"])
	_git(
		folder,
		["-c", "user.name=test", "-c", "user.email=test@localhost", "commit", "-q", "-m", "a"]
	)


func _git(folder: String, arguments: PackedStringArray) -> void:
	assert_eq(OS.execute("git", _in_folder(folder, arguments)), 0, " ".join(arguments))


func _said_by_git(folder: String, arguments: PackedStringArray) -> String:
	var said := []
	var code := OS.execute("git", _in_folder(folder, arguments), said)
	var words: String = said[0]
	return words if code == 0 else ""


static func _in_folder(folder: String, arguments: PackedStringArray) -> PackedStringArray:
	return PackedStringArray(["-C", ProjectSettings.globalize_path(folder)]) + arguments


func _write(path: String, text: String) -> void:
	FileAccess.open(path, FileAccess.WRITE).store_string(text)


# By the names of the student's files.
func _sums_of_student() -> Dictionary[String, String]:
	var sums: Dictionary[String, String] = {}
	var folder := _OLD.path_join("workshop")
	for file in WorkshopFiles.of_student(folder):
		sums[file] = FileAccess.get_sha256(folder.path_join(file))
	assert_true(sums.has("my_vec2.gd") and sums.has(_OWN_TEST.get_file()))
	return sums


# The verdict on the dot product, judged anew.
func _verdict() -> WorkshopVerdict:
	_watcher.check_now()
	_watcher.report = null
	for frame in _PATIENCE:
		await get_tree().process_frame
		OS.delay_msec(2)
		if _watcher.report and _watcher.report.is_complete:
			return _watcher.report.verdict(3)
	return WorkshopVerdict.new()
