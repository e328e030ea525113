extends LabTest
## What each way of stepping a dropped ball is known to do.


func test_explicit_euler_gains_energy_and_semi_implicit_loses_it() -> void:
	assert_gt(_energy(IntegratorDrop.Way.EXPLICIT_EULER), 1.5)
	assert_lt(_energy(IntegratorDrop.Way.SEMI_IMPLICIT_EULER), 0.5)


func test_an_integrator_is_better_in_smaller_steps() -> void:
	var coarse := IntegratorDrop.new(IntegratorDrop.Way.EXPLICIT_EULER, 0.8, 60)
	var fine := IntegratorDrop.new(IntegratorDrop.Way.EXPLICIT_EULER, 0.8, 960)
	coarse.run_once()
	fine.run_once()
	assert_lt(fine.error, 0.1 * coarse.error)


func test_the_event_world_is_exact_for_every_bounciness() -> void:
	for bounciness in DroppedBall.BOUNCINESSES:
		var case := EventDrop.new(bounciness, 60)
		case.run_once()
		assert_lt(case.error, 1e-9, "C = %s" % bounciness)


func test_a_stiff_spring_blows_up_in_large_steps_and_not_in_small_ones() -> void:
	var coarse := SpringDrop.new(1e6, 0.5, 60)
	var fine := SpringDrop.new(1e6, 0.5, 3840)
	coarse.run_once()
	fine.run_once()
	assert_eq(coarse.error, Measurement.NO_ANSWER)
	assert_string_starts_with(coarse.note, "blown up")
	assert_lt(fine.error, 0.01)


func test_the_stiffest_spring_leaves_no_number_that_is_not_finite() -> void:
	var case := SpringDrop.new(1e10, 1.0, 60)
	case.run_once()
	var line := MeasurementTable.to_csv([case.result()]).to_lower()
	assert_false(line.contains("nan") or line.contains("inf"))


func test_a_soft_floor_gives_way_by_gravity_over_stiffness() -> void:
	# Gravity of 1000 px/s^2 over a stiffness of 100 1/s^2: the ball lies 10 px deep.
	var case := SpringDrop.new(1e2, 0.5, 960)
	case.run_once()
	assert_almost_eq(case.figures["height"], -10.0, 1e-6)


func test_the_damping_of_a_spring_makes_the_bounciness() -> void:
	# After one bounce of a spring in very small steps, without gravity, the share C of the speed is
	# left.
	for bounciness: float in [0.8, 0.5, 0.1]:
		var damping := 2.0 * SpringDrop.damping_share(bounciness)
		var height := 0.0
		var speed := -1.0
		while height <= 0.0:
			speed += (-height - damping * speed) * 1e-5
			height += speed * 1e-5
		assert_almost_eq(speed, bounciness, 1e-3)


func test_a_stiff_spring_in_small_steps_bounces_as_high_as_it_should() -> void:
	# The top of the first hop is at C^2 of 200 px, after 1 + C falls and a contact of 3 ms.
	var case := Observed.new(1e6, 0.5, 15360)
	var fall := sqrt(2.0 * DroppedBall.HEIGHT / DroppedBall.GRAVITY)
	assert_almost_eq(case.height_after(1.5 * fall), 50.0, 1.0)


func test_a_spring_is_named_by_its_power_of_ten() -> void:
	assert_eq(SpringDrop.new(1e8, 1.0, 60).tuning, "1e8 1/s^2")
	assert_eq(SpringDrop.exponent_text(1e10), "1e10")


func test_every_bounciness_has_integrators_springs_and_the_event_world() -> void:
	var methods: Dictionary[String, bool] = {}
	for case in DroppedBallProblem.new().cases(true):
		if case.situation == DroppedBall.situation_of(0.5):
			methods[case.method] = true
	for method: String in IntegratorDrop.METHODS.values() + ["event world"]:
		assert_has(methods, method)
	assert_has(methods, "penalty spring, 60 Hz")


func _energy(way: IntegratorDrop.Way) -> float:
	var case := IntegratorDrop.new(way, 1.0, 60)
	case.run_once()
	return case.figures["energy"]


class Observed:
	extends SpringDrop

	func height_after(time: float) -> float:
		_prepare()
		_fly(roundi(time * rate))
		return _height
