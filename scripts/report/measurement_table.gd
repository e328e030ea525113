class_name MeasurementTable
extends RefCounted
## Measurements as comma-separated values (RFC 4180), and back: the file error_vs_time.csv.
##
## Numbers have all the digits that tell one double from the next. The error of a measurement
## without an answer is an empty cell. What has no column of its own, the figures, is in the note.

## The first line.
const COLUMNS := "problem,method,setting,peer,run_time_us,error,error_unit,note"


## The whole text, a line each.
static func to_csv(measurements: Array[Measurement]) -> String:
	var lines: PackedStringArray = [COLUMNS]
	for measurement in measurements:
		lines.append(_line(measurement))
	return "\n".join(lines) + "\n"


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
	]
	return ",".join(texts)


static func _cell(text: String) -> String:
	var on_one_line := text.replace("\n", " ")
	if on_one_line.contains(",") or on_one_line.contains('"'):
		return '"%s"' % on_one_line.replace('"', '""')
	return on_one_line
