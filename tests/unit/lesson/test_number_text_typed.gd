extends LabTest
## Typed text as a number: what is taken, and what is refused with one clear sentence.

const _TAKEN: Array[Array] = [
	["7", 7.0],
	[" 7 ", 7.0],
	["-2.5", -2.5],
	["+3", 3.0],
	["−3", -3.0],
	["1,5", 1.5],
	[".5", 0.5],
	["5.", 5.0],
	["3e8", 3e8],
	["1E3", 1000.0],
	["1e+3", 1000.0],
	["2e-3", 0.002],
	["1e100", 1e100],
	["-1e100", -1e100],
	["1e-400", 0.0],
]
const _REFUSED: Array[String] = [
	"",
	" ",
	"abc",
	"-",
	"--3",
	"1.2.3",
	"1 000",
	"1,000,000",
	"1_000",
	"0x10",
	"0b11",
	"nan",
	"NaN",
	"inf",
	"-inf",
	"∞",
	"e5",
	"1e5.5",
	"1e400",
	"-1e400",
	"½",
	"٣"
]


func test_numbers_are_taken_as_people_type_them() -> void:
	for row: Array in _TAKEN:
		var text: String = row[0]
		var value: float = row[1]
		assert_eq(NumberText.problem(text), "", text)
		assert_almost_eq(NumberText.parse(text), value, absf(value) * 1e-15, text)


func test_what_is_no_number_is_named_with_what_is_allowed() -> void:
	for text: String in _REFUSED:
		var sentence := "“%s” is not a number: type one like 7, -2.5 or 3e8." % text
		assert_eq(NumberText.problem(text), sentence)


func test_a_number_beyond_the_range_is_named_with_the_range() -> void:
	for text: String in ["1.0001e100", "-2e100", "1e300"]:
		var sentence := "%s is too large: numbers go from -1e100 to 1e100." % text
		assert_eq(NumberText.problem(text), sentence)


func test_the_product_of_two_numbers_that_are_taken_is_finite() -> void:
	assert_true(is_finite(NumberText.LARGEST * NumberText.LARGEST * 2.0))
