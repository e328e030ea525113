extends RefCounted
## The table of all hand-ins in a folder: `results.csv`, to go on from, and `results.md`, to read.
## Each row is written when it is known, so nothing is lost when the check is stopped.

const HandInRow := preload("hand_in_row.gd")
const ClassSummary := preload("class_summary.gd")

var _csv := ""
var _markdown := ""
var _rows: Dictionary[String, HandInRow] = {}


## The table in [param folder]; [param is_new] leaves out what is there already.
func _init(folder: String, is_new: bool) -> void:
	_csv = folder.path_join("results.csv")
	_markdown = folder.path_join("results.md")
	if not is_new:
		_read()
	_write()


## "" if both files can be written; else one sentence.
func problem() -> String:
	for path: String in [_csv, _markdown]:
		if not FileAccess.file_exists(path):
			return "%s cannot be written." % path
	return ""


## Whether there is a row of these very files.
func has(row: HandInRow) -> bool:
	return _rows.has(row.name) and _rows[row.name].sum == row.sum


## The rows, by name.
func rows() -> Array[HandInRow]:
	var names := PackedStringArray(_rows.keys())
	names.sort()
	var found: Array[HandInRow] = []
	for name in names:
		found.append(_rows[name])
	return found


## Adds a row to both files.
func add(row: HandInRow) -> void:
	_rows[row.name] = row
	var csv := FileAccess.open(_csv, FileAccess.READ_WRITE)
	csv.seek_end()
	csv.store_csv_line(row.fields())
	var markdown := FileAccess.open(_markdown, FileAccess.READ_WRITE)
	markdown.seek_end()
	markdown.store_line(ClassSummary.row_text(row))


## Writes both anew, in order, with the copies and the summary of the class.
func finish() -> void:
	for row in rows():
		var same: PackedStringArray = []
		for other in rows():
			if row.shape and other.shape == row.shape and other != row:
				same.append(other.name)
		row.same_as = "; ".join(same)
	_write()
	var file := FileAccess.open(_markdown, FileAccess.READ_WRITE)
	file.seek_end()
	file.store_string(ClassSummary.text_of(rows()))


# A row that was cut off when the check was stopped has too few fields, or another checksum.
func _read() -> void:
	var file := FileAccess.open(_csv, FileAccess.READ)
	if not file or file.get_csv_line() != HandInRow.heads():
		return
	while not file.eof_reached():
		var fields := file.get_csv_line()
		if fields.size() == HandInRow.heads().size():
			var row := HandInRow.new()
			row.take(fields)
			_rows[row.name] = row


# A file gets its name when it is whole.
func _write() -> void:
	var csv := FileAccess.open(_csv + ".part", FileAccess.WRITE)
	var markdown := FileAccess.open(_markdown + ".part", FileAccess.WRITE)
	if not csv or not markdown:
		return
	csv.store_csv_line(HandInRow.heads())
	markdown.store_string(ClassSummary.head())
	for row in rows():
		csv.store_csv_line(row.fields())
		markdown.store_line(ClassSummary.row_text(row))
	csv.close()
	markdown.close()
	for path: String in [_csv, _markdown]:
		DirAccess.rename_absolute(path + ".part", path)
