class_name Motion
extends RefCounted
## Whether things may move by themselves: as the student has chosen, else as the system or the
## browser asks for.

## Where the student's choice is kept. Tests have a file of their own.
static var file := "user://motion.txt"

static var _choice := ""


## True where nothing should move unless the student makes it move.
static func is_reduced() -> bool:
	if not _choice and FileAccess.file_exists(file):
		_choice = FileAccess.get_file_as_string(file)
	if _choice:
		return _choice == "reduced"
	# The engine says 1, or it does not know: then a browser may.
	var wish := DisplayServer.accessibility_should_reduce_animation()
	return wish == 1 or WebPage.asks_for_reduced_motion()


## The student has chosen; it is kept for the next time.
static func reduce(wanted: bool) -> void:
	_choice = "reduced" if wanted else "full"
	var kept := FileAccess.open(file, FileAccess.WRITE)
	if kept:
		kept.store_string(_choice)
