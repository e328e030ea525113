extends LessonJudge
## Judges what the lesson on more dimensions says.

## The steps, counted from 0.
enum Step { COMPONENTS, PRODUCTS, SUM, SIGN, ANGLE, USES }

# What a sum of doubles may be off by, as a share of its terms.
const _ROUNDING := 1e-14
# The labels of axes and vectors, and of the shadow.
const _LETTERS: Array[String] = ["x", "y", "z", "a", "b", "p"]

# The table of the last step, which holds in every state: heading, use with its lessons, formula.
const _USES: PackedStringArray = [
	"use (lesson)",
	"formula",
	"length (3)",
	"|a| = √(a · a)",
	"angle (4)",
	"cos α = a · b / (|a| |b|)",
	"below, at or above 90° (4, 11)",
	"a · b > 0, = 0, < 0",
	"shadow, projection (4, 5)",
	"p = (a · b̂) b̂",
	"distance from a line (6)",
	"(c − p) · n̂",
	"side of a line (6)",
	"(c − p) · n̂ > 0",
	"moment of the touch (7)",
	"t = (distance − r) / (−v · n̂)",
	"bounce (8, 9)",
	"v − (1 + C) (v · n̂) n̂",
	"touch at the end of a line (10)",
	"v · v t² + 2 d · v t + d · d = r²",
]

var _step: int
var _count: int
var _dot: float
# What the dot product may be off by.
var _off: float
# The product of both lengths; 0 where a vector is zero.
var _lengths: float
var _degrees: float
# What the angle may be off by.
var _degrees_off: float


func problem(seen: SeenLesson) -> String:
	_step = seen.step
	_take(seen.state)
	return first_of(
		[
			false_claim([seen.sentence], _claims_of_sentences()),
			_problem_of_labels(seen.labels),
			_problem_of_rows(seen.rows),
			_problem_of_lines(seen.lines),
			"there is no reason for “%s”" % seen.notice if seen.notice else "",
		]
	)


func _take(state: Dictionary) -> void:
	var fifth: PackedFloat64Array = state["fifth"]
	var all_of_a: PackedFloat64Array = state["a"]
	var all_of_b: PackedFloat64Array = state["b"]
	_count = 5 if state["has_five"] else 4 if state["has_four"] else 3
	var a := (all_of_a + PackedFloat64Array([fifth[0]])).slice(0, _count)
	var b := (all_of_b + PackedFloat64Array([fifth[1]])).slice(0, _count)
	_dot = 0.0
	_off = 0.0
	for i in a.size():
		_dot += a[i] * b[i]
		_off += _ROUNDING * absf(a[i] * b[i])
	_lengths = _length(a) * _length(b)
	_degrees = rad_to_deg(atan2(_area(a, b), _dot))
	_degrees_off = 1e-12
	if _lengths > 0.0:
		_degrees_off += rad_to_deg(_off / _lengths)


static func _length(vector: PackedFloat64Array) -> float:
	var sum := 0.0
	for number in vector:
		sum += number * number
	return sqrt(sum)


# The area of the parallelogram of both, by its shadows on all pairs of axes.
static func _area(a: PackedFloat64Array, b: PackedFloat64Array) -> float:
	var sum := 0.0
	for i in a.size():
		for j in i:
			sum += (a[i] * b[j] - a[j] * b[i]) ** 2.0
	return sqrt(sum)


func _has_angle() -> bool:
	return _lengths > 0.0


func _claims_of_sentences() -> Dictionary[String, bool]:
	var has_sign := _step == Step.SIGN and _has_angle()
	return {
		"A vector is a list of numbers: two, three, four": _step == Step.COMPONENTS,
		"Multiply the first by the first": _step == Step.PRODUCTS,
		"Add the products: one number comes out": _step == Step.SUM,
		"Its sign tells whether the angle is below, at or above 90°": has_sign and _count > 3,
		"Above 90°, the shadow p of a points against b": has_sign and _count == 3,
		"A zero vector has no direction: there is no angle": not _has_angle() and _step < Step.USES,
		"What the dot product is for, and in which lesson each use is shown": _step == Step.USES,
		"divide by both lengths: that is its cosine": _step == Step.ANGLE and _has_angle(),
	}


# What is said of the sign and of the angle, on the card and in the formula. Where rounding alone
# decides, both are true.
func _claims_of_sign() -> Dictionary[String, bool]:
	return {
		"a · b > 0": _dot > -_off,
		"a · b = 0": absf(_dot) <= _off,
		"a · b < 0": _dot < _off,
		"the angle is below 90°": _has_angle() and _dot > -_off,
		"the angle is above 90°": _has_angle() and _dot < _off,
		"a right angle": _has_angle() and absf(_dot) <= _off,
		"a zero vector makes no angle": not _has_angle(),
	}


func _problem_of_labels(labels: PackedStringArray) -> String:
	for label in labels:
		# Nothing is seen of what keeps a line together.
		if in_degrees(label.replace("\u2060", "")) in _USES:
			if _step != Step.USES:
				return "the uses come last: “%s”" % label
			continue
		if label == "p" and (_step < Step.SIGN or not _has_angle()):
			return "there is no shadow “p” yet"
		if label in _LETTERS:
			continue
		var is_card := label.begins_with("a · b ")
		if is_card and _step < Step.SIGN:
			return "the sign is told too early: “%s”" % label
		var claims: Dictionary[String, bool] = {
			"Drag beside the arrows to turn the axes": _count == 3,
			"So many axes do not fit into a picture": _count > 3,
		}
		claims.merge(_claims_of_sign())
		var found := false_claim(label.split("\n"), claims)
		if found:
			return found
	return ""


func _problem_of_rows(rows: Array[PackedStringArray]) -> String:
	if rows and (_step != Step.ANGLE or not _has_angle()):
		return "there is no angle to measure: “%s”" % "  ".join(rows[0])
	for row in rows:
		var is_dot := row[0] == "a · b"
		if not is_dot and row[0] != "cos α":
			return "no value is known for “%s”" % row[0]
		var value := _dot if is_dot else _dot / _lengths
		var off := _off if is_dot else _off / _lengths + _ROUNDING
		if not SeenLesson.is_close(SeenLesson.first_number(row[1]), value, off):
			return "it is %s: “%s”" % [value, "  ".join(row)]
		if not SeenLesson.first_number(row[2]) <= off:
			return "the error is at most %s: “%s”" % [off, "  ".join(row)]
	return ""


# The reader of formulas judges the sums; here is what it passes over.
func _problem_of_lines(lines: PackedStringArray) -> String:
	for line in lines:
		if line.begins_with("α = "):
			var degrees := SeenLesson.degrees_behind("α = ", line)
			var is_close := SeenLesson.is_close_angle(degrees, _degrees, _degrees_off)
			if not is_close or not _has_angle():
				return "the angle is %s: “%s”" % [_degrees, line]
			# However near it is, only a right angle has 90°.
			if degrees == 90.0 and absf(_degrees - 90.0) > _degrees_off:
				return "it is no right angle: “%s”" % line
		elif line.contains(" 0: "):
			var found := false_claim(line.split(":  "), _claims_of_sign())
			if found:
				return found
		elif line.contains("cos α") and not _has_angle():
			return "there is no angle: “%s”" % line
	return ""
