extends RefCounted
## What tools/report/libraries.py has measured, as baselines.

const FILE := "res://build/report/libraries.json"


## All of it; nothing where that file is not there.
static func measurements() -> Array[Measurement]:
	var found: Array[Measurement] = []
	if not FileAccess.file_exists(FILE):
		return found
	var results: Array = JSON.parse_string(FileAccess.get_file_as_string(FILE))
	for result: Dictionary in results:
		var case := Told.new(result)
		found.append(case.result())
	return found


## A case that has been run elsewhere.
class Told:
	extends MeasuredCase

	func _init(told: Dictionary) -> void:
		problem = told["problem"]
		method = told["method"]
		situation = told["situation"]
		tuning = told["tuning"]
		is_baseline = true
		var time: float = told["run_time_us"]
		keep_run(time)
		if told.has("end"):
			var end: Array = told["end"]
			_judge(end)
		else:
			_take_figures(told)

	func run_once() -> void:
		pass

	func _judge(end: Array) -> void:
		var x: float = end[0]
		var y: float = end[1]
		for shot: Shot in BallInBoxProblem.shots():
			if shot.situation == situation:
				shot.judge(self, Vec2.new(x, y), [])

	func _take_figures(told: Dictionary) -> void:
		error = told["error"]
		for figure: String in ["energy drift", "reversed"]:
			figures[figure] = told[figure]
		note = (
			"energy off by %s of itself; reversed, 1 px off its own way after %.2f s"
			% [FigureText.short(figures["energy drift"]), figures["reversed"]]
		)
