extends RefCounted
## Writes the results as JUnit XML, in the form that GUT writes.

const CollectedScript := preload("collected_script.gd")
const CollectedTest := preload("collected_test.gd")


static func write(scripts: Array[CollectedScript], path: String) -> void:
	var suites := PackedStringArray()
	var tests := 0
	var failures := 0
	for script: CollectedScript in scripts:
		suites.append(_suite(script))
		for test: CollectedTest in script.tests:
			tests += int(test.was_run)
			failures += int(test.is_failing())
	var text := '<?xml version="1.0" encoding="UTF-8"?>\n'
	text += '<testsuites name="GutTests" failures="%d" tests="%d">\n' % [failures, tests]
	text += "\n".join(suites) + "\n</testsuites>\n"
	FileAccess.open(path, FileAccess.WRITE).store_string(text)


static func _suite(script: CollectedScript) -> String:
	var name := script.full_name().trim_prefix("res://")
	var cases := PackedStringArray()
	var failures := 0
	var skipped := 0
	for test: CollectedTest in script.tests:
		if test.was_run:
			cases.append(_case(test, name))
			failures += test.fail_texts.size()
			skipped += test.pending_texts.size()
	var head := '  <testsuite name="%s" tests="%d" failures="%d" skipped="%d">\n'
	return (
		head % [name.xml_escape(true), cases.size(), failures, skipped]
		+ "\n".join(cases)
		+ "\n  </testsuite>"
	)


static func _case(test: CollectedTest, classname: String) -> String:
	var head := (
		'    <testcase name="%s" assertions="%d" status="%s" classname="%s" time="%f">'
		% [test.name, test.assert_count(), test.status(), classname.xml_escape(true), test.seconds]
	)
	var inside := ""
	if test.is_failing():
		inside = '<failure message="failed">%s</failure>' % test.fail_texts[0].xml_escape()
	elif test.is_pending():
		inside = '<skipped message="pending">%s</skipped>' % test.pending_texts[0].xml_escape()
	return head + inside + "</testcase>"
