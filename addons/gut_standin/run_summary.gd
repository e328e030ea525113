extends RefCounted
## The end of the output: what failed, and how much was run.

const CollectedScript := preload("collected_script.gd")
const CollectedTest := preload("collected_test.gd")


## Prints the summary and returns how many tests failed.
static func show(scripts: Array[CollectedScript]) -> int:
	var counts := {"Scripts": 0, "Tests": 0, "Passing Tests": 0, "Failing Tests": 0, "Asserts": 0}
	print("\n= Run Summary")
	for script: CollectedScript in scripts:
		counts["Scripts"] += int(script.was_run)
		counts["Asserts"] += script.assert_count()
		for test: CollectedTest in script.tests:
			counts["Tests"] += int(test.was_run)
			counts["Passing Tests"] += int(test.is_passing())
			counts["Failing Tests"] += int(test.is_failing())
			for text: String in test.fail_texts:
				print("- %s %s: %s" % [script.full_name(), test.name, text])
	print("")
	for name: String in counts:
		print(name.rpad(18) + str(counts[name]).lpad(5))
	return counts["Failing Tests"]
