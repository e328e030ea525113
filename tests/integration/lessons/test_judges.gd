extends LabTest
## The judges of what lessons say find what is false, and let pass what is true.

## Each judge has cases beside it. A case holds a lesson's id and a state, and for members of
## [SeenLesson] what is seen there: first what is true, then what is false.
const _CASES := "res://tests/integration/lessons/%s/%s_judge_cases.gd"


func test_what_is_true_passes_and_what_is_false_is_told() -> void:
	for case: Dictionary in _cases():
		for member: String in case:
			if member in ["id", "state"]:
				continue
			var choices: Array = case[member]
			assert_eq(_problem(case, {}), "", "%s is true" % case["id"])
			for wrong: Variant in choices.slice(1):
				assert_ne(_problem(case, {member: wrong}), "", "%s: %s" % [case["id"], wrong])


func test_a_lesson_without_a_judge_has_no_problem() -> void:
	assert_eq(LessonJudge.of(&"no_such_lesson").problem(SeenLesson.new()), "")


func test_every_judge_has_a_case() -> void:
	var ids: Array[StringName] = []
	for case: Dictionary in _cases():
		ids.append(case["id"])
	for info in LessonIndex.lessons():
		assert_has(ids, info.id)


func _cases() -> Array[Dictionary]:
	var found: Array[Dictionary] = []
	for info in LessonIndex.lessons():
		var cases := load(_CASES % [info.id, info.id]) as GDScript
		var of_lesson: Array[Dictionary] = cases.get_script_constant_map()["CASES"]
		found.append_array(of_lesson)
	return found


# With the true choice of each member, but for those in [param wrong].
func _problem(case: Dictionary, wrong: Dictionary) -> String:
	var seen := SeenLesson.new()
	seen.state = _state(case)
	for member: String in case:
		if not member in ["id", "state"]:
			var choices: Array = case[member]
			_put(seen, member, wrong.get(member, choices[0]))
	var id: StringName = case["id"]
	return LessonJudge.of(id).problem(seen)


func _state(case: Dictionary) -> Dictionary:
	var found := {a_from = PackedFloat64Array([0, 0]), b_from = PackedFloat64Array([0, 0])}
	var numbers: Dictionary = case["state"]
	for name_of_value: String in numbers:
		var value: Variant = numbers[name_of_value]
		found[name_of_value] = _as_in_a_link(value)
	return found


# Numbers in a list; lists of numbers in a list.
func _as_in_a_link(value: Variant) -> Variant:
	if not value is Array:
		return value
	var parts: Array = value
	if not parts[0] is Array:
		return type_convert(parts, TYPE_PACKED_FLOAT64_ARRAY)
	var lists: Array[PackedFloat64Array] = []
	for part: Array in parts:
		lists.append(PackedFloat64Array(part))
	return lists


func _put(seen: SeenLesson, member: String, texts: Variant) -> void:
	if member == "rows":
		var rows: Array = texts
		for row: Array in rows:
			seen.rows.append(PackedStringArray(row))
	else:
		seen.set(member, type_convert(texts, typeof(seen.get(member))))
