class_name LibraryText
extends RefCounted
## The section of the report on where other libraries win, if they were measured.

## Their names in tables.
const LIBRARIES: PackedStringArray = ["Box2D", "Chipmunk"]


## The section in Markdown; "" if no library was measured.
static func of(problems: Array[ReportProblem], measurements: Array[Measurement]) -> String:
	var lines: PackedStringArray = []
	var is_measured := false
	for problem in problems:
		var rows := Measurement.of_problem(problem.id, measurements)
		for situation in ProblemPicture.situations_in(rows):
			var rows_there := ProblemPicture.in_situation(situation, rows)
			for library in LIBRARIES:
				var theirs := _of_method(library, rows_there)
				is_measured = is_measured or not theirs.is_empty()
				lines.append_array(_wins(problem, _of_method(problem.champion, rows_there), theirs))
	if not is_measured:
		return ""
	if lines.is_empty():
		lines.append("Nowhere in this run.")
	return "## Where Box2D and Chipmunk win\n\n" + "\n".join(lines)


# A line for the fastest setting of a library if it is faster than the champion, and a line for its
# most exact setting if that is more exact.
static func _wins(
	problem: ReportProblem, champions: Array[Measurement], theirs: Array[Measurement]
) -> PackedStringArray:
	var lines: PackedStringArray = []
	var own := SituationText.fastest(champions, false)
	var fast := SituationText.fastest(theirs, true)
	var exact := SituationText.most_exact(theirs, true)
	if own and fast and fast.run_time_us < own.run_time_us:
		var ratio := FigureText.ratio(own.run_time_us, fast.run_time_us)
		lines.append(_line(problem, fast, "%s times as fast as %s" % [ratio, own.method], own))
	if own and exact and exact.error < own.error:
		lines.append(_line(problem, exact, "more exact than %s" % own.method, own))
	return lines


static func _line(
	problem: ReportProblem, row: Measurement, what: String, own: Measurement
) -> String:
	var parts := [problem.title, row.situation, SituationText.name_of(row), what]
	var errors := [FigureText.of(row), FigureText.of(own)]
	return "- %s, %s: %s is %s" % parts + "; error %s against %s." % errors


static func _of_method(method: String, rows: Array[Measurement]) -> Array[Measurement]:
	return rows.filter(func(row: Measurement) -> bool: return row.method == method)
