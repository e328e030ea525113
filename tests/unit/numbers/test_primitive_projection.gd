extends LabTest
## The projection by angles: right in principle, and worse than the dot product.


func test_it_gives_the_numbers_of_the_lecture() -> void:
	var scalar := PrimitiveProjection.scalar(Vec2.new(7, 1), Vec2.new(8, -6))
	assert_almost_eq(scalar, 5.0, 1e-14)


func test_it_agrees_with_the_dot_product_on_ordinary_numbers() -> void:
	var vectors := random_vectors(12, 400, 10.0)
	for i: int in 200:
		var a := vectors[2 * i]
		var b := vectors[2 * i + 1]
		var by_dot := (a.x * b.x + a.y * b.y) / sqrt(b.x * b.x + b.y * b.y)
		assert_almost_eq(PrimitiveProjection.scalar(a, b), by_dot, 1e-13)


func test_it_is_zero_for_zero_vectors() -> void:
	assert_eq(PrimitiveProjection.scalar(Vec2.new(7, 1), Vec2.new(0, 0)), 0.0)
	assert_eq(PrimitiveProjection.scalar(Vec2.new(0, 0), Vec2.new(8, -6)), 0.0)


# The double nearest to pi / 2 is 6.123e-17 too small, so its cosine is 6.123e-17 and not 0. Times
# 5e15 that is 0.306.
func test_it_sees_a_shadow_of_huge_perpendicular_vectors() -> void:
	var a := Vec2.new(4e15, 3e15)
	var b := Vec2.new(6e15, -8e15)
	assert_almost_eq(PrimitiveProjection.scalar(a, b), 5e15 * 6.123234e-17, 1e-6)
	assert_eq(a.scalar_projection(b), 0.0)


func test_it_leaves_both_vectors_as_they_were() -> void:
	var a := Vec2.new(7, 1)
	var b := Vec2.new(8, -6)
	PrimitiveProjection.scalar(a, b)
	assert_vec2(a, Vec2.new(7, 1), 0.0)
	assert_vec2(b, Vec2.new(8, -6), 0.0)
