extends LabTest
## The reader of formulas finds lines that do not hold, and lets pass those that do.

const _HOLDS: Array[Array] = [
	["a = ( 7 , 1 )     b = ( 8 , −6 )"],
	["a · b = 7·8 + 1·(−6) = 50"],
	["|b| = √(8² + (−6)²) = 10"],
	["b̂ = b / |b| = (0.8, −0.6)", "b = ( 8 , −6 )"],
	["a = ( 7 , 1 )", "b̂ = (0.8, −0.6)", "p = 5 b̂ = (4, −3)", "(a − p) · b̂ = 0"],
	["a = (6.0001, 8)", "a · b = 6.0001·8 + 8·(−6) = 0.0008"],
	["x · y = 3·0.8 + 4·(−0.6) = 0 (rounding: 4.4e−16)"],
	["x · y = (−3.71e−11)·0.89147936 + (−7.3e−11)·(−0.4530613) = 0 (rounding: 4.1e−16)"],
	["x · y = 3·0.9486833 + 9·(−0.3162278) = 0"],
	["v = ( 20 , 48 )", "n = (0, −1)", "v − 2 (v · n) n = (20, −48)"],
	["v = ( 20 , 48 )", "n = (0, −1)   C = 0.5", "v − (1 + C)(v · n) n = (20, −24)"],
	["b = 2 (3)   a = 4", "c = ( 1 , 1 )", "2a = 8", "4 / 2a = 0.5"],
	["a = 2   b = 5   c = 3", "D = b² − 4ac = 1"],
	["a = 2   b = −5   D = 1", "t₁ = (−b − √D) / 2a = (5 − 1) / 4 = 1"],
	["β = atan2(−6, 8) = −36.87°", "cos β = 0.8"],
	["β = atan2(−6, 8) + 360° = 323.1°", "cos β = 0.8"],
	["β = atan2(−6, 8) = −0.6435", "cos β = 0.8"],
	["β = atan2(−6, 8) + 2π = 5.64", "cos β = 0.8"],
	["α = 0.1419   β = −0.6435", "φ = α − β = π/4", "cos φ = cos π/4 = 0.7071"],
	["cos π/2 = 0     sin π/2 = 1", "cos 90° = 0     sin 90° = 1"],
	["cos (−2π/3) = −0.5", "10·cos 13π/36 = 4.226"],
	["a′ = (5, −5)", "c = a′.x = 5"],
	["a′.x = 7·0.8 + 1·(−0.6) = 5", "= (7·8 + 1·(−6)) / 10 = 5"],
	["e₁ / e₂ = 0.3 / 0.1", "t₂ / t₁ = 20 / 5", "p = log( e₁ / e₂ ) / log( t₂ / t₁ ) = 0.7925"],
	["int(|n|) = 5  →  (0.6, 0.8)", "n = (3, 4.3)"],
	["a = ( 1 , 2 , 3 )", "b = ( 3 , 2 , 1 )", "a · b > 0", "a · b = 3 + 4 + 3 = 10"],
	["position = Vec2.new( 9 , −4 )", "old = position.copy()", "old (9, −4)"],
	["F = (4, 3)   A = (0, 0)   B = (8, 6)", "s = (F − A) · (B − A) / |B − A|² = 0.5"],
	["a · b = 1e15·2 + 3e15·(−1) = −1e15"],
	["t = 1 / 3 = 0.3333"],
	["t = 2000 / 3 = 666.7"],
	["|c| = ∞"],
	["A = (1, 2)   B = (1.0001, 2)   F = (3, 5)", "s = (F − A) · (B − A) / |B − A|² = 20000"],
]
## A line that does not hold, and a part of what is said of it.
const _DOES_NOT: Dictionary[String, String] = {
	"a · b = 6·8 + 8·(−6) = 0.0008": "0, not 0.0008",
	"x · y = 3·0.8 + 4·(−0.6) = 4.441e−16": "not 4.44",
	"c = 30 − 30 = 0.0006": "not 0.0006",
	"g = 2·(−5) + 10 = 2e−7": "not 2e-07",
	"x · y = 3·0.9487 + 9·(−0.3162) = 0": "not 0",
	"x · y = 6.000001·8 − 6·8 = 0": "not 0",
	"x · y = (−3.71e−11)·0.8915 + (−7.3e−11)·(−0.4531) = 0 (rounding: 4.1e−16)": "not 0",
	"x · y = 4.1e−16 − 0 = 0": "not 0",
	"n / |n| = (NaN, NaN)": "NaN",
	"b̂ = 0 / 0 = 0": "division by 0",
	"t = 2 / 3 = 0.66": "not 0.66",
	"p = 5 (0.8, −0.6) = (4, 3)": "not (4, 3)",
	"p = 5 (0.8, −0.6) = 4": "a number and a list",
	"5 > 6": "5 > 6",
	"p = (1, 2) (3, 4) = 11": "two lists side by side",
	"β = atan2(−6, 8) = 323.1°": "not",
	"β = atan2(−6, 8) + 2π = 5.65": "not 5.65",
	"β = atan2(1, 1) = π/3": "not",
	"cos π/3 = 0.866": "not 0.866",
	"somewhere else": "somewhere",
	"c = 5 + = 5": "cannot read",
	"c = (5 + 1 = 6": "cannot read",
	"5 4 = 20 ?": "cannot read",
}
## Lines of which the last does not fit the others.
const _DO_NOT_FIT: Array[Array] = [
	["old = (3, −10.25)   v = (0, 29)   t = 0.25", "POI = old + t v = (3, −4)"],
	["v = ( 28 , 4 )   n = (0.1, 0.995)", "v − 1.5 (v · n) n = (28, 3)"],
	["a = ( −5 , 2 )   b = ( 8 , −6 )   p = (−4.16, 3.12)", "(a − p) · b = 1.776e−15"],
	[
		"P = (−4, −2)   A = (−1, 1)   r = 5   t₁ = −0.076   v = (6, 8)",
		"(P + t₁ v − A) / r = (−0.7071, −0.7071)"
	],
	["value (9, −4)   old_value (2, −3)", "old_value = value"],
	["a = ( 1 , 2 )   b = ( −3 , 1 )", "a · b > 0"],
	["a = 3", "a = 4"],
	["b = ( 3 , 4 )", "by = 3 + 0 = 3"],
]


func test_what_holds_passes() -> void:
	for lines: Array in _HOLDS:
		assert_eq(
			_problems(PackedStringArray(lines)),
			PackedStringArray(),
			" / ".join(PackedStringArray(lines))
		)


func test_what_does_not_hold_is_told_with_its_line() -> void:
	for line: String in _DOES_NOT:
		var problems := _problems([line])
		assert_gt(problems.size(), 0, line)
		if problems:
			assert_string_contains(problems[0], line)
			assert_string_contains(problems[0], _DOES_NOT[line])


func test_what_does_not_fit_the_other_lines_is_told() -> void:
	for lines: Array in _DO_NOT_FIT:
		var problems := _problems(PackedStringArray(lines))
		assert_eq(problems.size(), 1, " / ".join(PackedStringArray(lines)))
		if problems:
			assert_string_contains(problems[0], str(lines[1]))


func test_words_are_passed_over_only_where_they_are_listed() -> void:
	var line := "to the segment: |(0, 0) − (3, 4)| = 5     gap = 5 − 2 = 3 hit"
	assert_gt(_problems([line]).size(), 0)
	assert_eq(_problems([line], {words = ["to the segment:", "gap", "hit"]}), PackedStringArray())
	assert_gt(_problems(["gap = 5 − 2 = 4"], {words = ["gap"]}).size(), 0, "the rest is read")


func test_a_symbol_that_is_not_shown_is_told_unless_it_is_listed() -> void:
	assert_gt(_problems(["3 = 1 + 2 = q + 1 = 3"]).size(), 0)
	assert_eq(_problems(["3 = 1 + 2 = q + 1 = 3"], {not_shown = ["q"]}), PackedStringArray())
	assert_eq(_problems(["q = 2", "3 = 1 + 2 = q + 1 = 3"]), PackedStringArray())


func test_numbers_with_many_digits_are_read_to_their_last_bit() -> void:
	var sum := "0.0076360000000000317·(−0.20826928961290536)"
	sum += " + (−0.0016259999999999053)·(−0.97807152243797368)"
	assert_eq(_problems(["x · n = %s = −9.931e−17" % sum]), PackedStringArray())


func test_a_symbol_can_stand_for_another() -> void:
	var lines: PackedStringArray = ["v = ( 3 , 4 )", "n = (−y, x) = (−4, 3)"]
	var meanings := {x = "v.x", y = "v.y"}
	assert_eq(_problems(lines, {meanings = meanings}), PackedStringArray())
	lines[1] = "n = (−y, x) = (4, 3)"
	assert_eq(_problems(lines, {meanings = meanings}).size(), 1)


func _problems(lines: PackedStringArray, words: Dictionary = {}) -> PackedStringArray:
	return FormulaReader.new(FormulaWords.of(words)).problems(lines)
