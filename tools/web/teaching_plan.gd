extends RefCounted
## The plan of docs/teaching.md, row by row: the one source of the speaker's notes and of the tests
## that walk it.

const DOCUMENT := "res://docs/teaching.md"

# What a row of the plan looks like; no other table has seven cells that begin with two numbers.
const _ROW := "(?m)^\\| (\\d+) \\| (\\d+) \\|(.+)\\|$"
const _VERSION := "(?m)^- (\\d+) minutes: ([\\d, ]+)$"
# What the last column but one holds: what to ask, and what one hopes to hear.
const _BETWEEN_QUESTION_AND_ANSWER := " – "
# The break, and the end: minutes at which a row ends although the next begins later, or never.
const _ENDS: PackedInt32Array = [50, 110, 120]

## The rows in their order.
var rows: Array[Row] = []
## The shorter versions: the numbers of their rows, by their length in minutes.
var versions: Dictionary[int, PackedInt32Array] = {}


## A row of the plan. Its texts are as the document has them, in Markdown.
class Row:
	## Its place in the plan, from 1.
	var number: int
	## When it begins, in minutes from the start.
	var minute: int
	## How long it takes.
	var minutes: int
	## The part of the lecture: its number, or a word.
	var part: String
	## What stands behind the # of the lab's address.
	var link: String
	## What the teacher shows and does.
	var show: String
	## What to ask.
	var ask: String
	## What the class should answer.
	var answer: String
	## The line of the rubric that it serves.
	var rubric: String


## Reads the plan in [param text].
func _init(text: String = FileAccess.get_file_as_string(DOCUMENT)) -> void:
	for hit in RegEx.create_from_string(_ROW).search_all(text):
		rows.append(_row(hit))
	for place in rows.size():
		rows[place].minutes = _end_of(place) - rows[place].minute
	for hit in RegEx.create_from_string(_VERSION).search_all(text):
		var numbers: PackedInt32Array = []
		for number in hit.get_string(2).split(","):
			numbers.append(number.to_int())
		versions[hit.get_string(1).to_int()] = numbers


## How long the rows with these numbers take together, in minutes.
func minutes_of(numbers: PackedInt32Array) -> int:
	var sum := 0
	for number in numbers:
		sum += rows[number - 1].minutes
	return sum


func _row(hit: RegExMatch) -> Row:
	var cells := hit.get_string(3).split("|")
	var row := Row.new()
	row.number = hit.get_string(1).to_int()
	row.minute = hit.get_string(2).to_int()
	row.part = cells[0].strip_edges()
	row.link = cells[1].replace("`", "").strip_edges()
	row.show = cells[2].strip_edges()
	row.ask = cells[3].get_slice(_BETWEEN_QUESTION_AND_ANSWER, 0).strip_edges()
	row.answer = cells[3].trim_prefix(" " + row.ask + _BETWEEN_QUESTION_AND_ANSWER).strip_edges()
	row.rubric = cells[4].strip_edges()
	return row


func _end_of(place: int) -> int:
	var begin := rows[place].minute
	var next := rows[place + 1].minute if place + 1 < rows.size() else _ENDS[-1]
	for end in _ENDS:
		if begin < end and end < next:
			return end
	return next
