extends LabTest
## Random shots, flown in the event world, hit; and a dense search finds no earlier one. The command
## `./lab stability --fuzz 34 shots` tries more of them.


func test_random_shots_hit_and_none_is_earlier(
	row: Array = use_parameters(
		[
			["shots_lead", 500, 300],
			["shots_ballistic", 500, 700],
			["shots_moving", 300, 200],
			["shots_bank", 150, 60],
			["shots_timed_line", 400, 250],
			["shots_timed_circle", 500, 250],
			["shots_turning", 300, 290]
		]
	)
) -> void:
	var kind_name: String = row[0]
	var count: int = row[1]
	var least_flown: int = row[2]
	var kind := _kind(kind_name)
	var problems: PackedStringArray = []
	for number: int in count:
		var world := kind.world_of(number)
		var problem := kind.problem_of(world)
		if problem:
			problems.append("%d: %s\n%s" % [number, problem, world.text()])
	assert_eq(problems, PackedStringArray())
	assert_gt(kind.flown, least_flown)
	gut.p(kind.figures())


func test_a_miss_of_a_few_more_last_places_is_found() -> void:
	var kind := _kind("shots_lead")
	var miss := func(numbers: PackedFloat64Array) -> Vec2: return Vec2.new(numbers[0], 0.0)
	# The condition is 3 px.
	var most := ShotKind.MOST * 3.0 * EPSILON
	assert_eq(kind.problem_of_flight(Vec2.new(0.0, 0.9 * most), [3.0], miss), "")
	var found := kind.problem_of_flight(Vec2.new(0.0, 1.1 * most), [3.0], miss)
	assert_string_starts_with(found, "A shot misses by ")
	assert_ne(kind.problem_of_flight(Vec2.new(NAN, 0.0), [3.0], miss), "")
	assert_string_contains(kind.figures(), "0 asked, 3 shots flown")


func test_a_search_finds_the_zeros_of_a_function() -> void:
	var zeros := ShotKind.zeros(sin, ShotKind.moments(7.0))
	assert_eq(zeros.size(), 2)
	assert_almost_eq(zeros[0], PI, 1e-12)
	assert_almost_eq(zeros[1], TAU, 1e-12)


func test_a_ball_passes_a_target_on_one_side_or_the_other() -> void:
	var world := FuzzWorld.new()
	world.lines = [LineSegment.new(Vec2.new(-900, 100), Vec2.new(900, 100))]
	world.balls = [Ball.new(Vec2.zero(), 10.0), Ball.new(Vec2.new(180, 0), 1.0)]
	# The image is 180 px below: 45 degrees hit.
	var short_of := PassedTarget.of(world, PI / 4 + 0.1, 1)
	var beyond := PassedTarget.of(world, PI / 4 - 0.1, 1)
	assert_true(short_of.passes_otherwise(beyond))
	var right := PassedTarget.of(world, PI / 4, 1)
	assert_almost_eq(right.beside, 0.0, 1e-12)
	assert_almost_eq(right.distance, 180.0 * sqrt(2.0), 1e-9)
	assert_true(is_nan(PassedTarget.of(world, -PI / 4, 1).beside), "it does not bounce")
	assert_false(short_of.passes_otherwise(PassedTarget.of(world, -PI / 4, 1)))


func _kind(kind_name: String) -> ShotKind:
	for kind: FuzzKind in FuzzRun.all_kinds():
		if kind.name == kind_name:
			return kind as ShotKind
	return null
