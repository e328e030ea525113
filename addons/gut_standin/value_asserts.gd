extends "test_base.gd"
## Asserts about values.


func assert_eq(got: Variant, expected: Variant, text: Variant = "") -> void:
	_gut_compare(
		got, expected, "to equal", func(a: Variant, b: Variant) -> bool: return a == b, text
	)


func assert_ne(got: Variant, not_expected: Variant, text: Variant = "") -> void:
	_gut_compare(
		got, not_expected, "to not equal", func(a: Variant, b: Variant) -> bool: return a != b, text
	)


func assert_gt(got: Variant, expected: Variant, text: Variant = "") -> void:
	_gut_compare(got, expected, "to be >", func(a: Variant, b: Variant) -> bool: return a > b, text)


func assert_gte(got: Variant, expected: Variant, text: Variant = "") -> void:
	_gut_compare(
		got, expected, "to be >=", func(a: Variant, b: Variant) -> bool: return a >= b, text
	)


func assert_lt(got: Variant, expected: Variant, text: Variant = "") -> void:
	_gut_compare(got, expected, "to be <", func(a: Variant, b: Variant) -> bool: return a < b, text)


func assert_lte(got: Variant, expected: Variant, text: Variant = "") -> void:
	_gut_compare(
		got, expected, "to be <=", func(a: Variant, b: Variant) -> bool: return a <= b, text
	)


func assert_almost_eq(
	got: Variant, expected: Variant, error_interval: Variant, text: Variant = ""
) -> void:
	_gut_compare_nearly(got, expected, error_interval, true, text)


func assert_almost_ne(
	got: Variant, not_expected: Variant, error_interval: Variant, text: Variant = ""
) -> void:
	_gut_compare_nearly(got, not_expected, error_interval, false, text)


func assert_between(got: Variant, low: Variant, high: Variant, text: Variant = "") -> void:
	if _gut_have_comparable_types(got, low, text) and _gut_have_comparable_types(got, high, text):
		var said := "[%s] expected to be between [%s] and [%s]: %s"
		var inside: bool = low <= high and got >= low and got <= high
		_gut_check(inside, said % [_gut_text_of(got), _gut_text_of(low), _gut_text_of(high), text])


func assert_true(got: Variant, text: Variant = "") -> void:
	_gut_check(is_same(got, true), "%s expected to be true: %s" % [_gut_text_of(got), text])


func assert_false(got: Variant, text: Variant = "") -> void:
	_gut_check(is_same(got, false), "%s expected to be false: %s" % [_gut_text_of(got), text])


func assert_null(got: Variant, text: Variant = "") -> void:
	_gut_check(got == null, "[%s] expected to be null: %s" % [_gut_text_of(got), text])


func assert_not_null(got: Variant, text: Variant = "") -> void:
	_gut_check(got != null, "expected anything but null: %s" % text)


func assert_same(got: Variant, expected: Variant, text: Variant = "") -> void:
	var said := "[%s] expected to be the same as [%s]: %s"
	_gut_check(is_same(got, expected), said % [_gut_text_of(got), _gut_text_of(expected), text])


func assert_not_same(got: Variant, not_expected: Variant, text: Variant = "") -> void:
	var said := "[%s] expected to not be the same as [%s]: %s"
	_gut_check(
		not is_same(got, not_expected), said % [_gut_text_of(got), _gut_text_of(not_expected), text]
	)


func assert_has(collection: Variant, element: Variant, text: Variant = "") -> void:
	var said := "[%s] expected to contain [%s]: %s"
	_gut_check(
		element in collection, said % [_gut_text_of(collection), _gut_text_of(element), text]
	)


func assert_does_not_have(collection: Variant, element: Variant, text: Variant = "") -> void:
	var said := "[%s] expected to not contain [%s]: %s"
	_gut_check(
		element not in collection, said % [_gut_text_of(collection), _gut_text_of(element), text]
	)


# The two are arguments: a lambda could not hold an object that has been freed.
func _gut_compare(got: Variant, want: Variant, how: String, is_so: Callable, text: Variant) -> void:
	if _gut_have_comparable_types(got, want, text):
		var ok: bool = is_so.call(got, want)
		_gut_check(
			ok, "[%s] expected %s [%s]: %s" % [_gut_text_of(got), how, _gut_text_of(want), text]
		)


func _gut_compare_nearly(
	got: Variant, want: Variant, interval: Variant, wanted: bool, text: Variant
) -> void:
	if not _gut_have_comparable_types(got, want, text):
		return
	if not _gut_have_comparable_types(got, interval, text):
		return
	var near := _gut_is_near(got, want, interval)
	var how := "to equal" if wanted else "to not equal"
	var said := "[%s] expected %s [%s] +/- [%s]: %s"
	_gut_check(near == wanted, said % [_gut_text_of(got), how, _gut_text_of(want), interval, text])


func _gut_is_near(got: Variant, want: Variant, interval: Variant) -> bool:
	if got is Vector2:
		var point: Vector2 = got
		var least: Vector2 = want - interval
		var most: Vector2 = want + interval
		return point == point.clamp(least, most)
	return got >= want - interval and got <= want + interval
