extends SceneTree
## Measures every method at every problem, and writes what came of it into build/report/.
## Usage: godot --headless --fixed-fps 60 --path . -s tools/report/report.gd
## -- [--quick] [--problems=NUMBER,...]

const OtherLibraries := preload("other_libraries.gd")
const ReportFiles := preload("report_files.gd")
const Runner := preload("runner.gd")

const PROBLEMS := "--problems="

var _is_quick := false
var _numbers: PackedInt32Array = []


func _init() -> void:
	for argument: String in OS.get_cmdline_user_args():
		if argument == "--quick":
			_is_quick = true
		elif argument.begins_with(PROBLEMS):
			for number: String in argument.trim_prefix(PROBLEMS).split(","):
				_numbers.append(number.to_int())
	# A node can be added only once the tree has begun to run.
	await process_frame
	var problems := _wanted_problems()
	var measurements: Array[Measurement] = []
	var others := OtherLibraries.measurements()
	for problem: ReportProblem in problems:
		measurements.append_array(await Runner.measure(problem, _is_quick, root))
		measurements.append_array(Measurement.of_problem(problem.id, others))
	ReportFiles.write(problems, measurements, " --quick" if _is_quick else "")
	quit()


func _wanted_problems() -> Array[ReportProblem]:
	var all := ReportProblems.all()
	var wanted: Array[ReportProblem] = []
	for index: int in all.size():
		if _numbers.is_empty() or _numbers.has(index + 1):
			wanted.append(all[index])
	return wanted
