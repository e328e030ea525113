extends LabTest
## The bounce with friction: the numbers of the lesson, and what it keeps and loses.

var _normal := Vec2.new(0, -1)


func test_the_lesson_s_ball_sticks_and_slips() -> void:
	_assert_bounces(300, 0, 0.25, Friction.Regime.STICK, 200.0, 10.0)
	_assert_bounces(300, 0, 0.1, Friction.Regime.SLIP, 220.0, 8.0)
	_assert_bounces(300, 0, 0.0, Friction.Regime.SLIP, 300.0, 0.0)


# Without that limit the ball would fly on with -100 px/s.
func test_more_friction_than_it_takes_to_stick_changes_nothing() -> void:
	_assert_bounces(300, 0, 0.5, Friction.Regime.STICK, 200.0, 10.0)


func test_backspin_can_make_it_hop_straight_up() -> void:
	_assert_bounces(300, -30, 0.5, Friction.Regime.STICK, 0.0, 0.0)


func test_a_ball_that_rolls_already_keeps_its_spin() -> void:
	_assert_bounces(300, 15, 0.5, Friction.Regime.STICK, 300.0, 15.0)


func test_a_ball_that_moves_away_or_along_is_left_alone() -> void:
	for downwards: float in [0.0, -400.0]:
		var ball := Ball.new(Vec2.zero(), 20, Vec2.new(300, downwards), 1.0, 5.0)
		assert_eq(FrictionBounce.bounce(ball, _normal, 1.0, 0.5), Friction.Regime.NONE)
		assert_vec2(ball.velocity, Vec2.new(300, downwards), 0.0)
		assert_eq(ball.spin, 5.0)


func test_a_wall_that_moves_along_drags_the_ball_with_it() -> void:
	var ball := Ball.new(Vec2.zero(), 20, Vec2.new(0, 400))
	var belt := Vec2.new(90, 0)
	assert_eq(FrictionBounce.bounce(ball, _normal, 0.0, 0.5, belt), Friction.Regime.STICK)
	assert_vec2(ball.velocity, Vec2.new(30, 0), 1e-14)
	assert_almost_eq(ball.spin, -3.0, 1e-15)


func test_the_angular_momentum_about_the_contact_is_kept() -> void:
	var changes: PackedFloat64Array = []
	for hit in _hits(200):
		var contact := hit.ball.position.minus(hit.normal.scaled(hit.ball.radius))
		var before := Disc.angular_momentum(hit.ball, contact)
		hit.bounce()
		var change := absf(Disc.angular_momentum(hit.ball, contact) - before)
		changes.append(change / (hit.ball.mass * hit.ball.radius))
	assert_all_at_most(changes, 1e-11)


# m (1 - C²) vn² / 2, and sticking m slip² / 6, slipping m µ jn (|slip| - 3/2 µ jn).
func test_the_energy_that_is_lost() -> void:
	var errors: PackedFloat64Array = []
	var sticks := 0
	for hit in _hits(200):
		var slip := hit.slip()
		var approach := hit.ball.velocity.dot(hit.normal)
		var grip := hit.friction * (1.0 + hit.bounciness) * -approach
		var lost := 0.5 * (1.0 - hit.bounciness ** 2) * approach ** 2
		var before := Disc.energy(hit.ball)
		if hit.bounce() == Friction.Regime.STICK:
			sticks += 1
			lost += slip * slip / 6.0
		else:
			lost += grip * (absf(slip) - 1.5 * grip)
		errors.append(absf(before - Disc.energy(hit.ball) - hit.ball.mass * lost) / before)
	assert_all_at_most(errors, 1e-13)
	assert_between(sticks, 40, 160)


func test_the_impulse_is_within_coulomb_s_cone_and_against_the_slip() -> void:
	for hit in _hits(200):
		var before := hit.ball.velocity.copy()
		var slip := hit.slip()
		var regime := hit.bounce()
		var impulse := hit.ball.velocity.minus(before)
		var along := impulse.dot(Vec2.new(-hit.normal.y, hit.normal.x))
		var push := impulse.dot(hit.normal)
		assert_lt(absf(along), hit.friction * push + 1e-10)
		assert_lt(along * slip, 1e-10)
		if regime == Friction.Regime.STICK:
			assert_almost_eq(hit.slip(), 0.0, 1e-10)
		else:
			assert_almost_eq(absf(along), hit.friction * push, 1e-10)


func test_bounciness_is_that_of_the_normal_alone() -> void:
	for hit in _hits(200):
		var approach := hit.ball.velocity.dot(hit.normal)
		hit.bounce()
		assert_almost_eq(hit.ball.velocity.dot(hit.normal), -hit.bounciness * approach, 1e-10)


func test_an_observer_who_moves_along_sees_the_same() -> void:
	var hits := _hits(200)
	var frames := random_vectors(82, 200)
	for index: int in hits.size():
		var hit := hits[index]
		var seen := hit.ball.copy()
		seen.velocity.add(frames[index])
		hit.bounce()
		FrictionBounce.bounce(seen, hit.normal, hit.bounciness, hit.friction, frames[index])
		assert_vec2(seen.velocity.minus(frames[index]), hit.ball.velocity, 1e-11)
		assert_almost_eq(seen.spin, hit.ball.spin, 1e-11)


func test_in_a_mirror_the_spin_turns_the_other_way() -> void:
	for hit in _hits(200):
		var mirrored := hit.ball.copy()
		mirrored.velocity.x *= -1.0
		mirrored.spin *= -1.0
		var normal := Vec2.new(-hit.normal.x, hit.normal.y)
		hit.bounce()
		FrictionBounce.bounce(mirrored, normal, hit.bounciness, hit.friction)
		var wanted := Vec2.new(-hit.ball.velocity.x, hit.ball.velocity.y)
		assert_vec2(mirrored.velocity, wanted, 1e-12)
		assert_almost_eq(mirrored.spin, -hit.ball.spin, 1e-12)


func test_what_cannot_be_used_is_an_error_and_changes_nothing() -> void:
	var ball := Ball.new(Vec2.zero(), 20, Vec2.new(300, 400))
	FrictionBounce.bounce(ball, Vec2.new(0, -2), 1.0, 0.1)
	assert_push_error("The normal must have length 1, but has length 2.0.")
	FrictionBounce.bounce(ball, _normal, -1.0, 0.1)
	assert_push_error("The bounciness C must be within 0..1, not -1.0.")
	FrictionBounce.bounce(ball, _normal, 1.0, -0.1)
	assert_push_error("The friction µ must be within 0..1e+152, not -0.1.")
	FrictionBounce.bounce(ball, _normal, 1.0, 0.1, Vec2.new(INF, 0))
	assert_push_error("The velocity of a wall must be within -1e+152..1e+152 px/s, not (inf")
	assert_vec2(ball.velocity, Vec2.new(300, 400), 0.0)
	assert_eq(ball.spin, 0.0)


# After a fall with 400 px/s on a level floor.
func _assert_bounces(
	along: float,
	spin: float,
	friction: float,
	regime: Friction.Regime,
	along_after: float,
	spin_after: float
) -> void:
	var ball := Ball.new(Vec2.zero(), 20, Vec2.new(along, 400), 1.0, spin)
	assert_eq(FrictionBounce.bounce(ball, _normal, 1.0, friction), regime)
	assert_vec2(ball.velocity, Vec2.new(along_after, -400), 1e-13)
	assert_almost_eq(ball.spin, spin_after, 1e-14)


static func _hits(count: int) -> Array[Hit]:
	var rng := RandomNumberGenerator.new()
	rng.seed = 81
	var hits: Array[Hit] = []
	while hits.size() < count:
		hits.append(Hit.new(rng))
	return hits


class Hit:
	var ball: Ball
	var normal: Vec2
	var bounciness: float
	var friction: float

	func _init(rng: RandomNumberGenerator) -> void:
		normal = Vec2.random_unit(rng)
		var velocity := Vec2.random_unit(rng).scaled(rng.randf_range(1, 500))
		if velocity.dot(normal) > 0.0:
			velocity.scale(-1.0)
		var place := Vec2.random_unit(rng).scaled(rng.randf_range(0, 300))
		var spin := rng.randf_range(-20, 20)
		ball = Ball.new(place, rng.randf_range(5, 30), velocity, rng.randf_range(0.5, 5), spin)
		bounciness = rng.randf()
		friction = rng.randf_range(0.01, 0.6)

	func slip() -> float:
		var tangent := Vec2.new(-normal.y, normal.x)
		return ball.velocity.dot(tangent) - ball.radius * ball.spin

	func bounce() -> Friction.Regime:
		return FrictionBounce.bounce(ball, normal, bounciness, friction)
