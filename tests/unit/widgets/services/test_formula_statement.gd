extends LabTest
## How many digits the numbers of a statement have, and what is said of rounding.

var _numbers: Dictionary[String, FormulaStatement.Number] = {}


func before_each() -> void:
	_numbers.clear()


func test_a_sum_has_four_digits_where_these_suffice() -> void:
	var statement := FormulaStatement.new("{u} · {w} = {ux}·{wx} + {uy}·{wy} = {dot}")
	_put({ux = 7.0, wx = 8.0, uy = 1.0, wy = -6.0, dot = 50.0})
	_assert_texts(statement, ["", "", "7", "8", "1", "(−6)", "50"])


func test_numbers_have_more_digits_where_the_result_needs_them() -> void:
	var statement := FormulaStatement.new("u · w = {ux}·{wx} + {uy}·{wy} = {dot}")
	_put({ux = 6.0001, wx = 8.0, uy = 8.0, wy = -6.0, dot = 6.0001 * 8.0 - 48.0})
	_assert_texts(statement, ["6.0001", "8", "8", "(−6)", "0.0008"])


func test_a_result_that_is_rounding_is_said_to_be_so() -> void:
	var statement := FormulaStatement.new("{x} = {ux}·{wx} + {uy}·{wy} = {dot}")
	_put({ux = 3.0, wx = 0.8, uy = 4.0, wy = -0.6, dot = 4.44e-16})
	_assert_texts(statement, ["", "3", "0.8", "4", "(−0.6)", "0 (rounding: 4.4e−16)"])


# With 4 digits the sum would be four times what is called rounding.
func test_a_sum_as_it_is_shown_gives_no_more_than_what_is_called_rounding() -> void:
	var statement := FormulaStatement.new("{x} = {ux}·{wx} + {uy}·{wy} = {dot}")
	var rest := -3.71e-11 * 0.8914793645 + 7.3e-11 * 0.4530613012
	_put({ux = -3.71e-11, wx = 0.8914793645, uy = -7.3e-11, wy = -0.4530613012, dot = rest})
	_numbers["dot"].scales = [100.0]
	var texts := statement.texts(_numbers)
	assert_eq(texts[5], "0 (rounding: 4.1e−16)")
	assert_eq(texts[2], "0.89147936")
	assert_eq(texts[4], "(−0.4530613)")


# With four digits it would be 0 / 0.
func test_no_difference_that_is_divided_by_is_shown_as_0() -> void:
	var statement := FormulaStatement.new("(|{old}| − {r}) / (|{old}| − |{new}|) = {wrong}")
	_put({old = 10.0, r = 10.0, new = 10.0000000002, wrong = 0.0})
	_assert_texts(statement, ["10", "10", "10", "10.0000000002", "0"])


# With 4e15 and 3e15 the sum would be 0.
func test_a_result_of_which_one_digit_holds_has_all_digits_of_its_terms() -> void:
	var statement := FormulaStatement.new("a · b = {ux}·{wx} + {uy}·{wy} = {dot}")
	var u := Vec2.new(4e15 - 11.415866248783008, 3e15 + 2.0)
	var w := Vec2.new(6e15 + 5991.28, -8e15 - 7998.04)
	_put({ux = u.x, wx = w.x, uy = u.y, wy = w.y, dot = u.dot(w)})
	var texts := statement.texts(_numbers)
	assert_ne(texts[0], "4e15")


# A whole number shows all of its digits, and an angle has too few for them.
func test_a_large_whole_number_that_no_digits_give_is_shown_with_all_there_are() -> void:
	var statement := FormulaStatement.new("|a| cos φ = {length}·cos {phi}° = {primitive}")
	_put({length = 5e15, phi = -90.00000006554639, primitive = -5720002.0})
	_assert_texts(statement, ["5e15", "(−90.000000065546388)", "−5720002"])


func test_a_negative_angle_alone_behind_cos_stands_in_parentheses() -> void:
	var statement := FormulaStatement.new("cos φ = cos {phi}° = {cosine}")
	_put({phi = -60.0, cosine = 0.5})
	_assert_texts(statement, ["(−60)", "0.5"])


func test_a_small_result_of_exact_numbers_is_not_rounding() -> void:
	var statement := FormulaStatement.new("{a} − {b} = {c}")
	_put({a = 1e-9, b = 3e-9, c = -2e-9})
	_assert_texts(statement, ["1e−9", "3e−9", "−2e−9"])


func test_components_of_a_pair_are_computed_apart() -> void:
	var statement := FormulaStatement.new("n = ( −({ly}), {lx} ) / {length} = {n}")
	var length := Vec2.new(3.0, 4.00001).length()
	_put({ly = 4.00001, lx = 3.0, length = length})
	_numbers["n"] = _number([-4.00001 / length, 3.0 / length])
	_assert_texts(statement, ["4", "3", "5", "(−0.8, 0.6)"])


func test_a_product_of_a_number_and_a_pair_is_computed() -> void:
	var statement := FormulaStatement.new("{v} − {k} · {part} {n} = {w}")
	_put({k = 1.5, part = 1.6, n = 0.0, w = 0.0})
	_numbers["v"] = _number([28.0, 4.0])
	_numbers["n"] = _number([0.0, 1.0])
	_numbers["w"] = _number([28.0, 1.6])
	_assert_texts(statement, ["(28, 4)", "1.5", "1.6", "(0, 1)", "(28, 1.6)"])


func test_lengths_roots_and_squares_are_computed() -> void:
	var statement := FormulaStatement.new("|w| = √({x}² + {y}²) = {length}")
	_put({x = 1000.4, y = 1e-3, length = sqrt(1000.4 ** 2 + 1e-6)})
	_assert_texts(statement, ["1000", "0.001", "1000"])
	var difference := FormulaStatement.new("|{x}| − {y} = {z}")
	_put({x = -1000.4, y = 1000.0, z = 0.4})
	_assert_texts(difference, ["(−1000.4)", "1000", "0.4"])


func test_a_sum_that_is_not_shown_in_numbers_can_be_rounding_too() -> void:
	var statement := FormulaStatement.new("(a − p) · b = {check}")
	_put({check = 1.8e-15})
	_assert_texts(statement, ["1.8e−15"])
	_numbers["check"].scales = [50.0]
	_assert_texts(statement, ["0 (rounding: 1.8e−15)"])


func test_an_angle_is_computed_in_degrees() -> void:
	var statement := FormulaStatement.new("β = atan2({y}, {x}) = {beta}°")
	_put({y = -16.87443648746824, x = 200.0, beta = rad_to_deg(atan2(-16.87443648746824, 200.0))})
	_assert_texts(statement, ["−16.874", "200", "−4.823"])


func test_an_angle_is_computed_in_radians_where_the_line_has_no_degrees() -> void:
	var statement := FormulaStatement.new("β = atan2({y}, {x}) = {beta}")
	_put({y = -16.87443648746824, x = 200.0, beta = atan2(-16.87443648746824, 200.0)})
	_assert_texts(statement, ["−16.874", "200", "−0.08417"])


func test_a_full_turn_is_added_in_either_unit() -> void:
	_put({y = -16.87443648746824, x = 200.0})
	var angle := rad_to_deg(atan2(-16.87443648746824, 200.0)) + 360.0
	_put({beta = angle})
	var in_degrees := FormulaStatement.new("β = atan2({y}, {x}) + 360° = {beta}°")
	_assert_texts(in_degrees, ["−16.87", "200", "355.2"])
	_put({beta = deg_to_rad(angle)})
	var in_radians := FormulaStatement.new("β = atan2({y}, {x}) + 2π = {beta}")
	_assert_texts(in_radians, ["−16.87", "200", "6.199"])


func test_digits_of_a_cosine_are_found_in_radians() -> void:
	var statement := FormulaStatement.new("|a| cos φ = {length}·cos {phi} = {primitive}")
	_put({length = 10.0, phi = 1.5707, primitive = 10.0 * cos(1.5707)})
	_assert_texts(statement, ["10", "1.5707", "0.0009633"])


func test_an_exact_angle_is_written_and_computed_as_it_is() -> void:
	var statement := FormulaStatement.new("|a| cos φ = {length}·cos {phi} = {primitive}")
	_put({length = 1000.0, phi = -PI / 3.0, primitive = 500.0})
	_numbers["phi"].written = "−π/3"
	_assert_texts(statement, ["1000", "(−π/3)", "500"])
	var result := FormulaStatement.new("φ = {one} + {other} = {phi}")
	_put({one = -1.0, other = 1.0 - PI / 3.0})
	_assert_texts(result, ["(−1)", "(−0.0472)", "−π/3"])


func test_a_component_that_is_alone_needs_no_parentheses() -> void:
	var statement := FormulaStatement.new("{n} = (−{ly}, {lx}) / {length} = {pair}")
	_put({ly = -300.0, lx = -400.0, length = 500.0})
	_numbers["pair"] = _number([0.6, -0.8])
	_assert_texts(statement, ["", "(−300)", "−400", "500", "(0.6, −0.8)"])


func test_what_is_before_a_colon_are_words() -> void:
	var statement := FormulaStatement.new("{wrong}: ({new} − {r}) / {b} = {t}")
	_put({new = -149.63, r = 0.001, b = 377.6, t = -149.631 / 377.6})
	_assert_texts(statement, ["", "(−149.63)", "0.001", "377.6", "−0.3963"])


func test_a_side_with_words_is_not_computed() -> void:
	var statement := FormulaStatement.new("{easy} floor − y = {at} − {y} = {distance} {hit}")
	_put({at = 200.0, y = 190.5, distance = 9.5})
	_assert_texts(statement, ["", "200", "190.5", "9.5", ""])


func test_a_typed_number_counts_as_it_was_typed() -> void:
	var statement := FormulaStatement.new("{typed} − {y} = {z}")
	_put({typed = 1.0000001, y = 1.0, z = 1.0000001 - 1.0})
	_numbers["typed"].is_typed = true
	assert_eq(statement.texts(_numbers)[2], "1e−7")


func test_a_long_number_in_a_field_is_shortened() -> void:
	var statement := FormulaStatement.new("a = ( {x} , {y} )")
	_put({x = 5.0 * sqrt(2.0), y = -0.0001234})
	_numbers["x"].is_typed = true
	_numbers["y"].is_typed = true
	_assert_texts(statement, ["7.071", "−0.0001234"])


func _put(values: Dictionary) -> void:
	for key: String in values:
		var value: float = values[key]
		_numbers[key] = _number([value])


func _number(components: PackedFloat64Array) -> FormulaStatement.Number:
	var number := FormulaStatement.Number.new()
	number.components = components
	number.scales.resize(components.size())
	return number


func _assert_texts(statement: FormulaStatement, wanted: PackedStringArray) -> void:
	assert_eq(statement.texts(_numbers), wanted)
