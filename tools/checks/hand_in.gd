extends RefCounted
## One student's files, judged from beginning to end in children of their own.

const _WAIT := 2

## What the judge says.
var report := WorkshopReport.new()

var _folder := ""


## The hand-in in a folder.
func _init(folder: String) -> void:
	_folder = folder


## Judges the classes, then the tests; waits for both.
func judge() -> void:
	var known := -1
	while not report.is_complete and report.verdicts.size() > known:
		known = report.verdicts.size()
		_run("judge", PackedInt32Array(report.verdicts.keys()))
	if WorkshopFiles.tests(_folder):
		_run("tests", [])


## A line for each exercise that was begun: its number, what became of it, the mistake's number, the
## file, the line, the probe and the sentence; then the tests, and the mark.
func rows() -> PackedStringArray:
	var lines: PackedStringArray = []
	for number in report.verdicts:
		var verdict := report.verdicts[number]
		var kind: String = WorkshopVerdict.Kind.keys()[verdict.kind]
		if verdict.kind != WorkshopVerdict.Kind.OPEN:
			var fields := [number, kind.to_lower(), verdict.mistake, verdict.file, verdict.line]
			fields.append_array([verdict.probe, verdict.sentence])
			lines.append("\t".join(fields))
	if report.tests:
		var tests := report.tests
		var counts := "%d of %d" % [tests.found.size(), tests.found.size() + tests.missed.size()]
		lines.append("tests\t%s\t\t\t\t\t%s" % [counts, tests.sentence()])
	lines.append("mark\t%s\t\t\t\t\t" % WorkshopReport.name_of(report.mark()))
	return lines


func _run(task: String, skipped: PackedInt32Array) -> void:
	var child := WorkshopChild.new(task, _folder, skipped)
	var begun := Time.get_ticks_msec()
	var is_done := false
	while (
		not is_done and Time.get_ticks_msec() - begun < WorkshopWatcher.PATIENCE_WITH_TESTS * 1000.0
	):
		var was_running := child.is_running()
		for message in child.said():
			_take(message)
			is_done = true
		is_done = is_done or not was_running
		OS.delay_msec(_WAIT)
	child.stop()


func _take(message: Dictionary) -> void:
	if message.has("report"):
		report.take(WorkshopAny.dictionary(message["report"]))
	elif message.has("tests"):
		report.tests = WorkshopTestsVerdict.from_dictionary(
			WorkshopAny.dictionary(message["tests"])
		)
