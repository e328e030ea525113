extends RefCounted
## A test script, or a class `Test...` inside of one, with its tests.

const CollectedTest := preload("collected_test.gd")

var path := ""
var inner_class := ""
var source: GDScript
var tests: Array[CollectedTest] = []
## Asserts of before_all and after_all.
var setup_teardown_tests: Array[CollectedTest] = []
var was_run := false
var was_skipped := false


static func from(at_path: String, of_script: GDScript, class_inside := "") -> RefCounted:
	var collected := new()
	collected.path = at_path
	collected.source = of_script
	collected.inner_class = class_inside
	for method: Dictionary in of_script.get_script_method_list():
		var method_name: String = method["name"]
		if method_name.begins_with("test_"):
			var test := CollectedTest.new()
			test.name = method_name
			var parameters: Array = method["args"]
			test.takes_parameters = not parameters.is_empty()
			collected.tests.append(test)
	return collected


func full_name() -> String:
	return path if inner_class.is_empty() else "%s.%s" % [path, inner_class]


func file_and_inner_class() -> String:
	return full_name().get_file()


func assert_count() -> int:
	var count := 0
	for test: CollectedTest in tests + setup_teardown_tests:
		count += test.assert_count()
	return count
