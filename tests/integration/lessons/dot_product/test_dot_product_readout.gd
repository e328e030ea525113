extends DotProductTest
## The dot product beside the primitive way: values, errors and run times as the readout has them.

const _DOT := "a · b\u0302 by the dot product"
const _PRIMITIVE := "by atan2 and cos"


func before_each() -> void:
	await super()
	await go_to_step()


func test_the_dot_product_is_exact_for_the_lecture() -> void:
	assert_eq(_row(_DOT)[1], "5")
	assert_eq(_row(_DOT)[2], "0")


func test_the_primitive_way_is_off_in_the_last_digits_for_the_lecture() -> void:
	assert_eq(_row(_PRIMITIVE)[1], "5")
	assert_ne(_row(_PRIMITIVE)[2], "0")


# cos(pi / 2) in doubles is 6.123e-17 instead of 0; times |a| = 5e15 that is 0.306.
func test_the_primitive_way_sees_a_shadow_where_there_is_none_for_huge_vectors() -> void:
	await click_button("Huge")
	assert_eq(_row(_DOT)[1], "0")
	assert_eq(_row(_DOT)[2], "0")
	assert_eq(_row(_PRIMITIVE)[1], "0.3062")
	assert_eq(_row(_PRIMITIVE)[2], "0.31")


func test_the_error_of_the_forgotten_normalization_is_45() -> void:
	await click_button("Normalize")
	assert_eq(_row("a · b by the dot product")[1], "50")
	assert_eq(_row("a · b by the dot product")[2], "45")


func test_both_ways_give_zero_for_a_zero_a() -> void:
	await student.enter(field("x of a"), "0")
	await student.enter(field("y of a"), "0")
	assert_eq(_row(_DOT)[1], "0")
	assert_eq(_row(_PRIMITIVE)[1], "0")


func test_nothing_is_compared_where_b_has_no_direction() -> void:
	assert_reads(_PRIMITIVE)
	await click_button("Zero")
	assert_does_not_read(_PRIMITIVE)


func test_both_run_times_are_given_in_nanoseconds() -> void:
	for way: String in [_DOT, _PRIMITIVE]:
		var time := _row(way)[3]
		assert_string_ends_with(time, " ns")
		assert_true(time.trim_suffix(" ns").is_valid_float(), time)


# Title, value, error and run time of a row.
func _row(title: String) -> PackedStringArray:
	var texts := Screen.texts(frame().lesson.services[&"readout"])
	var start := texts.find(title)
	return texts.slice(start, start + 4)
