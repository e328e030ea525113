class_name OwnCodeTexts
extends RefCounted
## What the lab says of the student's code, translated.

# So many mistakes that his tests miss are named.
const _MOST_NAMED := 3


## Number and title of an exercise.
static func heading(exercise: WorkshopExercise) -> String:
	return LabText.translate("Exercise %d: %s") % [exercise.number, exercise.title]


## The file of a verdict, its line, and the mistake's number in the course's list.
static func place(verdict: WorkshopVerdict) -> String:
	# With blanks, because a narrow panel has no room for the whole path in one line.
	var parts: PackedStringArray = [WorkshopFiles.FOLDER.get_file() + " / " + verdict.file]
	if verdict.line > 0:
		parts.append(LabText.translate("line %d") % verdict.line)
	if verdict.mistake > 0:
		parts.append(LabText.translate("mistake %d") % verdict.mistake)
	return ", ".join(parts)


## The letter on the ball.
static func sign_of(verdict: WorkshopVerdict) -> String:
	match verdict.kind:
		WorkshopVerdict.Kind.RIGHT:
			return "✓"
		WorkshopVerdict.Kind.OPEN:
			return "…"
		WorkshopVerdict.Kind.WAITING:
			return "↑"
		WorkshopVerdict.Kind.REFUSED:
			return "?"
	return "✗"


## The color of the ball.
static func role_of(verdict: WorkshopVerdict) -> Palette.Role:
	match verdict.kind:
		WorkshopVerdict.Kind.RIGHT:
			return Palette.Role.RIGHT
		WorkshopVerdict.Kind.OPEN, WorkshopVerdict.Kind.WAITING, WorkshopVerdict.Kind.REFUSED:
			return Palette.Role.QUIET
	return Palette.Role.WRONG


## An answer as a student reads it: `true`, `50` or `(4, −3)`.
static func answer(task: WorkshopTask, numbers: PackedFloat64Array) -> String:
	if numbers.is_empty():
		return LabText.translate("nothing")
	if task.gives == "b":
		return "true" if numbers[0] == 1.0 else "false"
	return WorkshopVerdict.text_of(numbers)


## What a call costs, beside the lab's own.
static func run_time(verdict: WorkshopVerdict) -> String:
	return LabText.translate("%s ns") % NumberText.short(verdict.nanoseconds(), 2)


## How many times as long as the lab's own it takes.
static func ratio(verdict: WorkshopVerdict) -> String:
	return LabText.translate("%s times") % NumberText.short(verdict.ratio(), 2)


## What his tests are worth; "" before they were judged.
static func tests(verdict: WorkshopTestsVerdict) -> String:
	if not verdict:
		return ""
	var told := verdict.sentence()
	if verdict.missed.is_empty() or verdict.red_on_right or verdict.unreadable:
		return told
	return told + " " + LabText.translate("Still green: %s.") % ", ".join(_named(verdict.missed))


# The methods, each once: what is wrong with them is to be found out.
static func _named(missed: PackedStringArray) -> PackedStringArray:
	var names: PackedStringArray = []
	for way in missed:
		var method := way.get_slice(":", 0)
		if not method in names:
			names.append(method)
	if names.size() > _MOST_NAMED:
		return names.slice(0, _MOST_NAMED) + PackedStringArray(["…"])
	return names


## The mark by the course's rubric, and what the next one asks for.
static func mark(report: WorkshopReport) -> String:
	var reached := report.mark()
	var told := LabText.translate("Mark: %s.") % WorkshopReport.name_of(reached)
	if reached == WorkshopReport.Mark.EXCELLENT:
		return told
	var next := WorkshopReport.name_of((reached + 1) as WorkshopReport.Mark)
	var asked := LabText.translate("For %s: %s.") % [next, ", ".join(_missing(report, reached))]
	return told + " " + asked


static func _missing(report: WorkshopReport, reached: WorkshopReport.Mark) -> PackedStringArray:
	var missing: PackedStringArray = []
	for exercise in _asked_beyond(reached):
		if not report.is_right(exercise):
			missing.append(LabText.translate("exercise %d") % exercise)
	var is_next_good := reached == WorkshopReport.Mark.SUFFICIENT
	if is_next_good and not report.is_right(WorkshopIndex.TESTS):
		missing.append(LabText.translate("tests that find 80 % of the mistakes"))
	if reached == WorkshopReport.Mark.GOOD:
		if report.tests.missed:
			missing.append(LabText.translate("tests that find all mistakes"))
		if not report.verdicts[9].is_excellent:
			missing.append(LabText.translate("exercise 9 with any normal"))
	return missing


static func _asked_beyond(reached: WorkshopReport.Mark) -> PackedInt32Array:
	match reached:
		WorkshopReport.Mark.NOT_YET:
			return WorkshopReport.SUFFICIENT
		WorkshopReport.Mark.SUFFICIENT:
			return WorkshopReport.GOOD
	return WorkshopReport.EXCELLENT
