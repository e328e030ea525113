extends LabTest
## A Vec2 handed to itself, and vectors that share nothing with those they were made from.

const ANGLE := 0.7


func test_a_vector_added_to_itself_doubles() -> void:
	var vector := Vec2.new(3, 4)
	vector.add(vector)
	assert_vec2(vector, Vec2.new(6, 8), 0.0)


func test_a_vector_subtracted_from_itself_is_zero() -> void:
	var vector := Vec2.new(3, 4)
	vector.subtract(vector)
	assert_vec2(vector, Vec2.zero(), 0.0)


func test_a_unit_vector_reflected_by_itself_turns_round() -> void:
	var vector := Vec2.new(0.6, 0.8)
	vector.reflect(vector)
	assert_vec2(vector, Vec2.new(-0.6, -0.8), 2.0 * EPSILON)


func test_a_position_rotated_around_itself_stays() -> void:
	var position := Vec2.new(3, 4)
	position.rotate_around_degrees(position, 90)
	assert_vec2(position, Vec2.new(3, 4), 0.0)
	position.rotate_around_radians(position, ANGLE)
	assert_vec2(position, Vec2.new(3, 4), 0.0)


func test_a_vector_measured_against_itself() -> void:
	var vector := Vec2.new(3, 4)
	assert_eq(vector.distance_to(vector), 0.0)
	assert_eq(vector.scalar_projection(vector), 5.0)
	assert_eq(vector.angle_to(vector), 0.0)
	assert_vec2(vector.vector_projection(vector), Vec2.new(3, 4), 0.0)
	assert_vec2(vector.rejection(vector), Vec2.zero(), 0.0)


func test_what_is_returned_is_shared_with_nobody() -> void:
	var vector := Vec2.new(0.6, 0.8)
	var other := Vec2.new(1, 0)
	for method: String in _nouns():
		var result: Vec2 = _nouns()[method].call(vector, other)
		result.set_xy(99, 99)
		assert_vec2(vector, Vec2.new(0.6, 0.8), 0.0, method)
		assert_vec2(other, Vec2.new(1, 0), 0.0, method)


func test_what_is_returned_is_new_at_each_call() -> void:
	var vector := Vec2.new(0.6, 0.8)
	var other := Vec2.new(1, 0)
	for method: String in _nouns():
		var first: Vec2 = _nouns()[method].call(vector, other)
		var second: Vec2 = _nouns()[method].call(vector, other)
		assert_not_same(first, second, method)


func test_a_refused_division_or_move_gives_a_copy_too() -> void:
	var vector := Vec2.new(3, 4)
	assert_not_same(vector.divided(0), vector)
	assert_push_error("divisor must not be 0")
	assert_not_same(vector.moved_toward(Vec2.zero(), -1), vector)
	assert_push_error("distance must be 0 or more")


func test_every_method_that_returns_a_vector_is_looked_at() -> void:
	var names: Array[String] = []
	for method: Dictionary in (Vec2 as Script).get_script_method_list():
		var method_name: String = method["name"]
		var flags: int = method["flags"]
		var result: Dictionary = method["return"]
		if result["class_name"] == &"Vec2" and not flags & METHOD_FLAG_STATIC:
			names.append(method_name)
	names.sort()
	var looked_at := _nouns().keys()
	looked_at.sort()
	assert_eq(looked_at, names)


func test_no_argument_is_changed() -> void:
	var vector := Vec2.new(3, 4)
	var other := Vec2.new(0.6, 0.8)
	vector.add(other)
	vector.subtract(other)
	vector.reflect(other, 0.5)
	vector.rotate_around_degrees(other, 30)
	vector.rotate_around_radians(other, ANGLE)
	assert_vec2(other, Vec2.new(0.6, 0.8), 0.0)


## The methods that return a vector, called so that the result equals one of the two where it can.
func _nouns() -> Dictionary[String, Callable]:
	return {
		"copy": func(a: Vec2, _b: Vec2) -> Vec2: return a.copy(),
		"plus": func(a: Vec2, b: Vec2) -> Vec2: return a.plus(b),
		"minus": func(a: Vec2, b: Vec2) -> Vec2: return a.minus(b),
		"scaled": func(a: Vec2, _b: Vec2) -> Vec2: return a.scaled(1),
		"divided": func(a: Vec2, _b: Vec2) -> Vec2: return a.divided(1),
		"negated": func(a: Vec2, _b: Vec2) -> Vec2: return a.negated(),
		"normalized": func(a: Vec2, _b: Vec2) -> Vec2: return a.normalized(),
		"normal": func(a: Vec2, _b: Vec2) -> Vec2: return a.normal(),
		"reflected": func(a: Vec2, b: Vec2) -> Vec2: return a.reflected(b),
		"vector_projection": func(a: Vec2, b: Vec2) -> Vec2: return a.vector_projection(b),
		"rejection": func(a: Vec2, _b: Vec2) -> Vec2: return a.rejection(Vec2.zero()),
		"lerped": func(a: Vec2, b: Vec2) -> Vec2: return a.lerped(b, 1),
		"moved_toward": func(a: Vec2, b: Vec2) -> Vec2: return a.moved_toward(b, 100),
	}
