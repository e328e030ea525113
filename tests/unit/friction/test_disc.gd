extends LabTest
## What a disc carries when it moves and turns.

var _ball := Ball.new(Vec2.new(3, 4), 2.0, Vec2.new(6, 8), 5.0, 7.0)


func test_a_disc_has_half_of_m_r_squared() -> void:
	assert_eq(Disc.moment_of_inertia(_ball), 10.0)


func test_energy_is_that_of_the_flight_and_of_the_spin() -> void:
	assert_eq(Disc.energy(_ball), 250.0 + 245.0)


func test_angular_momentum_is_that_of_the_flight_about_a_point_and_of_the_spin() -> void:
	assert_eq(Disc.angular_momentum(_ball, Vec2.new(3, 0)), -120.0 + 70.0)
	assert_eq(Disc.angular_momentum(_ball, _ball.position), 70.0)
