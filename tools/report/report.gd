extends SceneTree
## Measures every method at every problem, and writes what came of it into build/report/.
## Usage: godot --headless --fixed-fps 60 --path . -s tools/report/report.gd
## -- [--quick] [--problems=NUMBER,...] [--against=FILE]... [--also=FILE]...

const OtherLibraries := preload("other_libraries.gd")
const ReportFiles := preload("report_files.gd")
const Runner := preload("runner.gd")

const PROBLEMS := "--problems="
const AGAINST := "--against="
const ALSO := "--also="

var _is_quick := false
var _numbers: PackedInt32Array = []
var _olds: Array[Array] = []
## Further reports of what is measured now.
var _others: Array[Array] = []


func _init() -> void:
	TranslationServer.set_locale(LabText.ENGLISH)
	for argument: String in OS.get_cmdline_user_args():
		if argument == "--quick":
			_is_quick = true
		elif argument.begins_with(PROBLEMS):
			for number: String in argument.trim_prefix(PROBLEMS).split(","):
				_numbers.append(number.to_int())
		elif argument.begins_with(AGAINST):
			_olds.append(_read(argument.trim_prefix(AGAINST)))
		elif argument.begins_with(ALSO):
			_others.append(_read(argument.trim_prefix(ALSO)))
	# A node can be added only once the tree has begun to run.
	await process_frame
	var problems := _wanted_problems()
	var measurements: Array[Measurement] = []
	var others := OtherLibraries.measurements()
	for problem: ReportProblem in problems:
		measurements.append_array(await Runner.measure(problem, _is_quick, root))
		measurements.append_array(Measurement.of_problem(problem.id, others))
	ReportFiles.write(
		problems, measurements, " --quick" if _is_quick else "", _compare(measurements)
	)
	quit()


func _read(file: String) -> Array[Measurement]:
	return MeasurementTable.from_csv(FileAccess.get_file_as_string(file))


## The part of the report on older ones, also printed; "" where none is given.
func _compare(measurements: Array[Measurement]) -> String:
	if _olds.is_empty():
		return ""
	var news: Array[Array] = [measurements]
	news.append_array(_others)
	var text := ComparisonText.of(RunTimeRatio.of(_olds, news), _olds.size(), news.size())
	print("\n" + text)
	return text


func _wanted_problems() -> Array[ReportProblem]:
	var all := ReportProblems.all()
	var wanted: Array[ReportProblem] = []
	for index: int in all.size():
		if _numbers.is_empty() or _numbers.has(index + 1):
			wanted.append(all[index])
	return wanted
