extends LabTest
## A chain of lines is one surface: a ball slides and bounces over its joints in the event world and
## frame by frame, and is never stopped, thrown or let through.

## How many random chains are tried in each of the two.
const _CHAINS := 2000


func test_a_slow_ball_slides_over_a_joint_at_every_angle() -> void:
	for degrees: float in [1e-9, 1e-6, 1e-4, 0.01, 1.0, 9.926, 45.0, 89.0, 90.0, 120.0, 170.0]:
		for gap: float in [0.0, 1e-12, 1e-9, 1e-6, 1e-3]:
			var turned := Vec2.unit_radians(deg_to_rad(degrees)).scaled(300.0)
			var start := Vec2.new(gap, 0.0)
			var case := _case(
				[
					LineSegment.new(Vec2.new(-100, 0), Vec2.zero()),
					LineSegment.new(start, start.plus(turned))
				]
			)
			case.balls[0] = Ball.new(Vec2.new(-20, -10), 10.0, Vec2.new(20, 0))
			case.bounciness = 0.5
			var text := "%s degrees, gap %s" % [degrees, gap]
			assert_eq(ChainKind.new().problem_of(case), "", text)
			assert_gt(_at_end(case).position_x(0), -9.0, text)


func test_over_a_convex_joint_no_energy_is_lost_whatever_c_is() -> void:
	var case := _case(
		[
			LineSegment.new(Vec2.new(-100, 0), Vec2.zero()),
			LineSegment.new(Vec2.zero(), Vec2.new(200, 35)),
		]
	)
	case.balls[0] = Ball.new(Vec2.new(-20, -10), 10.0, Vec2.new(20, 0))
	case.bounciness = 0.5
	case.seconds = 3.0
	var end := _at_end(case)
	assert_gt(end.position_x(0), 100.0)
	var squared := 400.0 + 2.0 * RandomChain.GRAVITY * (end.position_y(0) + 10.0)
	assert_almost_eq(end.velocity(0).length_squared() / squared, 1.0, 1e-9)


func test_a_straight_line_of_two_pieces_is_as_one() -> void:
	var whole := LineSegment.new(Vec2.zero(), Vec2.new(60, 20))
	var joint := Vec2.new(30, 10)
	var pieces: Array[LineSegment] = [
		LineSegment.new(Vec2.zero(), joint), LineSegment.new(joint, Vec2.new(60, 20))
	]
	for bounciness: float in [0.0, 0.5, 1.0]:
		var one := _case([whole])
		var two := _case(pieces)
		for case: FuzzWorld in [one, two]:
			var along := whole.along().normalized()
			case.balls[0] = Ball.new(
				Vec2.new(15, 5).plus(Vec2.new(along.y, -along.x).scaled(10.0)), 10.0
			)
			case.bounciness = bounciness
			case.seconds = 0.8
		assert_vec2(_at_end(two).position(0), _at_end(one).position(0), 1e-9)


func test_a_ball_that_flies_off_uphill_comes_back_to_the_end() -> void:
	# v² is 1.1 times as much as the end can hold back: a tall, narrow flight back onto it.
	var up := Vec2.unit_radians(deg_to_rad(-60.0))
	var case := _case([LineSegment.new(up.scaled(-200.0), Vec2.zero())])
	var normal := Vec2.new(up.y, -up.x)
	var speed := sqrt(
		(
			1.1 * RandomChain.GRAVITY * 10.0 * 0.5
			+ 2.0 * RandomChain.GRAVITY * 20.0 * sin(deg_to_rad(60.0))
		)
	)
	case.balls[0] = Ball.new(normal.scaled(10.0).plus(up.scaled(-20.0)), 10.0, up.scaled(speed))
	for bounciness: float in [0.0, 0.5, 1.0]:
		case.bounciness = bounciness
		assert_eq(ChainKind.new().problem_of(case), "", "C = %s" % bounciness)


func test_a_fine_polygon_is_a_circle_to_first_order() -> void:
	var errors: PackedFloat64Array = []
	for pieces: int in [90, 180, 360]:
		var case := _case(_circle(pieces, 200.0))
		# From rest, 60 degrees from the lowest point of a circle of 190 px for the ball's centre.
		case.balls[0] = Ball.new(Vec2.new(-sin(PI / 3.0), cos(PI / 3.0)).scaled(189.9), 10.0)
		case.bounciness = 0.5
		var flight := case.event_world()
		while flight.position_x(0) < 0.0 and flight.time < 5.0:
			assert_no_refusal(flight.advance(0.001))
		var wanted := sqrt(2.0 * RandomChain.GRAVITY * 190.0 * 0.5)
		errors.append(absf(flight.velocity(0).length() / wanted - 1.0))
	for i: int in errors.size():
		assert_lt(errors[i], 2.0 * TAU / (90.0 * 2.0 ** i))
	assert_lt(errors[2], 0.7 * errors[0])


func test_random_chains_hold_in_the_event_world(
	shape: int = use_parameters(RandomChain.Shape.values())
) -> void:
	_assert_chains(shape, ChainKind.new())


func test_random_chains_hold_frame_by_frame(
	shape: int = use_parameters(RandomChain.Shape.values())
) -> void:
	_assert_chains(shape, SteppedChainKind.new(SteppingMethods.Method.WHOLE_FRAME))


func _assert_chains(shape: int, kind: FuzzKind) -> void:
	var problems: PackedStringArray = []
	for number: int in range(shape, _CHAINS, RandomChain.Shape.size()):
		var world := kind.world_of(number)
		var problem := kind.problem_of(world)
		if problem:
			problems.append("%d: %s %s" % [number, problem, world.text()])
	assert_eq(problems, PackedStringArray())


# A chain under gravity; the ball is still to come to its place.
func _case(lines: Array[LineSegment]) -> FuzzWorld:
	var made := FuzzWorld.new()
	made.gravity = Vec2.new(0.0, RandomChain.GRAVITY)
	made.lines = lines
	made.balls = [Ball.new(Vec2.zero(), 1.0)]
	return made


func _at_end(case: FuzzWorld) -> EventWorld:
	var made := case.event_world()
	assert_no_refusal(made.advance(case.seconds))
	return made


func _circle(pieces: int, radius: float) -> Array[LineSegment]:
	var lines: Array[LineSegment] = []
	for piece: int in pieces:
		var one := Vec2.unit_radians(TAU * piece / pieces).scaled(radius)
		var other := Vec2.unit_radians(TAU * ((piece + 1) % pieces) / pieces).scaled(radius)
		lines.append(LineSegment.new(one, other))
	return lines
