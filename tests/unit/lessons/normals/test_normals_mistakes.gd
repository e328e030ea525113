extends LabTest
## The wrong normals of the bug gallery are wrong in the way that their texts say.


func test_mistake_9_swapped_without_a_sign_is_not_perpendicular() -> void:
	assert_vec2(NormalsMistakes.swapped(Vec2.new(3.0, 1.0)), Vec2.new(1.0, 3.0), 0.0)
	assert_eq(Vec2.new(3.0, 1.0).dot(NormalsMistakes.swapped(Vec2.new(3.0, 1.0))), 6.0)


func test_mistake_9_with_the_wrong_sign_points_to_the_other_side() -> void:
	assert_vec2(NormalsMistakes.wrong_sign(Vec2.new(3.0, 1.0)), Vec2.new(1.0, -3.0), 0.0)


func test_mistake_6_divides_zero_by_zero() -> void:
	assert_false(NormalsMistakes.wrong_unit(6, Vec2.new()).is_finite())
	assert_vec2(NormalsMistakes.wrong_unit(6, Vec2.new(3.0, -4.0)), Vec2.new(0.8, 0.6), EPSILON)


func test_mistake_7_loses_short_vectors_only() -> void:
	assert_vec2(NormalsMistakes.wrong_unit(7, Vec2.new(0.3, 0.4)), Vec2.new(), 0.0)
	assert_vec2(NormalsMistakes.wrong_unit(7, Vec2.new(3.0, -4.0)), Vec2.new(0.8, 0.6), EPSILON)


func test_every_mistake_names_a_test_that_exists() -> void:
	for mistake: MistakeInfo in NormalsMistakes.infos():
		var names := mistake.test.split(".")
		var script: GDScript = load("res://tests/unit/%s.gd" % names[0])
		var methods := script.get_script_method_list().map(
			func(method: Dictionary) -> String: return method["name"]
		)
		assert_has(methods, names[1])
		assert_string_contains(mistake.checks, "The test", mistake.title)
