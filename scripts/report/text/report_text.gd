class_name ReportText
extends RefCounted
## The text of report.md: for each problem, which methods are on the frontier, and by what ratios.


## The complete text. [param circumstances] says where and how it was measured.
static func of(
	problems: Array[ReportProblem], measurements: Array[Measurement], circumstances: String
) -> String:
	var parts: PackedStringArray = [
		"# Error against run time",
		circumstances,
		(
			"A method is on the frontier of a situation if no other is at least as good in error and in"
			+ " run time and better in one of them. Baselines are the engine's own methods and other"
			+ " libraries. Every number is in [error_vs_time.csv](error_vs_time.csv)."
		),
		_goals(measurements),
	]
	var libraries := LibraryText.of(problems, measurements)
	if libraries:
		parts.append(libraries)
	for problem in problems:
		var rows := Measurement.of_problem(problem.id, measurements)
		if not rows.is_empty():
			parts.append(_problem(problem, rows))
	return "\n\n".join(parts) + "\n"


static func _goals(measurements: Array[Measurement]) -> String:
	var lines: PackedStringArray = [
		"## What must be reached\n",
		"| goal | wanted | measured | |",
		"|---|---|---|---|",
	]
	for goal in ReportGoals.of(measurements):
		lines.append(
			"| %s | %s | %s | %s |" % [goal.what, goal.wanted, goal.measured, goal.verdict()]
		)
	return "\n".join(lines)


static func _problem(problem: ReportProblem, rows: Array[Measurement]) -> String:
	var parts: PackedStringArray = [
		"## " + problem.title,
		problem.question,
		"![Error over run time, by method](%s.svg)" % problem.id,
	]
	var situations: PackedStringArray = []
	for situation in ProblemPicture.situations_in(rows):
		var rows_there := ProblemPicture.in_situation(situation, rows)
		situations.append(SituationText.of(situation, rows_there, problem.champion))
	parts.append("\n".join(situations))
	var more := problem.remarks(rows)
	if more:
		parts.append(more)
	return "\n\n".join(parts)
