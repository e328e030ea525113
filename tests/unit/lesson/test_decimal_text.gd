extends LabTest
## Doubles as short decimal texts, and back to the last bit.

const _COUNT := 20000
const _TEXTS: Dictionary[float, String] = {
	7.0: "7",
	-0.1: "-0.1",
	0.3: "0.3",
	-6.5: "-6.5",
	1e15: "1e15",
	1.5e-7: "1.5e-7",
	1e100: "1e100",
	1234567.0: "1234567",
}


func test_numbers_are_written_with_few_digits() -> void:
	for value: float in _TEXTS:
		assert_eq(DecimalText.of(value), _TEXTS[value])


func test_numbers_of_all_sizes_come_back_to_the_last_bit() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 1
	var first_lost := ""
	for i: int in _COUNT:
		var value := _random(rng)
		if not same_bits(DecimalText.value_of(DecimalText.of(value)), value):
			first_lost = DecimalText.of(value)
	assert_eq(first_lost, "")


func test_zero_keeps_its_sign() -> void:
	assert_eq(DecimalText.of(negative_zero()), "-0")
	assert_true(same_bits(DecimalText.value_of("-0"), negative_zero()))
	assert_true(same_bits(DecimalText.value_of("0"), 0.0))


func test_a_number_halfway_between_two_doubles_goes_to_the_even_one() -> void:
	assert_eq(DecimalText.value_of("9007199254740993"), 9007199254740992.0)
	assert_eq(DecimalText.value_of("9007199254740995"), 9007199254740996.0)


func test_people_may_write_a_number_in_their_own_way() -> void:
	for text: String in [
		"2.50", "02.5", "2.5e0", "25E-1", "0.25e+1", "2500e-3", "+2.5", "2,5", " 2.5\n"
	]:
		assert_eq(DecimalText.value_of(text), 2.5, text)
	for dash: String in "−–‐‑‒—﹣－":
		assert_eq(DecimalText.value_of(dash + "2.5e" + dash + "1"), -0.25, dash)
	assert_eq(DecimalText.value_of("\u00a02,5\u00a0"), 2.5)
	assert_eq(DecimalText.value_of(".5"), 0.5)
	assert_eq(DecimalText.value_of("5."), 5.0)


# The last digit decides in which half the number is, however far to the right it is.
func test_more_digits_than_a_double_has_are_rounded_once() -> void:
	assert_eq(DecimalText.value_of("9007199254740993.000000000000000"), 9007199254740992.0)
	assert_eq(DecimalText.value_of("9007199254740993.000000000000001"), 9007199254740994.0)
	assert_eq(DecimalText.value_of("12345678901234567890"), 12345678901234567890.0)
	assert_eq(DecimalText.value_of("0." + "0".repeat(99) + "1"), 1e-100)
	assert_eq(DecimalText.value_of("1" + "0".repeat(60) + "e-60"), 1.0)


func test_what_is_no_number_is_nan() -> void:
	for text: String in [
		"",
		"-",
		".",
		"-.",
		"e5",
		"1e",
		"1e5.5",
		"--3",
		"nan",
		"inf",
		"0x10",
		"1_000",
		"½",
		"٣",
		"+-3",
		"1,000.5",
		"1e1000",
		"1e99999999999",
	]:
		assert_true(is_nan(DecimalText.value_of(text)), text)


func test_what_is_out_of_range_is_nan() -> void:
	for text: String in ["1.0001e100", "-1e101", "1e400", "9.9e-101", "1e-400", "999999999e-999"]:
		assert_true(is_nan(DecimalText.value_of(text)), text)
	assert_eq(DecimalText.value_of("-1e100"), -1e100)
	assert_eq(DecimalText.value_of("1e-100"), 1e-100)


# Half of them everyday numbers with all 53 bits, half of any size within the range.
func _random(rng: RandomNumberGenerator) -> float:
	var bytes := PackedByteArray()
	bytes.resize(8)
	bytes.encode_u32(0, rng.randi())
	bytes.encode_u32(4, rng.randi())
	# The exponent last: the number stays finite and within 1e-100..1e100.
	var exponent := rng.randi_range(1023 - 332, 1023 + 331)
	if rng.randi() % 2 == 0:
		exponent = rng.randi_range(1023 - 20, 1023 + 20)
	bytes.encode_u16(6, exponent << 4 | rng.randi() % 16 | (rng.randi() % 2) << 15)
	return bytes.decode_double(0)
