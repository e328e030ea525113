extends LabTest
## Directions to about 100 bits.


func test_the_nearest_double_is_that_of_the_engine() -> void:
	for place: int in 400:
		var angle := 0.37 * place - 70.0
		var unit := ExactAngle.unit(DoubleDouble.from_float(angle))
		assert_vec2(unit.to_vec2(), Vec2.unit_radians(angle), EPSILON)


func test_the_length_is_one_to_a_hundred_bits() -> void:
	for place: int in 50:
		var unit := ExactAngle.unit(DoubleDouble.from_float(17.1 * place - 400.0))
		assert_almost_eq(unit.dot(unit).error_of(1.0), 0.0, 1e-30)


func test_two_angles_add_to_a_hundred_bits() -> void:
	for place: int in 50:
		var one := 0.77 * place - 20.0
		var other := 0.031 * place * place
		var sum := ExactAngle.unit(DoubleDouble.sum_of(one, other))
		var a := ExactAngle.unit(DoubleDouble.from_float(one))
		var b := ExactAngle.unit(DoubleDouble.from_float(other))
		# cos(one + other) and sin(one + other).
		var gap := a.scaled(b.x).plus(a.turned().scaled(b.y)).minus(sum)
		assert_almost_eq(gap.to_vec2().length(), 0.0, 1e-29)


func test_half_a_turn_is_the_double_next_to_pi() -> void:
	# sin(PI) of the double PI is what PI lacks.
	var unit := ExactAngle.unit(DoubleDouble.from_float(PI))
	assert_almost_eq(unit.y.to_float() / 1.2246467991473532e-16, 1.0, 1e-15)
	assert_eq(unit.x.to_float(), -1.0)
