extends SceneTree
## Run time of every public method of Vec2, beside Godot's Vector2 and beside the bare arithmetic.
##
## Run with: godot --headless --path . -s benchmarks/vec2.gd
## [br][br]
## Each statement is compiled into a loop of its own; the time of an empty loop is subtracted. The
## runs of all statements take turns, so that a slow moment of the machine hits all alike, and the
## median counts.

const RUNS := 9
const CALLS_PER_RUN := 10000

## Below this a median is mostly noise, and no ratio is formed with it.
const SHORTEST_NANOSECONDS := 2.0

const Statements := preload("vec2_statements.gd")

var _rng := RandomNumberGenerator.new()
var _loops: Dictionary[String, GDScript] = {}


func _init() -> void:
	_compile("pass")
	for method: String in Statements.STATEMENTS:
		for statement: String in Statements.STATEMENTS[method]:
			if statement != "":
				_compile(statement)
	var problems := _methods_without_statements() + _statements_that_do_not_compile()
	if problems.is_empty():
		_print_table(_medians())
	else:
		push_error("benchmarks/vec2_statements.gd: %s." % ", ".join(problems))
	quit(0 if problems.is_empty() else 1)


func _compile(statement: String) -> void:
	_loops[statement] = GDScript.new()
	_loops[statement].source_code = Statements.LOOP % statement
	_loops[statement].reload()


func _methods_without_statements() -> PackedStringArray:
	var problems := PackedStringArray()
	for method: Dictionary in (Vec2 as Script).get_script_method_list():
		var method_name: String = method["name"]
		if not method_name.begins_with("_") and not Statements.STATEMENTS.has(method_name):
			problems.append("%s is missing" % method_name)
	return problems


func _statements_that_do_not_compile() -> PackedStringArray:
	var problems := PackedStringArray()
	for statement: String in _loops:
		if not _loops[statement].can_instantiate():
			problems.append('"%s" does not compile' % statement)
	return problems


## Nanoseconds a call for each statement.
func _medians() -> Dictionary[String, float]:
	var times: Dictionary[String, PackedFloat64Array] = {}
	for _run: int in RUNS:
		for statement: String in _loops:
			var microseconds: int = _loops[statement].call("run", CALLS_PER_RUN, _rng)
			var so_far: PackedFloat64Array = times.get(statement, PackedFloat64Array())
			so_far.append(1000.0 * microseconds / CALLS_PER_RUN)
			times[statement] = so_far
	var medians: Dictionary[String, float] = {}
	for statement: String in times:
		medians[statement] = _median(times[statement]) - _median(times["pass"])
	return medians


func _median(values: PackedFloat64Array) -> float:
	var sorted := values.duplicate()
	sorted.sort()
	return sorted[floori(sorted.size() / 2.0)]


func _print_table(medians: Dictionary[String, float]) -> void:
	print("Nanoseconds a call, median of %d runs of %d calls.\n" % [RUNS, CALLS_PER_RUN])
	print("| Method | Vec2 | Vector2 | Inlined | Vec2 / Vector2 | Vec2 / inlined |")
	print("| --- | ---: | ---: | ---: | ---: | ---: |")
	for method: String in Statements.STATEMENTS:
		var cells := PackedStringArray(["`%s`" % method])
		var times: Array[float] = []
		for statement: String in Statements.STATEMENTS[method]:
			times.append(medians.get(statement, NAN))
			cells.append(_rounded(times[-1], 0))
		cells.append(_ratio(times[0], times[1]))
		cells.append(_ratio(times[0], times[2]))
		print("| %s |" % " | ".join(cells))


func _ratio(time: float, other: float) -> String:
	return _rounded(time / other if other >= SHORTEST_NANOSECONDS else NAN, 1)


func _rounded(value: float, digits: int) -> String:
	return "-" if is_nan(value) else String.num(value, digits)
