extends LabTest
## Impacts with friction flown in the event world, against the same reference tables as
## [FrictionImpact] and [BallFrictionImpact].

# Where a ball touches a cap or another ball, the world takes the normal from the places of both,
# which are rounded: far from the origin that counts. The bar of the two classes is 4.
const _BAR := 64.0


func test_impacts_with_a_segment_at_rest_or_moving() -> void:
	for table: String in ["ball_segment_friction", "ball_moving_segment"]:
		var rows := FrictionRows.new(table)
		assert_gt(_fly_all(rows), 1350)
		_assert_right(rows)


func test_impacts_with_a_segment_that_turns() -> void:
	var rows := FrictionRows.new("ball_turning_segment")
	assert_gt(_fly_all(rows), 480)
	_assert_right(rows)


func _fly_all(rows: FrictionRows) -> int:
	var flown := 0
	for row: int in rows.table.size():
		var world := _world(rows, row)
		if not world:
			continue
		flown += 1
		var impact := FrictionImpact.new()
		impact.hit = world.events.size() > 0
		# An event does not tell these two; the velocity and the spin after it do.
		impact.regime = int(rows.table.at(row, "regime")) as Friction.Regime
		impact.feature = int(rows.table.at(row, "feature")) - 1 as Impact.Feature
		impact.velocity = world.velocity(0)
		impact.spin = world.spin(0)
		if impact.hit:
			var event := world.events[0]
			impact.time = event.time
			impact.normal = event.normal
			impact.velocity = event.velocity_after
			impact.spin = event.spin_after
		var relative := rows.ball(row).velocity.minus(rows.segment_velocity(row)).length()
		if rows.table.has("turn"):
			var pivot := rows.table.vector(row, "cx", "cy")
			var reach := TurningSegment.new(rows.segment(row), pivot, 1.0).reach()
			relative += absf(rows.table.at(row, "turn")) * reach
		rows.judge(row, impact, relative)
	return flown


func _assert_right(rows: FrictionRows) -> void:
	gut.p("worst errors: %s" % rows.worst)
	assert_eq(rows.wrong, PackedInt32Array())
	assert_all_at_most(rows.worst.values(), _BAR, str(rows.worst))


func test_impacts_of_two_balls() -> void:
	var table := MotionTable.new("ball_ball_friction")
	var worst := WorstErrors.new()
	var wrong: PackedInt32Array = []
	for row: int in table.size():
		var world := EventWorld.new()
		world.keeps_events = true
		assert_no_refusal(world.set_bounciness(table.at(row, "restitution")))
		assert_no_refusal(world.set_friction(table.at(row, "friction")))
		assert_no_refusal(world.set_balls([_ball(table, row, "1"), _ball(table, row, "2")]))
		assert_no_refusal(world.advance_to(_longest(table, row)))
		if (world.events.size() > 0) != table.is_hit(row):
			wrong.append(row)
			continue
		for number: int in 2:
			var event := world.events[number] if world.events else null
			var velocity := event.velocity_after if event else world.velocity(number)
			var spin := event.spin_after if event else world.spin(number)
			_judge(table, row, str(number + 1), velocity, spin, worst)
	gut.p("worst errors of %d rows of two balls: %s" % [table.size(), worst])
	assert_eq(wrong, PackedInt32Array())
	assert_all_at_most(worst.values(), _BAR, str(worst))


func _judge(
	table: MotionTable, row: int, number: String, velocity: Vec2, spin: float, worst: WorstErrors
) -> void:
	var wanted := table.vector(row, "v%sx_after" % number, "v%sy_after" % number)
	var error := table.velocity_error(row, velocity, wanted, "condition_v" + number)
	worst.note(table.family(row), error)
	error = table.error(row, spin, "spin%s_after" % number, "condition_spin" + number)
	worst.note(table.family(row), error)


# The world a little after the impact; null where its numbers are beyond the limits of a world.
func _world(rows: FrictionRows, row: int) -> EventWorld:
	var world := EventWorld.new()
	world.keeps_events = true
	assert_no_refusal(world.set_bounciness(rows.bounciness(row)))
	assert_no_refusal(world.set_friction(rows.friction(row)))
	var longest := _longest(rows.table, row)
	if longest > WorldLimits.LARGEST or world.add_segment(rows.segment(row)):
		return null
	if rows.table.has("wx"):
		var motion := SegmentMotion.steady(rows.segment_velocity(row))
		if rows.table.has("turn"):
			var pivot := rows.table.vector(row, "cx", "cy")
			var turn := rows.table.at(row, "turn")
			motion = SegmentMotion.turning(pivot, turn, rows.segment_velocity(row))
		if world.set_segment_motion(0, motion):
			return null
	if world.add_ball(rows.ball(row)):
		return null
	assert_no_refusal(world.advance_to(longest))
	return world


# The time of the impact and what rounding may add to it.
func _longest(table: MotionTable, row: int) -> float:
	if not table.is_hit(row):
		return table.at(row, "t_max") if table.has("t_max") else 1e6
	return table.at(row, "t") + 8.0 * EPSILON * table.at(row, "condition") + 1e-300


func _ball(table: MotionTable, row: int, number: String) -> Ball:
	return Ball.new(
		table.vector(row, "p%sx" % number, "p%sy" % number),
		table.at(row, "r" + number),
		table.vector(row, "v%sx" % number, "v%sy" % number),
		table.at(row, "m" + number),
		table.at(row, "spin" + number)
	)
