class_name HandIns
extends RefCounted
## The hand-ins in tests/data/hand_ins, and what the judge has to say of each.


## One line of the table: what is expected of an exercise of a hand-in.
class Expected:
	extends RefCounted
	## The name of the hand-in's folder.
	var hand_in: String
	## The number of the exercise.
	var exercise: int
	## What becomes of it, as in [enum WorkshopVerdict.Kind], in small letters.
	var kind: String
	## The number of the mistake.
	var mistake: int
	## What the sentence must hold.
	var words: String


## Where they are.
const FOLDER := "res://tests/data/hand_ins"

const _TABLE := "res://tests/data/hand_ins/expected.csv"


## The whole table.
static func expected() -> Array[Expected]:
	var rows: Array[Expected] = []
	var file := FileAccess.open(_TABLE, FileAccess.READ)
	file.get_csv_line()
	while not file.eof_reached():
		var fields := file.get_csv_line()
		if fields.size() == 5:
			var row := Expected.new()
			row.hand_in = fields[0]
			row.exercise = fields[1].to_int()
			row.kind = fields[2]
			row.mistake = fields[3].to_int()
			row.words = fields[4]
			rows.append(row)
	return rows


## "" if a verdict is as expected; else what differs.
static func difference(row: Expected, verdict: WorkshopVerdict) -> String:
	if not verdict:
		return "%s, exercise %d: no verdict" % [row.hand_in, row.exercise]
	var kind: String = WorkshopVerdict.Kind.keys()[verdict.kind]
	if kind.to_lower() == row.kind and verdict.mistake == row.mistake:
		if row.words == "" or verdict.sentence.contains(row.words):
			return ""
	var told := [row.hand_in, row.exercise, kind.to_lower(), verdict.mistake, verdict.sentence]
	return "%s, exercise %d: %s, mistake %d: %s" % told
