extends LabTest
## Reads the table in docs/vec2.md and runs it: each expression for Vec2 must give the same as the
## expression for Godot's Vector2 beside it.

const DOCUMENT := "res://docs/vec2.md"
const SAMPLES := 20

## Vector2 has 24 bits; some expressions lose a few of them.
const TOLERANCE := 1e-5

const INPUT_NAMES: PackedStringArray = [
	"Vec2", "v", "w", "n", "p", "g", "L", "s", "r", "d", "C", "rng"
]


func test_the_bridge_table_is_there() -> void:
	assert_gt(_rows("## ", "| Course").size(), 40)
	assert_gt(_rows("## False friends", "| What Vec2").size(), 4)


func test_each_public_method_of_vec2_is_in_the_table() -> void:
	var table := _methods_named_in_table()
	for method: String in _public_methods():
		assert_has(table, method)


func test_each_method_in_the_table_exists() -> void:
	var existing := _public_methods()
	for method: String in _methods_named_in_table():
		assert_has(existing, method)


func test_vec2_and_vector2_give_the_same() -> void:
	for row: PackedStringArray in _rows("## ", "| Course"):
		_check_pair(row[1], row[2])


func test_false_friends_are_what_the_document_says() -> void:
	for row: PackedStringArray in _rows("## False friends", "| What Vec2"):
		_check_pair(row[0], row[1])


func _check_pair(vec2_code: String, vector2_code: String) -> void:
	var differences := PackedStringArray()
	for sample: int in SAMPLES:
		var inputs := _engine_inputs(sample)
		var got: Variant = _evaluate_with_vec2(vec2_code, inputs)
		var want: Variant = got if vector2_code == "-" else _evaluate(vector2_code, inputs)
		if not (_nearly_equal(got, want) or (vector2_code == "-" and got is Vec2)):
			differences.append("%s is %s, %s is %s" % [vec2_code, got, vector2_code, want])
	assert_eq("\n".join(differences), "", vec2_code)


func _nearly_equal(got: Variant, want: Variant) -> bool:
	if got is Vec2 and want is Vector2:
		var vector: Vec2 = got
		var engine_vector: Vector2 = want
		var allowed := TOLERANCE * maxf(1.0, engine_vector.length())
		return vec2_difference(vector, Vec2.from_vector2(engine_vector), allowed) == ""
	if got is Vector2 and want is Vector2:
		return got == want
	if got is float and want is float:
		var number: float = got
		var engine_number: float = want
		return absf(number - engine_number) <= TOLERANCE * maxf(1.0, absf(engine_number))
	return got is bool and want is bool and got == want


## A method that changes its vector returns nothing: then that vector is the result.
func _evaluate_with_vec2(code: String, engine_inputs: Array) -> Variant:
	var inputs := engine_inputs.duplicate()
	for index: int in ["v", "w", "n", "p"].size():
		var engine_vector: Vector2 = engine_inputs[index + 1]
		inputs[index + 1] = Vec2.from_vector2(engine_vector)
	# A unit vector of 32 bits is too far from length 1 for Vec2, as the document says.
	var unit: Vec2 = inputs[3]
	unit.normalize()
	var result: Variant = _evaluate(code, inputs)
	return inputs[1] if result == null else result


## The result of the code. If the code is wrong, a text that says why; it equals no result.
func _evaluate(code: String, inputs: Array) -> Variant:
	var expression := Expression.new()
	if expression.parse(code, INPUT_NAMES) != OK:
		return expression.get_error_text()
	var result: Variant = expression.execute(inputs, null, false)
	return expression.get_error_text() if expression.has_execute_failed() else result


func _engine_inputs(seed_number: int) -> Array:
	var rng := RandomNumberGenerator.new()
	rng.seed = seed_number
	var vectors: Array[Vector2] = []
	for vector: Vec2 in random_vectors(seed_number, 4, 10.0):
		vectors.append(vector.to_vector2())
	var unit := Vector2(1, 0).rotated(rng.randf_range(-PI, PI))
	var numbers: Array[float] = [
		rng.randf_range(1.0, 20.0),
		rng.randf_range(0.0, 1.0),
		rng.randf_range(-7.0, 7.0),
		rng.randf_range(-400.0, 400.0),
		rng.randf_range(0.0, 1.0),
	]
	return [Vec2, vectors[0], vectors[1], unit, vectors[2], vectors[3]] + numbers + [rng]


## The rows of the table with that head, below that heading: the code in each cell, or "-".
func _rows(heading: String, head: String) -> Array[PackedStringArray]:
	var text := FileAccess.get_file_as_string(DOCUMENT)
	var start := text.find(head, 0 if heading == "## " else text.find(heading))
	var rows: Array[PackedStringArray] = []
	for line: String in text.substr(start).strip_edges().get_slice("\n\n", 0).split("\n").slice(2):
		var cells := PackedStringArray()
		for cell: String in line.trim_prefix("|").split("|"):
			cells.append(cell.strip_edges().trim_prefix("`").trim_suffix("`"))
		rows.append(cells)
	return rows


func _methods_named_in_table() -> Array[String]:
	var pattern := RegEx.create_from_string("^(?:v|Vec2)\\.(\\w+)\\(")
	var methods: Array[String] = []
	for row: PackedStringArray in _rows("## ", "| Course"):
		var method := pattern.search(row[1]).get_string(1)
		if method != "new":
			methods.append(method)
	return methods


func _public_methods() -> Array[String]:
	var methods: Array[String] = []
	for method: Dictionary in (Vec2 as Script).get_script_method_list():
		var method_name: String = method["name"]
		if not method_name.begins_with("_"):
			methods.append(method_name)
	return methods
