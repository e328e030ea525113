extends LabTest
## The lesson on friction at a bounce: the numbers of its presets, what each mistake makes of them,
## and what it refuses.

var _model: CollisionFrictionModel


func before_each() -> void:
	_model = CollisionFrictionModel.new()


func test_the_numbers_of_the_table() -> void:
	_assert_leaves("Sticks", Vec2.new(200.0, -400.0), 10.0, Friction.Regime.STICK)
	_assert_leaves("Slips", Vec2.new(220.0, -400.0), 8.0, Friction.Regime.SLIP)
	_assert_leaves("Backspin", Vec2.new(0.0, -400.0), 0.0, Friction.Regime.STICK)
	_assert_leaves("C = 0.5", Vec2.new(200.0, -200.0), 10.0, Friction.Regime.STICK)
	_assert_leaves("Slope", Vec2.new(400.0, -200.0), 10.0, Friction.Regime.STICK)
	_assert_leaves("Hops", Vec2.new(126.0, -240.0), 5.4, Friction.Regime.SLIP)
	_assert_leaves("Two balls", Vec2.new(75.0, -100.0), 2.5, Friction.Regime.STICK)
	var other := _model.contact().after()[1]
	assert_vec2(other.velocity, Vec2.new(175.0, 100.0), 1e-12)
	assert_almost_eq(other.spin, 2.5, 1e-14)
	assert_eq(CollisionFrictionPresets.all().size(), 7)


func test_the_start_is_the_first_preset() -> void:
	var start := _model.to_dictionary()
	_take("Sticks")
	assert_eq(_model.to_dictionary(), start)


func test_without_friction_the_bounce_is_a_reflection() -> void:
	assert_no_refusal(_model.take({"has_friction": false, "spin": 7.0}))
	var leaving := _model.contact().after()[0]
	assert_vec2(leaving.velocity, Vec2.new(300.0, -400.0), 1e-12)
	assert_eq(leaving.spin, 7.0)
	assert_eq(_model.friction, 0.25)


func test_mu_as_a_factor_leaves_225() -> void:
	_assert_wrong(CollisionFrictionMistakes.AS_FACTOR, Vec2.new(225.0, -400.0), 0.0)


func test_without_the_spin_100_are_left() -> void:
	_assert_wrong(CollisionFrictionMistakes.WITHOUT_SPIN, Vec2.new(100.0, -400.0), 0.0)


func test_without_a_limit_friction_turns_the_ball_back() -> void:
	assert_no_refusal(_model.take({"friction": 0.5}))
	_assert_wrong(CollisionFrictionMistakes.NO_STICK, Vec2.new(-100.0, -400.0), 40.0)
	assert_vec2(_model.contact().after()[0].velocity, Vec2.new(200.0, -400.0), 1e-12)


func test_a_tangent_set_to_0_stops_the_ball() -> void:
	_assert_wrong(CollisionFrictionMistakes.NO_TANGENT, Vec2.new(0.0, -400.0), 0.0)


func test_smooth_balls_leave_along_n() -> void:
	assert_no_refusal(_model.take({"mistake": CollisionFrictionMistakes.SMOOTH_BALLS}))
	assert_true(_model.two_balls)
	var wrong := CollisionFrictionMistakes.balls_after(_model.mistake, _model.contact())
	assert_vec2(wrong[1].velocity, Vec2.new(160.0, 120.0), 1e-12)
	assert_eq(wrong[1].spin, 0.0)


func test_every_mistake_shows_as_soon_as_it_is_switched_on() -> void:
	for info: MistakeInfo in CollisionFrictionMistakes.infos():
		for preset: String in CollisionFrictionPresets.all():
			_model = CollisionFrictionModel.new()
			_take(preset)
			assert_no_refusal(_model.take({"has_friction": false}))
			assert_no_refusal(_model.take({"mistake": info.number}))
			assert_true(_model.shows_mistake(), "%s, %s" % [info.title, preset])


func test_every_mistake_names_a_test_that_is_here() -> void:
	var names := get_method_list().map(func(method: Dictionary) -> String: return method["name"])
	for info: MistakeInfo in CollisionFrictionMistakes.infos():
		assert_eq(info.test.get_slice(".", 0), "test_collision_friction_model")
		assert_has(names, info.test.get_slice(".", 1))


func test_what_cannot_be_taken_changes_nothing() -> void:
	var before := _model.to_dictionary()
	assert_eq(_model.enter("friction", -0.5), "µ must be within 0..10, not −0.5.")
	assert_eq(_model.enter("bounciness", 1.5), "C must be within 0..1, not 1.5.")
	assert_eq(_model.enter("spin", 1001.0), "ω must be within −1000..1000, not 1001.")
	assert_eq(_model.enter("radius", 0.5), "r must be within 1..1000, not 0.5.")
	assert_eq(_model.enter("gravity", -1.0), "g must be within 0..10000, not −1.")
	var away := "The ball must come to the surface with at least 1 px/s, not −400."
	assert_eq(_model.enter("vy", -400.0), away)
	var short := "The surface must be at least 1 px long, not 0.5."
	assert_eq(_model.take({"along": PackedFloat64Array([0.5, 0.0])}), short)
	assert_eq(_model.to_dictionary(), before)


func test_typed_numbers_are_taken() -> void:
	for name_in_line: String in ["spin", "radius", "friction", "bounciness", "gravity"]:
		assert_no_refusal(_model.enter(name_in_line, 1.0))
		var taken: float = _model.get(name_in_line)
		assert_eq(taken, 1.0, name_in_line)
	assert_no_refusal(_model.enter("vx", -20.0))
	assert_no_refusal(_model.enter("vy", 30.0))
	assert_vec2(_model.velocity, Vec2.new(-20.0, 30.0), 0.0)


func _assert_leaves(preset: String, velocity: Vec2, spin: float, regime: Friction.Regime) -> void:
	_take(preset)
	var contact := _model.contact()
	var leaving := contact.after()[0]
	assert_vec2(leaving.velocity, velocity, 1e-12)
	assert_almost_eq(leaving.spin, spin, 1e-14, preset)
	assert_eq(contact.regime(), regime, preset)


func _assert_wrong(number: int, velocity: Vec2, spin: float) -> void:
	var wrong := CollisionFrictionMistakes.balls_after(number, _model.contact())
	assert_vec2(wrong[0].velocity, velocity, 1e-12)
	assert_almost_eq(wrong[0].spin, spin, 1e-14)
	assert_true(CollisionFrictionMistakes.is_seen(number, _model.contact()))


func _take(preset: String) -> void:
	assert_no_refusal(_model.take(CollisionFrictionPresets.all()[preset]))
