extends LabTest
## The symmetric elliptic integral: published values, symmetry, and elementary cases.


func test_published_values() -> void:
	# Carlson 1995, section 3.
	assert_almost_eq(CarlsonIntegral.first_kind(1, 2, 0), 1.3110287771461, 1e-13)
	assert_almost_eq(CarlsonIntegral.first_kind(0.5, 1, 0), 1.8540746773014, 1e-13)
	assert_almost_eq(CarlsonIntegral.first_kind(2, 3, 4), 0.58408284167715, 1e-14)


func test_three_equal_numbers_give_one_over_the_root() -> void:
	for number: float in [1e-200, 0.25, 1.0, 49.0, 1e200]:
		var wanted := 1.0 / sqrt(number)
		assert_almost_eq(CarlsonIntegral.first_kind(number, number, number), wanted, 1e-15 * wanted)


func test_two_equal_numbers_give_an_arc_tangent_or_a_logarithm() -> void:
	for x: float in [1e-12, 0.01, 0.5, 0.9]:
		var wanted := acos(sqrt(x)) / sqrt(1.0 - x)
		assert_almost_eq(CarlsonIntegral.first_kind(x, 1, 1), wanted, 4.0 * EPSILON * wanted)
	for x: float in [1.5, 100.0, 1e10]:
		var wanted := log(sqrt(x) + sqrt(x - 1.0)) / sqrt(x - 1.0)
		assert_almost_eq(CarlsonIntegral.first_kind(x, 1, 1), wanted, 8.0 * EPSILON * wanted)


func test_order_does_not_matter_and_a_factor_comes_out_as_its_root() -> void:
	var wanted := CarlsonIntegral.first_kind(0.3, 5, 70)
	assert_almost_eq(CarlsonIntegral.first_kind(70, 0.3, 5), wanted, 2.0 * EPSILON * wanted)
	assert_almost_eq(CarlsonIntegral.first_kind(30, 500, 7000), wanted / 10.0, EPSILON * wanted)
