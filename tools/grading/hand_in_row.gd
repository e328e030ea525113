extends RefCounted
## What is told of a hand-in: a row of the table.

## What is said of code that is not run.
const BY_HAND := "look by hand"

# They would change what stands around them: ends of lines, codes of a terminal, marks that turn the
# direction of reading.
const _UNPLAIN := r"[\x00-\x1f\x7f-\x9f\x{200b}-\x{200f}\x{2028}-\x{202e}\x{2066}-\x{2069}\x{feff}]"
# A spreadsheet would compute a cell that begins like this, but not behind a quotation mark.
const _FORMULA: PackedStringArray = ["=", "+", "-", "@", "'"]
const _FIRST: PackedStringArray = ["hand-in", "mark", "right"]
const _LAST: PackedStringArray = ["tests", "note", "same code as", "seconds", "code", "files"]

const _MOST_NAMED := 3

static var _unplain := RegEx.create_from_string(_UNPLAIN)

## The name of its folder or zip.
var name := ""
## What is reached by the rubric; "" where nothing was judged.
var mark := ""
## What became of each exercise, by its number: a word, and mostly a sentence behind a colon.
var cells: Dictionary[int, String] = {}
## What its tests are worth.
var tests := ""
## What is wrong with the hand-in itself.
var note := ""
## The names of those that hold the same code, between semicolons.
var same_as := ""
## How long it took.
var seconds := 0.0
## A checksum of the code but for names, blanks and comments; "" where that is too little to tell.
var shape := ""
## A checksum of the files, and of what judges them.
var sum := ""


## A text without what would change the text around it.
static func plain(text: String) -> String:
	return _unplain.sub(text, "?", true)


## The numbers of the exercises that have a column.
static func exercises() -> PackedInt32Array:
	var numbers: PackedInt32Array = []
	for exercise in WorkshopIndex.exercises():
		if exercise.tasks:
			numbers.append(exercise.number)
	return numbers


## The heads of the columns.
static func heads() -> PackedStringArray:
	var found := _FIRST.duplicate()
	for number in exercises():
		found.append("exercise %d" % number)
	return found + _LAST


## The fields in the order of [method heads].
func fields() -> PackedStringArray:
	var found: PackedStringArray = [name, mark, str(right()) if mark else ""]
	for number in exercises():
		found.append(cell(number))
	found.append_array([tests, note, same_as, "%.1f" % seconds, shape, sum])
	for index in found.size():
		if found[index] and found[index][0] in _FORMULA:
			found[index] = "'" + found[index]
	return found


## Takes over fields that [method fields] made.
func take(fields_made: PackedStringArray) -> void:
	var from := fields_made.duplicate()
	for index in from.size():
		from[index] = from[index].trim_prefix("'")
	name = from[0]
	mark = from[1]
	var column := _FIRST.size()
	for number in exercises():
		if from[column]:
			cells[number] = from[column]
		column += 1
	tests = from[column]
	note = from[column + 1]
	same_as = from[column + 2]
	seconds = from[column + 3].to_float()
	shape = from[column + 4]
	sum = from[column + 5]


## How many exercises are right.
func right() -> int:
	return cells.values().count("right")


## What became of an exercise; "" where it was not judged.
func cell(exercise: int) -> String:
	return cells.get(exercise, "")


## The word at the begin of the cell of an exercise, such as `right` or `mistake 10`.
func word(exercise: int) -> String:
	return cell(exercise).get_slice(":", 0)


## The names of the first of those that hold the same code, and how many there are besides.
func same_shortly() -> String:
	var names := same_as.split("; ", false)
	var more := names.size() - _MOST_NAMED
	var told := ", ".join(names.slice(0, _MOST_NAMED))
	return told + " and %d more" % more if more > 0 else told


## What the terminal shows.
func line() -> String:
	if not mark:
		return "%s: not judged. %s (%.1f s)" % [name, note, seconds]
	var others: PackedStringArray = []
	for number in cells:
		if not word(number) in ["right", "open"]:
			others.append("%d %s" % [number, word(number)])
	var told := "%s: %s, %d of %d right" % [name, mark, right(), cells.size()]
	if others:
		told += "; " + ", ".join(others)
	if tests:
		told += "; tests " + tests.get_slice(":", 0)
	return "%s (%.1f s)%s" % [told, seconds, " " + note if note else ""]
