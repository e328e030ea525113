class_name WorkshopTest
extends ScreenTest
## The base of tests of the workshop's screens: the lab's own watcher looks at a folder of theirs.

const _FOLDER := "user://workshop_screens_%d"
## Frames in which a verdict must have come.
const _PATIENCE := 15_000

## The lab's own watcher.
var watcher: WorkshopWatcher


func before_each() -> void:
	super.before_each()
	DirAccess.make_dir_recursive_absolute(folder())
	WorkshopFiles.put_starters(folder())
	watcher = WorkshopLabWatcher.of(get_tree())
	watcher.folder = folder()
	look_again()


func after_each() -> void:
	await super.after_each()
	for file in DirAccess.get_files_at(folder()):
		DirAccess.remove_absolute(folder().path_join(file))
	DirAccess.remove_absolute(folder())


## Where the student's files are.
func folder() -> String:
	return _FOLDER % OS.get_process_id()


## Forgets the report, and has the files judged.
func look_again() -> void:
	watcher.report = null
	watcher.check_now()


## Writes [param body] as the body of a method of MyVec2, in place of the starter's, and saves.
func write(method: String, body: String) -> void:
	var path := folder().path_join("my_vec2.gd")
	var lines := FileAccess.get_file_as_string(path).split("\n")
	for i in lines.size():
		if lines[i].begins_with("func %s(" % method):
			lines[i + 1] = "\t" + body
	FileAccess.open(path, FileAccess.WRITE).store_string("\n".join(lines))


## Writes the right answers to exercises 1 and 2.
func write_first_two() -> void:
	write("normalized", "return scaled(0.0 if length() == 0.0 else 1.0 / length())")
	write("normal", "return MyVec2.new(-y, x).normalized()")


## Waits until all that is saved has its verdict.
func judged() -> void:
	await until(func() -> bool: return watcher.report != null and watcher.report.is_complete)
	await student.settle()


## Waits until [param holds], with patience.
func until(holds: Callable) -> void:
	for frame_number in _PATIENCE:
		var is_done: bool = holds.call()
		if is_done:
			return
		await get_tree().process_frame
		OS.delay_msec(2)
	var known := watcher.report.to_dictionary() if watcher.report else {}
	fail_test("what is waited for has not come; the report: %s" % JSON.stringify(known))
