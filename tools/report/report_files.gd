extends RefCounted
## Writes the files of build/report/.

const FOLDER := "res://build/report"


static func write(_problems: Array[ReportProblem], measurements: Array[Measurement]) -> void:
	_write_text("error_vs_time.csv", MeasurementTable.to_csv(measurements))


static func _write_text(file_name: String, text: String) -> void:
	FileAccess.open(FOLDER.path_join(file_name), FileAccess.WRITE).store_string(text)
