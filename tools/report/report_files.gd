extends RefCounted
## Writes the files of build/report/.

const FOLDER := "res://build/report"


static func write(problems: Array[ReportProblem], measurements: Array[Measurement]) -> void:
	_write_text("error_vs_time.csv", MeasurementTable.to_csv(measurements))
	for problem: ReportProblem in problems:
		var rows := _rows_of(problem, measurements)
		_write_text(problem.id + ".svg", ProblemPicture.of(problem, rows))


static func _rows_of(
	problem: ReportProblem, measurements: Array[Measurement]
) -> Array[Measurement]:
	return measurements.filter(
		func(row: Measurement) -> bool: return row.problem == problem.id
	)


static func _write_text(file_name: String, text: String) -> void:
	FileAccess.open(FOLDER.path_join(file_name), FileAccess.WRITE).store_string(text)
