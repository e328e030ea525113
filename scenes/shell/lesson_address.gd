class_name LessonAddress
extends Node
## The address of the page follows the board: loading the page again, or going back to it, shows it
## as it was. Each lesson has an entry of its own in the browser's history.

## The address of the board as it is now, behind its #.
signal changed(text: String)

## Seconds between two changes, at least: browsers refuse many at once.
const INTERVAL := 0.5

var _id: String
var _link: BoardLink
var _seconds := INTERVAL
var _is_due := false


## Of the lesson [param id], with [param link] to its board.
func _init(id: String, link: BoardLink) -> void:
	_id = id
	_link = link


## The page gets the address of the lesson, which has just been opened, and [param title], and
## follows each of [param changes]. [param adds_entry]: going back in the browser leads to what was
## there before.
func tell_page(title: String, adds_entry: bool, changes: Array[Signal]) -> void:
	changed.connect(_replace)
	for change in changes:
		change.connect(note)
	# An address that names the lesson is left as it came.
	if not _is_named():
		WebPage.set_address(_link.text(), adds_entry)
	WebPage.show_title(title)


## The page gets the address and the title of the start screen.
static func tell_page_of_start() -> void:
	if LessonIndex.find(LessonRequest.id_in(WebPage.fragment())):
		WebPage.set_address("", true)
	WebPage.show_title("")


## What the address should say has changed.
func note(..._arguments: Array) -> void:
	_is_due = true


func _process(delta: float) -> void:
	_seconds += delta
	if _is_due and _seconds >= INTERVAL:
		_tell()


func _exit_tree() -> void:
	if _is_due:
		_tell()


# A board that no link can hold leaves the address as it is.
func _tell() -> void:
	_is_due = false
	_seconds = 0.0
	if not _link.problem():
		changed.emit(_link.text())


# Not where the browser has gone to another entry meanwhile.
func _replace(text: String) -> void:
	if _is_named():
		WebPage.set_address(text, false)


func _is_named() -> bool:
	return LessonRequest.id_in(WebPage.fragment()) == _id
