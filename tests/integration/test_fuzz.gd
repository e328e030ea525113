extends ScreenTest
## Random worlds of every kind hold; one that does not is found and made small. More of them are
## tried by `./lab stability --fuzz`.

# Pixels; the walls of a planted world.
const _FAR := 500.0


## A kind with a planted fault: a line that goes up at a right angle, together with a ball that is
## larger than 5 px and is changed.
class PlantedKind:
	extends FuzzKind

	func world_of(number: int) -> FuzzWorld:
		return RandomEdits.world_of(number)

	func problem_of(world: FuzzWorld) -> String:
		var is_changed := false
		for edit: FuzzEdit in world.edits:
			if edit.kind == FuzzEdit.Kind.CHANGE_BALL and edit.place < world.balls.size():
				is_changed = is_changed or world.balls[edit.place].radius > 5.0
		for line: LineSegment in world.lines:
			if is_changed and line.start.x == line.end.x:
				return "The line at x = %s goes straight up." % line.start.x
		return ""


func test_random_worlds_of_each_kind_hold(
	row: Array = use_parameters(
		[
			["chains_position_reset", 120],
			["chains_point_of_impact", 120],
			["edits", 150],
			["fast_paths", 250],
			["piles", 40],
			["friction", 200],
			["moving", 60]
		]
	)
) -> void:
	var kind_name: String = row[0]
	var count: int = row[1]
	var problems: PackedStringArray = []
	for kind: FuzzKind in FuzzRun.all_kinds():
		for number: int in count if kind.name == kind_name else 0:
			var world := kind.world_of(number)
			var problem := kind.problem_of(world)
			if problem:
				problems.append("%d: %s\n%s" % [number, problem, world.text()])
	assert_eq(problems, PackedStringArray())


func test_the_same_number_makes_the_same_world_and_judging_changes_nothing_in_it() -> void:
	for kind: FuzzKind in FuzzRun.all_kinds():
		var world := kind.world_of(7)
		assert_eq(world.text(), kind.world_of(7).text(), kind.name)
		assert_eq(world.text(), world.copy().text(), kind.name)
		assert_ne(world.text(), kind.world_of(8).text(), kind.name)
		assert_eq(kind.problem_of(world), kind.problem_of(world), kind.name)
		assert_eq(world.text(), kind.world_of(7).text(), kind.name)


func test_a_planted_fault_shrinks_to_the_fewest() -> void:
	var world := _crowd()
	var kind := PlantedKind.new()
	assert_ne(kind.problem_of(world), "")
	var small := FuzzShrinker.smallest(kind, world)
	assert_ne(kind.problem_of(small), "")
	assert_eq(small.lines.size(), 1)
	assert_eq(small.balls.size(), 1)
	assert_eq(small.edits.size(), 1)
	assert_eq(small.edits[0].place, 0, "the only ball")
	assert_eq(small.walls.size(), 0)
	assert_eq(small.lines[0].start.x, 0.0, "the roundest number")
	assert_eq(_crowd().text(), world.text(), "the first world is as it was")


func test_a_world_without_a_fault_stays_as_it_is() -> void:
	var world := RandomChain.world_of(5)
	assert_eq(FuzzShrinker.smallest(ChainKind.new(), world).text(), world.text())


func test_what_is_added_by_an_edit_that_is_left_out_is_not_named_any_more() -> void:
	var world := _crowd()
	var small := FuzzShrinker.smallest(PlantedKind.new(), world)
	for edit: FuzzEdit in small.edits:
		assert_false(edit.names_line(), edit.text())


func test_time_that_stands_still_is_found() -> void:
	var world := FuzzWorld.new()
	world.lines = [
		LineSegment.new(Vec2.new(-10, 0), Vec2.new(10, 0)),
		LineSegment.new(Vec2.new(-10, 20), Vec2.new(10, 20))
	]
	# It touches both, and goes on between them for ever.
	world.balls = [Ball.new(Vec2.new(0, 10), 10.0, Vec2.new(0, 1))]
	var flight := world.event_world()
	assert_string_starts_with(flight.fly_to(1.0), "Time stands still at ")
	assert_true(flight.stands_still)


func test_a_ball_has_room_above_a_line_and_none_between_two() -> void:
	var world := FuzzWorld.new()
	world.lines = [LineSegment.new(Vec2.new(-50, 0), Vec2.new(50, 0))]
	world.balls = [Ball.new(Vec2.new(0, -9), 10.0)]
	assert_true(InsideCheck.has_room(world.event_world(), 0))
	world.lines.append(LineSegment.new(Vec2.new(-50, -15), Vec2.new(50, -15)))
	assert_false(InsideCheck.has_room(world.event_world(), 0))


func test_balls_are_jammed_only_where_lines_press_them_into_each_other() -> void:
	var world := FuzzWorld.new()
	world.balls = [Ball.new(Vec2.new(0, -10), 10.0), Ball.new(Vec2.new(0, -24), 10.0)]
	world.lines = [LineSegment.new(Vec2.new(-50, 0), Vec2.new(50, 0))]
	assert_eq(InsideCheck.jammed(world.event_world()), PackedInt32Array())
	world.lines.append(LineSegment.new(Vec2.new(-50, -34), Vec2.new(50, -34)))
	world.balls[1].position.x = 2.0
	assert_eq(InsideCheck.jammed(world.event_world()), PackedInt32Array(), "they part sideways")
	for x: float in [-10.0, 12.0]:
		world.lines.append(LineSegment.new(Vec2.new(x, -50), Vec2.new(x, 50)))
	assert_eq(InsideCheck.jammed(world.event_world()), PackedInt32Array([1, 0]))


func test_the_link_that_is_printed_opens_in_the_lesson() -> void:
	var world := RandomChain.world_of(3)
	for method: SteppingMethods.Method in SteppingMethods.Method.values():
		LessonRequest.ask(world.link(method))
		await open_lesson(LessonIndex.find(&"angled_lines"))
		assert_false((frame().get_node("%Notice") as Label).text.contains("cannot"))
		var state := frame().lesson.link_state()
		var word: String = state["method"]
		assert_eq(word, AngledLinesLink.METHODS[method])
		var balls: Array[PackedFloat64Array] = state["balls"]
		var lines: Array[PackedFloat64Array] = state["lines"]
		assert_eq(balls[0][0], world.balls[0].position.x)
		assert_eq(lines.size(), world.lines.size())
		assert_eq(lines[1], FuzzWorld.numbers_of_line(world.lines[1]))
		screen().free()
	LessonRequest.ask("")


func test_what_the_lesson_cannot_show_has_no_link() -> void:
	var world := RandomChain.world_of(3)
	assert_ne(world.link(), "")
	var edited := world.copy()
	edited.edits = [FuzzEdit.of(FuzzEdit.Kind.REMOVE_BALL, 0.0)]
	var two := world.copy()
	two.balls.append(Ball.new(Vec2.zero(), 1.0))
	var far := world.copy()
	far.balls[0].position.x = 1e4
	var walled := world.copy()
	walled.walls = [Vec2.zero(), Vec2.new(1, 1)]
	for other: FuzzWorld in [edited, two, far, walled]:
		assert_eq(other.link(), "")


func test_a_run_counts_what_it_finds_and_tells_it_as_an_issue() -> void:
	var kinds: Array[FuzzKind] = [PlantedKind.new()]
	kinds[0].name = "planted"
	var run := FuzzRun.new(kinds, 1)
	assert_eq(run.next_number(), FuzzRun.NUMBERS_PER_SEED)
	assert_null(run.try_next(), "random lines do not go straight up")
	assert_eq(run.next_number(), FuzzRun.NUMBERS_PER_SEED + 1)
	assert_eq(run.count(), 0)
	var text := FuzzFind.new(kinds[0], 12, _crowd()).text()
	assert_string_starts_with(text, "## planted 12: The line at x = ")
	assert_string_contains(text, _crowd().text())


# Three lines, three balls, walls and four edits, most of which have nothing to do with the fault.
func _crowd() -> FuzzWorld:
	var world := FuzzWorld.new()
	world.walls = [Vec2.new(-_FAR, -_FAR), Vec2.new(_FAR, _FAR)]
	for place: int in 3:
		var start := Vec2.new(60.125 * place, 17.0)
		world.lines.append(LineSegment.new(start, start.plus(Vec2.new(50.0 - 25.0 * place, 40.0))))
		world.balls.append(Ball.new(Vec2.new(60.125 * place, -30.0), 4.0 + place))
	world.edits = [
		FuzzEdit.of(FuzzEdit.Kind.ADD_LINE, 0.1, [0.0, 90.0, 10.0, 91.0]),
		FuzzEdit.of(FuzzEdit.Kind.MOVE_LINE, 0.2, [0.0, 90.0, 10.0, 95.0], 3),
		FuzzEdit.of(FuzzEdit.Kind.CHANGE_BALL, 0.3, [0.0, 0.0, 1.5, 0.0, 0.0], 2),
		FuzzEdit.of(FuzzEdit.Kind.GRAVITY, 0.3, [0.0, 100.0]),
	]
	return world
