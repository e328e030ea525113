extends ScreenTest
## The lines of GDScript beside a formula: in every lesson that has them, at each step and in each
## of its ready-made situations, they run without an error and give no NaN, and they are GDScript
## that can be copied.

# Source texts that have been compiled.
var _compiled: Dictionary[String, Error] = {}


func test_the_lines_run_and_can_be_compiled(id: StringName = use_parameters(_ids())) -> void:
	await open_lesson(LessonIndex.find(id))
	var code := frame().lesson.services[&"code"] as LessonCode
	code.folded = false
	var line_count := 0
	for situation in _situations():
		for step in _step_count():
			_go_to(step)
			_look_at(code, "%s, %s, step %d" % [id, situation, step + 1])
			line_count += code.lines.size()
		await _go_on_from(situation)
	assert_gt(line_count, 0, "%s shows lines" % id)
	code.folded = true


func test_a_line_that_is_no_gdscript_is_found() -> void:
	assert_eq(_compile(["var p := a.dot(a)"], {"a": Vec2.new(1.0, 2.0)}), OK)
	assert_ne(_compile(["a.no_such_method()"], {"a": Vec2.new(1.0, 2.0)}), OK)
	assert_engine_error("no_such_method")


func _ids() -> Array[StringName]:
	var ids: Array[StringName] = []
	for info in LessonIndex.lessons():
		if "code" in info.needs:
			ids.append(info.id)
	return ids


# The start, and each preset by its title.
func _situations() -> PackedStringArray:
	var found: PackedStringArray = ["the start"]
	for preset in _presets():
		found.append(preset.text)
	return found


func _presets() -> Array[Button]:
	var found: Array[Button] = []
	var options: LessonOptions = frame().lesson.services.get(&"options")
	if options:
		found.assign(options.get_node("%Presets").find_children("*", "Button", false, false))
	return found


# Presses the preset that comes after the one with this title.
func _go_on_from(situation: String) -> void:
	var next := _situations().find(situation)
	if next < _presets().size():
		_presets()[next].pressed.emit()
		await student.settle()


# At once, unlike a student.
func _go_to(step: int) -> void:
	var steps: Steps = frame().lesson.services.get(&"steps")
	if steps:
		steps.go_to(step)


func _step_count() -> int:
	var steps: Steps = frame().lesson.services.get(&"steps")
	if not steps:
		return 1
	steps.go_to(1000)
	return steps.step + 1


func _look_at(code: LessonCode, where: String) -> void:
	var text := (code.get_node("%Text") as Label).text
	assert_false(text.contains("NaN"), "%s: %s" % [where, text])
	assert_false(text.contains("<null>"), "%s: %s" % [where, text])
	if code.lines.size() > 0:
		assert_eq(_compile(code.lines, code.inputs), OK, "%s: %s" % [where, text])


# As the body of a function with the values as its parameters.
func _compile(lines: PackedStringArray, inputs: Dictionary[String, Variant]) -> Error:
	var declared: PackedStringArray = []
	var finder := RegEx.create_from_string("^\\s*var (\\w+)")
	for line in lines:
		var variable := finder.search(line)
		if variable:
			declared.append(variable.get_string(1))
	var parameters: PackedStringArray = []
	for key in inputs:
		var is_used := RegEx.create_from_string("\\b%s\\b" % key).search("\n".join(lines)) != null
		if is_used and not key in declared and not inputs[key] is GDScript:
			parameters.append("%s: %s" % [key, _type_of(inputs[key])])
	var source := "static func run(%s) -> Array:\n" % ", ".join(parameters)
	for i in lines.size():
		source += "\t%s\n" % lines[i]
		if (
			lines[i].ends_with(":")
			and not (i + 1 < lines.size() and lines[i + 1].begins_with("\t"))
		):
			source += "\t\tpass\n"
	source += "\treturn [%s]\n" % ", ".join(declared)
	if not _compiled.has(source):
		var script := GDScript.new()
		script.source_code = source
		_compiled[source] = script.reload()
	return _compiled[source]


static func _type_of(value: Variant) -> String:
	if value is Object:
		var object: Object = value
		var script: Script = object.get_script()
		return script.get_global_name()
	return type_string(typeof(value))
