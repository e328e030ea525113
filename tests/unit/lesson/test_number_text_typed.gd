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
	["1e-100", 1e-100],
	["00000000000000000001.5", 1.5],
	["0.0000000000000000271", 2.71e-17],
	["3.14159265358979323846264338327950288", PI],
	["–2.5", -2.5],
	["1e−3", 0.001],
	["1e0003", 1000.0],
	["−１２．５ｅ３", -12500.0],
	["2/5", 0.4],
	["-1 / 4", -0.25],
	["0/3", 0.0],
]
const _REFUSED: Array[String] = [
	"",
	" ",
	"abc",
	"-",
	"--3",
	"1/0",
	"2/",
	"/5",
	"1/2/3",
	"1e100/1e-100",
	"1e-100/1e100",
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
	"2.5e",
	"1e5.5",
	"1e4294967296",
	"1e18446744073709551616",
	"1e101",
	"9.9e-101",
	"1e-400",
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
		assert_eq(NumberText.parse(text), value, text)


func test_what_cannot_be_taken_is_named_with_what_is_allowed() -> void:
	for text: String in _REFUSED:
		var sentence := "“%s” cannot be taken: type 0 or a number from 1e-100 to 1e100 in size"
		assert_string_starts_with(NumberText.problem(text), sentence % text)


func test_only_the_beginning_of_a_long_text_is_named() -> void:
	assert_string_starts_with(NumberText.problem("x".repeat(5000)), "“%s…” " % "x".repeat(30))


func test_products_of_two_typed_numbers_are_finite() -> void:
	assert_true(is_finite(DecimalText.LARGEST * DecimalText.LARGEST * 2.0))
