extends ScreenTest
## What a lesson does when its scene has impossible values.


func test_a_radius_below_0_in_the_scene_is_an_error() -> void:
	_start(&"line_distance", "Board/Drawing/Ball", &"radius", -1.0)
	assert_push_error("radius must be above 0")


func test_a_line_without_length_in_the_scene_is_an_error() -> void:
	_start(&"point_of_impact", "Board/Drawing/Line", &"head", Vector2(60, 45))
	assert_push_error("longer than 0")


func test_a_line_without_direction_in_the_scene_is_an_error() -> void:
	_start(&"reflection", "Board/Drawing/LineEnd", &"point", Vector2.ZERO)
	assert_push_error("no direction")


func test_a_component_out_of_range_in_the_scene_is_an_error() -> void:
	_start(&"more_dimensions", "Board/Bars", &"a", PackedFloat64Array([1, 1e9, 0, 0]))
	assert_push_error("1e9 cannot be")


func _start(id: StringName, node: NodePath, property: StringName, value: Variant) -> void:
	var info := LessonIndex.find(id)
	var lesson := (load(info.scene_path()) as PackedScene).instantiate() as Lesson
	lesson.get_node(node).set(property, value)
	for need in info.needs:
		var service := (load(LessonFrame.SERVICE_SCENE % need) as PackedScene).instantiate()
		lesson.services[StringName(need)] = service as Control
		add_child_autofree(service)
	add_child_autofree(lesson)
	lesson.start()
