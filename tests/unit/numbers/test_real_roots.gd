extends LabTest
## The real zeros of polynomials and other functions.


func test_the_zeros_of_a_product_are_found_in_order() -> void:
	# (t - 1) (t - 2) (t - 3) (t + 4)
	var product: PackedFloat64Array = [-24, 38, -13, -2, 1]
	var found := RealRoots.of_polynomial(product, -10, 10)
	assert_eq(found.size(), 4)
	for place: int in 4:
		assert_almost_eq(found[place], ([-4.0, 1.0, 2.0, 3.0] as Array[float])[place], 1e-14)


func test_only_zeros_in_the_range_count_and_its_upper_end_does() -> void:
	var line: PackedFloat64Array = [-2, 1]
	assert_eq(RealRoots.of_polynomial(line, 0, 2), PackedFloat64Array([2]))
	assert_eq(RealRoots.of_polynomial(line, 2, 5), PackedFloat64Array())
	assert_eq(RealRoots.of_polynomial(line, 0, 1.5), PackedFloat64Array())


func test_a_constant_has_none() -> void:
	assert_eq(RealRoots.of_polynomial([3], -1, 1), PackedFloat64Array())
	assert_eq(RealRoots.of_polynomial([1, 0, 1], -9, 9), PackedFloat64Array())


func test_random_products_give_their_factors() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 3
	for trial: int in 100:
		var zeros: PackedFloat64Array = []
		var product: PackedFloat64Array = [1.0]
		for factor: int in 4:
			zeros.append(rng.randf_range(-5, 5) + 20 * factor)
			product = _times(product, zeros[-1])
		var found := RealRoots.of_polynomial(product, -100, 100)
		assert_eq(found.size(), 4)
		for place: int in 4:
			assert_almost_eq(found[place], zeros[place], 1e-9)


func test_the_zero_of_another_function() -> void:
	var found := RealRoots.of_function(func(t: float) -> float: return cos(t), [], 0.0, 3.0)
	assert_eq(found, PackedFloat64Array([PI / 2]))


# The polynomial times (t - zero).
static func _times(product: PackedFloat64Array, zero: float) -> PackedFloat64Array:
	var longer: PackedFloat64Array = []
	longer.resize(product.size() + 1)
	for place: int in product.size():
		longer[place] -= zero * product[place]
		longer[place + 1] += product[place]
	return longer
