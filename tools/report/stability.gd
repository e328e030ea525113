extends SceneTree
## Prints the table of stiff and extreme cases, a line a case; ends with exit code 1 if one fails.
## Usage: tools/commands/stability.sh, which says what can be asked for.

const _NO_CASE := 2

var _is_quick := false
var _word := ""


func _init() -> void:
	for argument in OS.get_cmdline_user_args():
		_is_quick = _is_quick or argument == "--quick"
		if argument.begins_with("--word="):
			_word = argument.trim_prefix("--word=")
	var cases: Array[StabilityCase] = StabilityCases.all().filter(_is_asked_for)
	if cases.is_empty():
		printerr("lab: no case has '%s' in its title" % _word)
		quit(_NO_CASE)
		return
	_try(cases)


func _is_asked_for(case: StabilityCase) -> bool:
	return case.title.containsn(_word) or _word == ""


func _try(cases: Array[StabilityCase]) -> void:
	var start := Time.get_ticks_msec()
	var failed := 0
	print("| | what | criterion | figure |\n|---|---|---|---|")
	var left_out := 0
	for case in cases:
		if _is_quick and not case.has_quick_form():
			left_out += 1
			continue
		var result := case.run(_is_quick and case.is_long)
		failed += int(not result.passed)
		print(_line(case, result))
	var seconds := (Time.get_ticks_msec() - start) / 1000.0
	var passed := cases.size() - left_out - failed
	print("\n%d passed, %d failed, in %.1f s" % [passed, failed, seconds])
	if left_out:
		print("%d left out: they take long, and a quick form would repeat another case" % left_out)
	quit(mini(failed, 1))


func _line(case: StabilityCase, result: StabilityResult) -> String:
	var what := case.title_in_brief() if _is_quick else case.title
	var verdict := "pass" if result.passed else "FAIL"
	return "| %s | %s | %s | %s |" % [verdict, what, case.criterion, result.figure]
