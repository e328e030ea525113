extends RefCounted
## Hands out the values of a test with parameters, one for each run.

## How many were handed out.
var count := 0

var _values: Array


func _init(values: Array) -> void:
	_values = values


func next_value() -> Variant:
	count += 1
	return _values[count - 1]


func is_done() -> bool:
	return count >= _values.size()
