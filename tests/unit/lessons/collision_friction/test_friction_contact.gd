extends LabTest
## A contact with friction, of a ball and a line or of two balls: what it keeps and loses, how it is
## flown, and how far rounding moves it.

const _CONTACTS := 300

var _rng := RandomNumberGenerator.new()


func before_each() -> void:
	_rng.seed = 20


func test_angular_momentum_is_kept_and_energy_is_lost_as_it_says() -> void:
	var stuck := 0
	for number: int in _CONTACTS:
		var contact := _random(number % 2 == 0)
		stuck += int(contact.regime() == Friction.Regime.STICK)
		var before := contact.before()
		var after := contact.after()
		var size := contact.ball.radius * contact.speed_scale()
		assert_almost_eq(
			FrictionContact.angular_momentum(after),
			FrictionContact.angular_momentum(before),
			1e-13 * size
		)
		var energy := FrictionContact.energy(before)
		var lost := contact.lost_to_bounce() + contact.lost_to_friction()
		assert_almost_eq(energy - FrictionContact.energy(after), lost, 1e-12 * energy)
		assert_gte(contact.lost_to_friction(), 0.0)
	assert_between(stuck, 60, 240)


func test_the_parts_of_the_ledger_are_all_there_is() -> void:
	for number: int in 50:
		var contact := _random(number % 2 == 0)
		for balls: Array[Ball] in [contact.before(), contact.after()]:
			var energy := 0.0
			for part in contact.energy_parts(balls):
				energy += part
			assert_almost_eq(energy, FrictionContact.energy(balls), 1e-12 * energy)
			var parts := FrictionContact.momentum_parts(balls)
			var momentum := FrictionContact.angular_momentum(balls)
			assert_almost_eq(parts[0] + parts[1], momentum, 1e-9)


func test_the_surfaces_stick_or_friction_is_all_of_mu_jn() -> void:
	for number: int in _CONTACTS:
		var contact := _random(number % 2 == 0)
		var scale := contact.speed_scale()
		var after := contact.after()
		var still_rubs := after[0].velocity.dot(contact.tangent) - after[0].radius * after[0].spin
		if contact.other:
			still_rubs -= after[1].velocity.dot(contact.tangent) + after[1].radius * after[1].spin
		if contact.regime() == Friction.Regime.STICK:
			assert_almost_eq(still_rubs, 0.0, 1e-13 * scale)
		else:
			assert_almost_eq(absf(contact.grip()), contact.limit(), 1e-13 * scale)
			assert_gt(still_rubs * contact.slip(), 0.0)


func test_the_same_impulses_lead_to_the_same_balls() -> void:
	for number: int in 50:
		var contact := _random(number % 2 == 0)
		var after := contact.after()
		var again := contact.after_with(contact.grip(), contact.grip())
		for place: int in after.size():
			assert_vec2(again[place].velocity, after[place].velocity, 1e-12 * contact.speed_scale())
			assert_almost_eq(again[place].spin, after[place].spin, 1e-11)


func test_the_event_world_flies_what_the_formula_says() -> void:
	for number: int in 100:
		var contact := _random(number % 2 == 0)
		var gravity := Vec2.new(0.0, 0.0 if contact.other else _rng.randf_range(0.0, 900.0))
		var flight := ContactFlight.new(contact, gravity, contact.friction)
		flight.go_to(flight.contact_time)
		assert_vec2(flight.ball(0).position, contact.ball.position, 1e-10)
		var bound := ContactRounding.off_line(contact, flight, gravity) if flight.line else 0.0
		if contact.other:
			bound = ContactRounding.of_two(contact, flight)
		assert_lt(flight.miss(), 2.0 * bound, "contact %d" % number)
		assert_lt(bound, 1e-7)


func test_a_wrong_answer_misses_by_more_than_rounding() -> void:
	var contact := FrictionContact.new(
		Ball.new(Vec2.zero(), 20.0, Vec2.new(300.0, 400.0)), Vec2.new(1.0, 0.0), 1.0, 0.25
	)
	var flight := ContactFlight.new(contact, Vec2.zero(), 0.1)
	assert_almost_eq(flight.miss(), 20.0 * ContactFlight.LONGEST_SIDE, 1e-9)


# Straight down on a smooth floor, y at last is 2 (floor - r) - y0 - v T for C = 1: the start, v, r,
# C and both times count.
func test_the_condition_of_a_bounce_straight_up_is_known() -> void:
	var ball := Ball.new(Vec2.zero(), 20.0, Vec2.new(0.0, 400.0))
	var contact := FrictionContact.new(ball, Vec2.new(1.0, 0.0), 1.0, 0.0)
	var flight := ContactFlight.new(contact, Vec2.zero(), 0.0)
	var wanted := 140.0 + 400.0 * 0.6 + 2.0 * 20.0 + 400.0 * 0.3 + 400.0 * 0.6
	var bound := ContactRounding.off_line(contact, flight, Vec2.zero())
	assert_almost_eq(bound / ShotCondition.EPSILON, wanted, 1e-3)


# Head-on, the ball at rest takes all: x at last is x2 + v T - (x2 - x1 - 2 r).
func test_the_condition_of_a_ball_that_is_hit_head_on_is_known() -> void:
	var ball := Ball.new(Vec2.zero(), 20.0, Vec2.new(400.0, 0.0))
	var other := Ball.new(Vec2.zero(), 20.0)
	var contact := FrictionContact.new(ball, Vec2.new(0.0, -1.0), 1.0, 0.0, other)
	var flight := ContactFlight.new(contact, Vec2.zero(), 0.0)
	# x1 and v, r, C with half of the speed, both times; x2 cancels.
	var wanted := 140.0 + 400.0 * 0.6 + 2.0 * 20.0 + 200.0 * 0.3 + 400.0 * 0.6
	var bound := ContactRounding.of_two(contact, flight)
	assert_almost_eq(bound / ShotCondition.EPSILON, wanted, 1e-3)


func test_hops_slip_first_and_then_stick() -> void:
	var model := CollisionFrictionModel.new()
	assert_no_refusal(model.take(CollisionFrictionPresets.all()["Hops"]))
	var flight := model.flight(model.contact(), true)
	var regimes := flight.regimes()
	assert_eq(regimes[0], Friction.Regime.SLIP)
	assert_eq(regimes[1], Friction.Regime.STICK)
	assert_gte(regimes.size(), 4)
	flight.go_to(flight.end)
	assert_almost_eq(flight.ball(0).velocity.x, 120.0, 1e-12)
	assert_almost_eq(flight.ball(0).spin, 6.0, 1e-13)


func test_a_way_has_its_corners() -> void:
	var model := CollisionFrictionModel.new()
	var flight := model.flight(model.contact(), true)
	var lowest := -INF
	for place in flight.way(0, flight.end, 7):
		lowest = maxf(lowest, place.y)
	assert_almost_eq(lowest, -20.0, 1e-10)


func test_on_a_floor_the_ball_comes_from_above_it() -> void:
	for gravity: float in [1.0, 900.0, 1e4]:
		var contact := FrictionContact.new(
			Ball.new(Vec2.zero(), 20.0, Vec2.new(30.0, 2.0)), Vec2.new(1.0, 0.0), 0.5, 0.1
		)
		var flight := ContactFlight.new(contact, Vec2.new(0.0, gravity), 0.1)
		assert_lte(flight.start.position.y, -20.0)
		assert_lte(flight.contact_time, 2.0 / gravity + 1e-15)
		flight.go_to(flight.contact_time * 0.5)
		assert_lt(flight.ball(0).position.y, -20.0)


func _random(is_line: bool) -> FrictionContact:
	var along := Vec2.unit_radians(_rng.randf() * TAU).scaled(50.0)
	var tangent := along.normalized()
	var normal := Vec2.new(tangent.y, -tangent.x)
	var velocity := tangent.scaled(_rng.randf_range(-400.0, 400.0))
	velocity.add(normal.scaled(_rng.randf_range(-500.0, -20.0)))
	var radius := _rng.randf_range(2.0, 60.0)
	var ball := Ball.new(Vec2.zero(), radius, velocity, 1.0, _rng.randf_range(-30.0, 30.0))
	var other: Ball = null if is_line else Ball.new(Vec2.zero(), radius)
	return FrictionContact.new(ball, along, _rng.randf(), _rng.randf_range(0.0, 0.6), other)
