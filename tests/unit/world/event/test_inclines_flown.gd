extends LabTest
## Balls that slide and roll along a line in the event world, from event to event, against the same
## reference table as [Incline].

const _BAR := 4.0
# Far from the origin a ball cannot be put exactly on a line: it first falls by up to 1e-7 px.
const _FAR_BAR := 64.0

var _table := MotionTable.new("incline")


func test_every_row_is_flown_to_the_last_bits() -> void:
	var worst := WorstErrors.new()
	var worst_far := WorstErrors.new()
	var wrong: PackedInt32Array = []
	var flown := 0
	for row: int in _table.size():
		flown += 1
		var is_far := _table.family(row) == "far-from-origin"
		_fly(row, worst_far if is_far else worst, wrong)
	gut.p("worst errors of %d rows: %s, %s" % [flown, worst, worst_far])
	assert_eq(wrong, PackedInt32Array())
	assert_all_at_most(worst.values(), _BAR, str(worst))
	assert_all_at_most(worst_far.values(), _FAR_BAR, str(worst_far))


func _fly(row: int, worst: WorstErrors, wrong: PackedInt32Array) -> void:
	var world := _world(row)
	world.keeps_events = true
	assert_no_refusal(world.advance_to(0.0))
	var roll_time := 0.0 if world.is_rolling(0) else -1.0
	assert_no_refusal(world.advance_to(_table.at(row, "t_max")))
	var leave: WorldEvent = null
	for event: WorldEvent in world.events:
		if event.kind == WorldEvent.Kind.LEAVE and not leave:
			leave = event
		elif event.kind == WorldEvent.Kind.SLIP_ENDS and not leave and _can_hold(row):
			roll_time = event.time
	var family := _table.family(row)
	var is_left := leave != null
	if is_left != (_table.at(row, "leaves") != 0.0):
		wrong.append(row)
		return
	if (roll_time >= 0.0) != (_table.at(row, "t_roll") >= 0.0):
		wrong.append(row)
		return
	var start := _table.vector(row, "ax", "ay")
	var along := _table.vector(row, "bx", "by").minus(start).normalized()
	var velocity := leave.velocity_before if leave else world.velocity(0)
	var spin := leave.spin_before if leave else world.spin(0)
	worst.note(family, _table.error(row, leave.time if leave else world.time, "t"))
	worst.note(family, _table.error(row, velocity.dot(along), "v", "condition_v"))
	worst.note(family, _table.error(row, spin, "spin", "condition_spin"))
	worst.note(family, _table.error(row, roll_time, "t_roll", "condition_roll"))
	if not leave:
		var distance := world.position(0).minus(start).dot(along)
		worst.note(family, _table.error(row, distance, "x", "condition_x"))


func _can_hold(row: int) -> bool:
	var segment := LineSegment.new(_table.vector(row, "ax", "ay"), _table.vector(row, "bx", "by"))
	return (
		Incline.new(segment, _table.vector(row, "gx", "gy"), _table.at(row, "friction")).can_hold()
	)


func _world(row: int) -> EventWorld:
	var segment := LineSegment.new(_table.vector(row, "ax", "ay"), _table.vector(row, "bx", "by"))
	var gravity := _table.vector(row, "gx", "gy")
	var along := segment.along().normalized()
	var normal := segment.normal()
	if normal.dot(gravity) > 0.0:
		normal = normal.negated()
	var place := segment.start.plus(along.scaled(_table.at(row, "x0")))
	place.add(normal.scaled(_table.at(row, "r")))
	var ball := Ball.new(place, _table.at(row, "r"), along.scaled(_table.at(row, "v0")))
	ball.spin = _table.at(row, "spin0")
	var world := EventWorld.new()
	assert_no_refusal(world.set_gravity(gravity))
	assert_no_refusal(world.set_bounciness(0.0))
	assert_no_refusal(world.set_friction(_table.at(row, "friction")))
	assert_no_refusal(world.add_segment(segment))
	assert_no_refusal(world.set_belt_speed(0, _table.at(row, "belt")))
	assert_no_refusal(world.add_ball(ball))
	return world
