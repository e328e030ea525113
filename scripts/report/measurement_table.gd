class_name MeasurementTable
extends RefCounted
## Measurements as comma-separated values (RFC 4180), and back: the file error_vs_time.csv.
##
## Numbers have all the digits that tell one double from the next. A measurement without an answer
## has an empty cell for its error, and an empty one for its run time if a world refused to go on.
## The figures have no column of their own; what matters of them is in the note.

## The first line. The column "peer" is [member Measurement.is_baseline]: it has kept its old name,
## so that older files can still be compared with new ones.
const COLUMNS := (
	"problem,method,setting,peer,run_time_us,error,error_unit,note"
	+ ",lower_quartile_us,upper_quartile_us"
)


## The whole text, a line each.
static func to_csv(measurements: Array[Measurement]) -> String:
	var lines: PackedStringArray = [COLUMNS]
	for measurement in measurements:
		lines.append(_line(measurement))
	return "\n".join(lines) + "\n"


## The measurements in a text of [method to_csv]; none when its first line lacks a column that tells
## rows apart or the run time. Older reports lack the quartiles: they stay NAN. The setting is not
## taken apart again: all of it is in [member Measurement.situation].
static func from_csv(text: String) -> Array[Measurement]:
	var found: Array[Measurement] = []
	var lines := text.strip_edges().split("\n")
	var columns := cells(lines[0])
	for wanted: String in ["problem", "method", "setting", "peer", "run_time_us"]:
		if not columns.has(wanted):
			return found
	for line in lines.slice(1):
		found.append(_measurement(columns, cells(line)))
	return found


## The cells of one line, without their quotes. Cells with line breaks are not supported, because
## none is ever written.
static func cells(line: String) -> PackedStringArray:
	var found: PackedStringArray = [""]
	var is_quoted := false
	var last := ""
	for character in line:
		if character == '"':
			is_quoted = not is_quoted
			# Two quotes within quotes stand for one: the second opens the cell again.
			if is_quoted and last == '"':
				found[-1] += '"'
		elif character == "," and not is_quoted:
			found.append("")
		else:
			found[-1] += character
		last = character
	return found


static func _line(measurement: Measurement) -> String:
	var texts: PackedStringArray = [
		_cell(measurement.problem),
		_cell(measurement.method),
		_cell(measurement.setting),
		"1" if measurement.is_baseline else "0",
		_number(measurement.run_time_us),
		_number(measurement.error),
		_cell(measurement.error_unit),
		_cell(measurement.note),
		_number(measurement.lower_quartile_us),
		_number(measurement.upper_quartile_us),
	]
	return ",".join(texts)


static func _measurement(columns: PackedStringArray, texts: PackedStringArray) -> Measurement:
	var measurement := Measurement.new()
	for index: int in mini(columns.size(), texts.size()):
		var text := texts[index]
		match columns[index]:
			"problem":
				measurement.problem = text
			"method":
				measurement.method = text
			"setting":
				measurement.situation = text
			"peer":
				measurement.is_baseline = text == "1"
			"run_time_us":
				measurement.run_time_us = text.to_float() if text else Measurement.NO_ANSWER
			"lower_quartile_us":
				measurement.lower_quartile_us = text.to_float() if text else NAN
			"upper_quartile_us":
				measurement.upper_quartile_us = text.to_float() if text else NAN
			"error":
				measurement.error = text.to_float() if text else Measurement.NO_ANSWER
			"error_unit":
				measurement.error_unit = text
			"note":
				measurement.note = text
	return measurement


static func _number(value: float) -> String:
	return String.num_scientific(value) if is_finite(value) else ""


static func _cell(text: String) -> String:
	var on_one_line := text.replace("\n", " ")
	if on_one_line.contains(",") or on_one_line.contains('"'):
		return '"%s"' % on_one_line.replace('"', '""')
	return on_one_line
