extends ScreenTest
## The editor shows a lesson's board as the lesson starts, and what is moved there moves in the
## lesson.

const SceneStart := preload("res://tools/draw/scene_start.gd")


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
		var moved: PackedStringArray = []
		await open_lesson(lesson)
		var start := frame().lesson.state()
		screen().free()
		for path: NodePath in _movable_parts(lesson):
			if await _state_with_moved(lesson, path) != start:
				moved.append(str(path))
		assert_gt(moved.size(), 0, lesson.id)


func _lessons() -> Array[LessonInfo]:
	return LessonIndex.lessons() + ([LessonIndex.find(&"smallest_lesson")] as Array[LessonInfo])


# The parts of the scene that a student can move, with the property that says where they are.
func _movable_parts(lesson: LessonInfo) -> Array[NodePath]:
	var found: Array[NodePath] = []
	var scene := (load(lesson.scene_path()) as PackedScene).instantiate()
	for node: Node in scene.find_children("*"):
		var property := ""
		if node is DraggableVector:
			property = ":head"
		elif node is Handle:
			property = ":point"
		elif node is BallView:
			property = ":center"
		if property and node.owner == scene:
			found.append(NodePath(str(scene.get_path_to(node)) + property))
	scene.free()
	return found


# The state at the start if the file had the part elsewhere.
func _state_with_moved(lesson: LessonInfo, path: NodePath) -> Dictionary:
	var original := load(lesson.scene_path()) as PackedScene
	var scene := original.instantiate(PackedScene.GEN_EDIT_STATE_MAIN)
	var part := scene.get_node(NodePath(path.get_concatenated_names()))
	var property := path.get_subname(0)
	var place: Vector2 = part.get(property)
	part.set(property, place + Vector2(1.0, -2.0))
	var edited := PackedScene.new()
	edited.pack(scene)
	scene.free()
	edited.take_over_path(lesson.scene_path())
	await open_lesson(lesson)
	var state := frame().lesson.state()
	screen().free()
	original.take_over_path(lesson.scene_path())
	return state
