extends LabTest
## How numbers are written for students.

const _SHORT: Array[Array] = [
	[0.0, "0"],
	[7.0, "7"],
	[0.8, "0.8"],
	[-3.25, "−3.25"],
	[0.1 + 0.2, "0.3"],
	[1.0 / 3.0, "0.3333"],
	[2.0 / 3.0, "0.6667"],
	[100.0, "100"],
	[12345.678, "12346"],
	[1e-4, "0.0001"],
	[1e-5, "1e−5"],
	[-1e-5, "−1e−5"],
	[9.9999e6, "9999900"],
	[1e7, "1e7"],
	[1.5e7, "1.5e7"],
	[-4e15, "−4e15"],
	[1e300, "1e300"],
	[-1e300, "−1e300"],
	[NAN, "NaN"],
	[INF, "∞"],
	[-INF, "−∞"],
]
const _ROUNDED_UP: Array[Array] = [
	[0.99999, "1"],
	[9.9999, "10"],
	[99.999, "100"],
	[0.00099999, "0.001"],
	[9.99999e-5, "1e−4"],
	[9.9999e-6, "1e−5"],
	[9.9996e9, "1e10"],
	[-9.9996e9, "−1e10"],
]


func test_numbers_are_short_and_bear_a_true_minus() -> void:
	for row: Array in _SHORT:
		var value: float = row[0]
		var text: String = row[1]
		assert_eq(NumberText.short(value), text)


func test_rounding_up_may_reach_the_next_power_of_ten() -> void:
	for row: Array in _ROUNDED_UP:
		var value: float = row[0]
		var text: String = row[1]
		assert_eq(NumberText.short(value), text)


func test_negative_zero_is_written_as_zero() -> void:
	assert_eq(NumberText.short(negative_zero()), "0")
	assert_eq(NumberText.typed(negative_zero()), "0")


func test_the_smallest_and_the_largest_number_are_written() -> void:
	assert_eq(NumberText.short(SMALLEST_SUBNORMAL), "4.941e−324")
	assert_eq(NumberText.short(-SMALLEST_SUBNORMAL), "−4.941e−324")
	assert_eq(NumberText.short(LARGEST_DOUBLE), "1.798e308")


func test_powers_of_ten_have_the_mantissa_one() -> void:
	for exponent: int in range(7, 308):
		assert_eq(NumberText.short(pow(10.0, exponent)), "1e%d" % exponent)
		assert_eq(NumberText.short(pow(10.0, -exponent)), "1e−%d" % exponent)


func test_the_number_of_digits_can_be_chosen() -> void:
	assert_eq(NumberText.short(1.0 / 3.0, 2), "0.33")
	assert_eq(NumberText.short(2.0 / 3.0 * 1e9, 6), "6.66667e8")


func test_a_pair_stands_in_parentheses() -> void:
	assert_eq(NumberText.pair(4.0, -3.0), "(4, −3)")


func test_a_size_has_two_digits_and_no_sign() -> void:
	assert_eq(NumberText.size(-8.8817841970012523e-16), "8.9e−16")
	assert_eq(NumberText.size(0.0), "0")
	assert_eq(NumberText.size(0.306), "0.31")


func test_only_a_negative_factor_stands_in_parentheses() -> void:
	assert_eq(NumberText.factor(-6.0), "(−6)")
	assert_eq(NumberText.factor(6.0), "6")
	assert_eq(NumberText.factor(negative_zero()), "0")


func test_what_is_written_into_a_field_is_taken_back_as_the_same_number() -> void:
	var exponents := RandomNumberGenerator.new()
	exponents.seed = 5
	for vector: Vec2 in random_vectors(4, 500, 10.0):
		var value := vector.x * pow(10.0, exponents.randi_range(-90, 90))
		var text := NumberText.typed(value)
		assert_eq(NumberText.problem(text), "")
		assert_almost_eq(NumberText.parse(text) / value, 1.0, 1e-11, text)
