extends RefCounted
## What the stand-in prints.

var _warnings := PackedStringArray()


func show(text: String) -> void:
	print(text if text.begins_with("*") else "    " + text)


func heading(text: String, tests: int) -> void:
	if tests > 0:
		print("\n" + text)


func warn(text: String) -> void:
	_warnings.append(text)
	show("[WARNING]:  " + text)


func get_warnings() -> Array:
	return Array(_warnings)


## The stand-in has no old names.
func get_deprecated() -> Array:
	return []
