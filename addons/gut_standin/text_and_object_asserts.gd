extends "value_asserts.gd"
## Asserts about texts, files and objects.


func assert_string_contains(text: Variant, part: Variant, match_case: Variant = true) -> void:
	_gut_look_for(
		text, part, match_case, "contain", func(t: String, p: String) -> bool: return p in t
	)


func assert_string_starts_with(text: Variant, part: Variant, match_case: Variant = true) -> void:
	var starts := func(t: String, p: String) -> bool: return t.begins_with(p)
	_gut_look_for(text, part, match_case, "start with", starts)


func assert_string_ends_with(text: Variant, part: Variant, match_case: Variant = true) -> void:
	var ends := func(t: String, p: String) -> bool: return t.ends_with(p)
	_gut_look_for(text, part, match_case, "end with", ends)


func assert_file_exists(path: Variant) -> void:
	_gut_check(FileAccess.file_exists(str(path)), "expected [%s] to exist" % path)


func assert_file_does_not_exist(path: Variant) -> void:
	_gut_check(not FileAccess.file_exists(str(path)), "expected [%s] to not exist" % path)


func assert_is(object: Variant, type: Variant, text: Variant = "") -> void:
	var ok := object is Object and is_instance_of(object, type)
	_gut_check(
		ok, "[%s] expected to be a [%s]: %s" % [_gut_text_of(object), _gut_text_of(type), text]
	)


func assert_has_method(object: Variant, method: Variant, text: Variant = "") -> void:
	var asked: Object = object
	_gut_check(
		asked.has_method(str(method)), "%s expected to have %s(): %s" % [asked, method, text]
	)


func assert_freed(object: Variant, title: Variant = "something") -> void:
	_gut_check(not is_instance_valid(object), "expected [%s] to be freed" % title)


func assert_not_freed(object: Variant, title: Variant = "something") -> void:
	_gut_check(is_instance_valid(object), "expected [%s] to not be freed" % title)


func assert_no_new_orphans(text: Variant = "") -> void:
	var orphans := gut.new_orphans()
	_gut_check(orphans.is_empty(), "expected no orphans, found %d: %s" % [orphans.size(), text])


func _gut_look_for(
	text: Variant, part: Variant, match_case: Variant, how: String, is_so: Callable
) -> void:
	var said := "'%s' expected to %s '%s'" % [text, how, part]
	if text is not String or part is not String or text == "" or part == "":
		fail_test(said)
	elif match_case:
		_gut_check(is_so.call(text, part), said)
	else:
		_gut_check(is_so.call(str(text).to_lower(), str(part).to_lower()), said)
