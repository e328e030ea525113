extends LabTest
## The probes tell the wrong ways of a method apart, from each other and from the right one.


func test_no_wrong_way_agrees_with_the_right_one() -> void:
	for task in WorkshopIndex.tasks():
		for way in _ways(task):
			assert_false(_agree(task, way, null), "%s: %s" % [task.method, way.sentence])


func test_no_two_wrong_ways_with_different_sentences_agree() -> void:
	for task in WorkshopIndex.tasks():
		var ways := _ways(task)
		for index in ways.size():
			for other in index:
				if ways[index].sentence != ways[other].sentence:
					var told := "%s | %s" % [ways[index].sentence, ways[other].sentence]
					assert_false(_agree(task, ways[index], ways[other]), told)


func test_ways_that_agree_are_found() -> void:
	var task := WorkshopIndex.task("dot")
	var minus := task.ways[3]
	assert_true(_agree(task, minus, minus))
	var right := WorkshopWay.new(0, "right", _right_dot)
	assert_true(_agree(task, right, null))


func test_every_method_has_probes_and_a_right_answer_to_each() -> void:
	assert_eq(WorkshopIndex.tasks().size(), 20)
	for task in WorkshopIndex.tasks():
		assert_gt(task.probes.size(), 2, task.method)
		for probe in task.probes:
			var right := WorkshopCall.right_answer(task, probe)
			assert_gt(right.size(), 0, task.method)
			for number in right:
				assert_false(is_nan(number), "%s: %s" % [task.method, probe.title])


func test_the_mistakes_of_the_course_are_named_where_they_belong() -> void:
	var wanted: Dictionary[int, Array] = {
		0: [1, 2, 3, 4],
		1: [6, 7, 8],
		2: [6, 7, 8, 9],
		3: [8, 10],
		4: [10],
		5: [9, 10, 16],
		6: [16],
		7: [-2, 32],
		8: [15, 16, 17, 20],
		9: [1, 8, 11, 12, 13],
		10: [14, 21, 24, 26],
		11: [18, 19, 22, 23],
	}
	for number in wanted:
		var named: Array[int] = []
		for task in WorkshopIndex.exercise(number).tasks:
			for way in task.ways:
				named.append(way.number)
		for mistake: int in wanted[number]:
			assert_has(named, mistake, "exercise %d" % number)


func _right_dot(n: PackedFloat64Array) -> PackedFloat64Array:
	return [n[0] * n[2] + n[1] * n[3]]


func _ways(task: WorkshopTask) -> Array[WorkshopWay]:
	return task.ways.filter(
		func(way: WorkshopWay) -> bool: return not way.spoils_inputs and not way.is_extra
	)


# Whether a way cannot be told from another one, or from the right one, where both say something.
func _agree(task: WorkshopTask, way: WorkshopWay, other: WorkshopWay) -> bool:
	for probe in task.probes:
		if not WorkshopTaskJudge.is_compared(way, probe):
			continue
		if other and not WorkshopTaskJudge.is_compared(other, probe):
			continue
		var wanted := WorkshopCall.right_answer(task, probe)
		if other:
			wanted = WorkshopTaskJudge.answer_of(other, probe)
		if not probe.agrees(WorkshopTaskJudge.answer_of(way, probe), wanted):
			return false
	return true


func test_the_answers_to_the_probes_of_aiming_hit() -> void:
	for task in WorkshopIndex.exercise(15).tasks:
		for probe in task.probes:
			var n := probe.numbers
			var is_twice := task.method == "bank_twice"
			var walls: Array[LineSegment] = [_line(n, 5 if is_twice else 6)]
			if is_twice:
				walls.append(_line(n, 9))
			var way := BankAim.first(
				Vec2.new(n[0], n[1]),
				Vec2.new(n[2], n[3]),
				n[4],
				1.0 if is_twice else n[5],
				walls,
				walls.size()
			)
			var direction := WorkshopCall.right_answer(task, probe)
			assert_vec2(way.direction, Vec2.new(direction[0], direction[1]), 1e-12, probe.title)
			assert_eq(way.walls, PackedInt32Array(range(walls.size())), probe.title)


func _line(n: PackedFloat64Array, at: int) -> LineSegment:
	return LineSegment.new(Vec2.new(n[at], n[at + 1]), Vec2.new(n[at + 2], n[at + 3]))
