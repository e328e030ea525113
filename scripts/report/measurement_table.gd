class_name MeasurementTable
extends RefCounted
## Measurements as comma-separated values (RFC 4180), and back: the file error_vs_time.csv.
##
## Numbers have all the digits that tell one double from the next. The error of a measurement
## without an answer is an empty cell. What has no column of its own, the figures, is in the note.

## The first line.
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


## The cells of one line, without their quotes. Line breaks inside of cells are not known here:
## none is ever written.
static func cells(line: String) -> PackedStringArray:
	var found: PackedStringArray = [""]
	var is_quoted := false
	var last := ""
	for character in line:
		if character == '"':
			is_quoted = not is_quoted
			# Two quotes inside of quotes are one: the second opens again.
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
		"1" if measurement.is_peer else "0",
		String.num_scientific(measurement.run_time_us),
		String.num_scientific(measurement.error) if measurement.has_answer() else "",
		_cell(measurement.error_unit),
		_cell(measurement.note),
		_quartile(measurement.lower_quartile_us),
		_quartile(measurement.upper_quartile_us),
	]
	return ",".join(texts)


static func _quartile(value: float) -> String:
	return String.num_scientific(value) if is_finite(value) else ""


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
				measurement.is_peer = text == "1"
			"run_time_us":
				measurement.run_time_us = text.to_float()
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


static func _cell(text: String) -> String:
	var on_one_line := text.replace("\n", " ")
	if on_one_line.contains(",") or on_one_line.contains('"'):
		return '"%s"' % on_one_line.replace('"', '""')
	return on_one_line
