extends ScreenTest
## The editor shows a lesson's board as the lesson starts, and what is moved there moves in the
## lesson.

const SceneStart := preload("res://tools/draw/scene_start.gd")

## For each lesson a property in its scene that sets how it starts, and another value for it.
const _STARTS: Dictionary[StringName, Array] = {
	&"class_or_value": ["Board/Position:head", Vector2(-5.0, 1.0)],
	&"easy_bounce": ["Board/Drawing/BallHandle:point", Vector2(12.0, -60.0)],
	&"normals": ["Board/Drawing/V:head", Vector2(2.0, 2.0)],
	&"dot_product": ["Board/Drawing/B:head", Vector2(-3.0, 4.0)],
	&"projection_proof": ["Board/Drawing/HeadA:point", Vector2(5.0, 1.0)],
	&"line_distance": ["Board/Drawing/Ball:center", Vector2(10.0, -80.0)],
	&"point_of_impact": ["Board/Drawing/Line:head", Vector2(-80.0, -45.0)],
	&"reflection": ["Board/Drawing/VelocityHead:point", Vector2(2.0, 3.0)],
	&"angled_lines": ["Board/Gravity:gravity", Vector2(100.0, 0.0)],
	&"line_ends": ["Board/Shot:head", Vector2(1.0, 8.0), "line_ends_field.tscn"],
	&"more_dimensions": ["Board/Bars:a", [1.0, 2.0, 3.0, 4.0]],
	&"error_and_time": [".:first_problem", "dropped_ball"],
	&"aim_at": ["Board/Drawing/Mark:center", Vector2(60.0, 50.0)],
	&"lead_target": ["Board/Drawing/Velocity:head", Vector2(150.0, 0.0)],
	&"ballistic_aim": ["Board/Drawing/TargetHandle:point", Vector2(100.0, -20.0)],
	&"timed_shot": ["Board/Drawing/Start:point", Vector2(-200.0, -50.0)],
	&"bank_shot": ["Board/Drawing/Wall1:head", Vector2(480.0, 280.0)],
	&"newton_balls": ["Board/Drawing/Ball1:head", Vector2(-2.0, -2.0)],
	&"slide_and_roll": ["Board/Drawing/Line:tail", Vector2(-60.0, -40.0)],
	&"collision_friction": ["Board/Drawing/VelocityHandle:point", Vector2(-40.0, -100.0)],
	&"moving_platforms": ["Board/Drawing/VelocityHead:point", Vector2(120.0, -40.0)],
	&"smallest_lesson": ["Board/V:head", Vector2(1.0, 1.0)],
}


func test_every_scene_shows_what_its_lesson_shows_at_the_start() -> void:
	for lesson: LessonInfo in _lessons():
		await open_lesson(lesson)
		var scene := (load(lesson.scene_path()) as PackedScene).instantiate()
		var hint := "run: godot --headless --path . -s tools/draw/lay_scenes.gd -- " + lesson.id
		assert_eq(SceneStart.differences(frame().lesson, scene), PackedStringArray(), hint)
		scene.free()
		screen().free()


func test_a_part_that_is_moved_in_a_scene_is_moved_in_the_lesson() -> void:
	for lesson: LessonInfo in _lessons():
		assert_has(_STARTS, lesson.id, "say in _STARTS what moves %s" % lesson.id)
		if not _STARTS.has(lesson.id):
			continue
		await open_lesson(lesson)
		var start := frame().lesson.state()
		screen().free()
		var start_of: Array = _STARTS[lesson.id]
		assert_ne(await _state_with(lesson, start_of), start, lesson.id)


func _lessons() -> Array[LessonInfo]:
	return LessonIndex.lessons() + ([LessonIndex.find(&"smallest_lesson")] as Array[LessonInfo])


# The state at the start if a scene's file had another value: [node and property, value, the scene].
func _state_with(lesson: LessonInfo, start: Array) -> Dictionary:
	var path: String = start[0]
	var file := lesson.scene_path()
	if start.size() > 2:
		var part: String = start[2]
		file = lesson.scene_path().get_base_dir().path_join(part)
	var original := load(file) as PackedScene
	var scene := original.instantiate(PackedScene.GEN_EDIT_STATE_MAIN)
	scene.get_node(path.get_slice(":", 0)).set(path.get_slice(":", 1), start[1])
	var edited := PackedScene.new()
	edited.pack(scene)
	scene.free()
	edited.take_over_path(file)
	await open_lesson(lesson)
	var state := frame().lesson.state()
	screen().free()
	original.take_over_path(file)
	return state
