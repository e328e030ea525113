extends RefCounted
## Writes the files of build/report/.

const RubricText := preload("../web/rubric_text.gd")

const FOLDER := "res://build/report"

# Where `./lab serve` shows the lab.
const _SERVED_LAB := "http://127.0.0.1:8000/lab/index.html"
# From that folder to a file of the project.
const _SOURCE := "../../%s"


## [param comparison] ends report.md; may be "".
static func write(
	problems: Array[ReportProblem],
	measurements: Array[Measurement],
	form: String,
	comparison: String
) -> void:
	_write_text("error_vs_time.csv", MeasurementTable.to_csv(measurements))
	for problem: ReportProblem in problems:
		var rows := Measurement.of_problem(problem.id, measurements)
		_write_text(problem.id + ".svg", ProblemPicture.of(problem, rows))
	var text := ReportText.of(problems, measurements, _circumstances(form))
	_write_text("rubric.html", RubricText.page(_SERVED_LAB, _SOURCE))
	_write_text("report.md", text + ("\n" + comparison if comparison else ""))


static func _circumstances(form: String) -> String:
	var facts := [
		form, Engine.get_version_info()["string"], OS.get_processor_name(), OS.get_processor_count()
	]
	return (
		(
			"Measured by `./lab report%s` with Godot %s, headless, in one process, on %s (%d threads)."
			% facts
		)
		+ " A run time is the median of 5 runs; the runs of all methods take turns."
	)


static func _write_text(file_name: String, text: String) -> void:
	FileAccess.open(FOLDER.path_join(file_name), FileAccess.WRITE).store_string(text)
