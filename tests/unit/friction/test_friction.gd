extends LabTest
## Coulomb's law: the surfaces stick if µ times what presses can end the slip.


func test_a_third_of_the_slip_is_what_it_takes_to_stick() -> void:
	assert_eq(Friction.impulse(300.0, 800.0, 0.25), -100.0)
	assert_eq(Friction.regime(300.0, 800.0, 0.25), Friction.Regime.STICK)


func test_a_slippery_contact_gives_mu_times_what_presses() -> void:
	assert_eq(Friction.impulse(300.0, 800.0, 0.1), -80.0)
	assert_eq(Friction.impulse(-300.0, 800.0, 0.1), 80.0)
	assert_eq(Friction.regime(300.0, 800.0, 0.1), Friction.Regime.SLIP)


func test_just_enough_sticks() -> void:
	assert_eq(Friction.regime(300.0, 800.0, 0.125), Friction.Regime.STICK)
	assert_eq(Friction.regime(300.1, 800.0, 0.125), Friction.Regime.SLIP)


func test_without_friction_nothing_sticks_and_nothing_brakes() -> void:
	for slip: float in [-300.0, 0.0, 300.0]:
		assert_eq(Friction.regime(slip, 800.0, 0.0), Friction.Regime.SLIP)
		assert_eq(Friction.impulse(slip, 800.0, 0.0), 0.0)


func test_without_slip_there_is_no_impulse() -> void:
	assert_eq(Friction.regime(0.0, 800.0, 0.1), Friction.Regime.STICK)
	assert_eq(Friction.impulse(0.0, 800.0, 0.1), 0.0)


func test_a_disc_gives_way_three_times_as_easily_as_a_box() -> void:
	assert_eq(Friction.YIELD, 3.0)


func test_a_friction_that_cannot_be_is_named() -> void:
	assert_eq(Friction.problem_of(0.0), "")
	assert_eq(Friction.problem_of(7.5), "")
	for bad: float in [-0.1, INF, NAN]:
		var wanted := "The friction µ must be within 0..1e+152, not %s." % bad
		assert_eq(Friction.problem_of(bad), wanted)
