extends RefCounted
## Base of the scripts that run before the first and after the last test.

## The runner; untyped as in GUT.
var gut: Variant = null

var _exit_code := -1


func run() -> void:
	pass


func set_exit_code(code: int) -> void:
	_exit_code = code


## -1 as long as none was set.
func get_exit_code() -> int:
	return _exit_code
