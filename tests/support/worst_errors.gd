class_name WorstErrors
extends RefCounted
## The largest error of each family of reference rows, to be asserted and printed.

var _worst: Dictionary[String, float] = {}


## Notes one error; NaN counts as infinite.
func note(family: String, error: float) -> void:
	var before: float = _worst.get(family, 0.0)
	_worst[family] = maxf(before, INF if is_nan(error) else error)


## The largest error of each family.
func values() -> PackedFloat64Array:
	return PackedFloat64Array(_worst.values())


## The largest error of all families.
func largest() -> float:
	var most := 0.0
	for error in values():
		most = maxf(most, error)
	return most


## One line: each family with its largest error.
func _to_string() -> String:
	var parts: PackedStringArray = []
	for family: String in _worst:
		parts.append("%s %s" % [family, String.num(_worst[family], 3)])
	return ", ".join(parts)
