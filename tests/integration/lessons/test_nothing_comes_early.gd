extends ScreenTest
## The question stands before the answer: no lesson shows a card, a table or a part of the drawing
## before the step that introduces it, and none of them while that step is still asked for.

const _TABLE := "the table"

## The first step, counted from 0, that shows each of these, by their names in the scene. A lesson
## whose answers are elsewhere has its own test beside it.
const _FIRST_SEEN: Dictionary[StringName, Dictionary] = {
	&"class_or_value": {"Old": 1, "OldValue": 1, _TABLE: 3},
	&"easy_bounce":
	{"Shortest": 1, "Verdict": 1, _TABLE: 1, "RightBall": 2, "RightArrow": 2, "RightPath": 4},
	&"normals": {"Normal": 1, "Verdict": 1, "Opposite": 2, "Unit": 3, _TABLE: 3, "Scaled": 4},
	&"dot_product":
	{
		"Unit": 1,
		"HeadDrop": 2,
		"Angle": 2,
		"Verdict": 2,
		"Light": 2,
		"Projection": 3,
		"Rejection": 4,
		"Ruler": 5,
		"OtherProjection": 6,
		"Plot": 7,
		"Alpha": 8,
		_TABLE: 8,
	},
	&"projection_proof":
	{"HeadTurnedA": 1, "HeadTurnedB": 1, "P": 1, "ShadowOfX": 3, "Verdict": 6, _TABLE: 6},
	&"line_distance":
	{"Normal": 1, "Rejection": 2, "Shadow": 2, _TABLE: 2, "Gap": 3, "Verdict": 3, "Frames": 5},
	&"point_of_impact":
	{
		"Normal": 1,
		"Reset": 1,
		"ResetName": 1,
		"OldDistance": 2,
		"A": 3,
		"B": 3,
		"Verdict": 4,
		"Impact": 5,
		"ImpactName": 5,
		_TABLE: 5,
	},
	&"reflection":
	{
		"Velocity": 1,
		"Part": 1,
		"First": 2,
		"Slide": 2,
		"Verdict": 2,
		"Second": 3,
		"Leaving": 3,
		"AngleOut": 3,
		"Table": 4,
		_TABLE: 4,
	},
	&"angled_lines": {"Impact": 1, "Normal": 1, _TABLE: 2},
	&"line_ends":
	{"InfiniteTwoSided": 1, "SegmentOneSided": 2, "RoundCaps": 3, "Graph": 4, _TABLE: 5},
	&"more_dimensions": {"Stairs": 1, "Shadow": 3, "VerdictCard": 3, _TABLE: 4},
	&"error_and_time": {_TABLE: 1},
	&"aim_at":
	{
		"FallingWay": 1,
		"Sight": 2,
		"Theta": 2,
		_TABLE: 2,
		"Own": 3,
		"AimedBarrel": 3,
		"Verdict": 3,
		"Delta": 4,
		"EarlyWay": 5,
		"EarlyMiss": 5,
		"RightWay": 6,
	},
	&"newton_balls":
	{
		"Ghost1": 1,
		"Coming1": 1,
		"Center": 2,
		"Verdict": 2,
		"Leaving1": 3,
		"Push1": 4,
		"After1": 5,
		_TABLE: 5,
	},
	&"lead_target":
	{
		"Way": 1,
		"OneSecond": 2,
		"Reach": 3,
		"Graph": 3,
		"Sum": 3,
		"Meeting": 3,
		"Verdict": 3,
		_TABLE: 3,
		"Aimed": 4,
		"RightWay": 4,
	},
	&"ballistic_aim":
	{"Drop": 1, "Verdict": 2, "Arc1": 3, "Arc2": 3, "Aim": 3, _TABLE: 3, "Envelope": 4, "Least": 4},
	&"timed_shot": {"Cross": 1, "Verdict": 2, "Waiting": 2, _TABLE: 2},
	&"bank_shot":
	{
		"Moved1": 1,
		"Normal1": 1,
		"Image1": 2,
		"Mirror1": 2,
		"Depth": 2,
		"Straight1": 3,
		"Bounce1": 3,
		"Path": 3,
		"Verdict": 3,
		_TABLE: 3,
		"Orders": 4,
	},
	&"slide_and_roll":
	{
		"Pull": 1,
		"Card": 2,
		"Friction": 2,
		"Verdict": 4,
		"SlideBall": 5,
		"RollBall": 5,
		"Finish": 5,
		_TABLE: 5,
	},
	&"collision_friction":
	{
		"Slip": 1,
		"Push": 2,
		"Cone": 3,
		"ConeHandle": 3,
		"Impulse": 3,
		"Verdict": 3,
		"After": 4,
		_TABLE: 4,
		"Ledger": 5,
		"Path": 6,
	},
	&"moving_platforms":
	{
		"Seen": 1,
		"SurfaceThen": 1,
		"Normal": 2,
		"Bounced": 2,
		"Leaving": 3,
		"Added": 3,
		"Verdict": 3,
		_TABLE: 4,
	},
}


func test_each_part_is_first_seen_at_its_step() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		assert_has(_FIRST_SEEN, lesson.id, "say in _FIRST_SEEN what %s shows when" % lesson.id)
		await open_lesson(lesson)
		var wanted: Dictionary = _FIRST_SEEN.get(lesson.id, {})
		var last: int = wanted.values().max()
		for step: int in last + 1:
			await _go_on_to(step)
			for part: String in wanted:
				var first: int = wanted[part]
				if step <= first:
					var text := "%s of %s at step %d" % [part, lesson.id, step + 1]
					assert_eq(_is_seen(part), step == first, text)
		screen().free()


# Forward as a student goes: where the step is asked for first, nothing of it may be seen.
func _go_on_to(step: int) -> void:
	if step == 0:
		return
	await student.press(&"lab_next_step")
	if frame().lesson.step == step:
		return
	var wanted: Dictionary = _FIRST_SEEN[frame().lesson_info.id]
	for part: String in wanted:
		if wanted[part] == step:
			var text := "%s of %s while it is asked for" % [part, frame().lesson_info.id]
			assert_false(_is_seen(part), text)
	await student.press(&"lab_next_step")
	assert_eq(frame().lesson.step, step)


func _is_seen(part: String) -> bool:
	if part == _TABLE:
		return frame().lesson.services[&"readout"].is_visible_in_tree()
	return (frame().lesson.get_node("%" + part) as CanvasItem).is_visible_in_tree()
