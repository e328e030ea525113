extends LessonTest
## Drives what the event world adds to the lesson on angled lines: the timeline of impacts, by
## mouse, keys, buttons and gamepad, and Godot's own body on the same shot.


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"angled_lines"))


func test_the_timeline_is_there_in_the_event_world_only() -> void:
	assert_false(_card().visible)
	await _choose_event_world()
	assert_true(_card().visible)
	await student.press(&"lab_undo")
	assert_false(_card().visible)


func test_a_drag_along_the_timeline_scrubs() -> void:
	await _choose_event_world()
	await student.drag(_on_bar(0.0), _on_bar(4.0))
	assert_almost_eq(_timeline().time, 4.0, 0.05)
	assert_gt(_model().world.bounces, 0)
	await student.drag(_on_bar(4.0), _on_bar(0.5))
	assert_almost_eq(_timeline().time, 0.5, 0.05)
	assert_eq(_model().world.bounces, 0)


func test_arrow_keys_and_the_pad_move_along_the_timeline_that_has_the_focus() -> void:
	await _choose_event_world()
	_bar().grab_focus()
	for i: int in 5:
		await student.press(&"ui_right")
	assert_almost_eq(_timeline().time, 0.5, 1e-9)
	await student.press_pad(JOY_BUTTON_DPAD_LEFT)
	assert_almost_eq(_timeline().time, 0.4, 1e-9)
	assert_vec2(_model().world.surroundings.gravity, Vec2.new(0.0, 300.0), 0.0, "not gravity")
	await student.press(&"ui_home")
	assert_eq(_timeline().time, 0.0)


func test_i_goes_to_the_next_impact_and_shift_i_back() -> void:
	await _choose_event_world()
	var first := _timeline().impact_time(0, 1)
	await student.press(&"lab_next_impact")
	assert_eq(_timeline().time, first)
	assert_reads("bounces 1")
	await student.press(&"lab_next_impact")
	await student.press(&"lab_previous_impact")
	assert_eq(_timeline().time, first)


func test_the_buttons_go_to_impacts_too_and_pause() -> void:
	await _choose_event_world()
	await student.press(&"lab_pause")
	for i: int in 10:
		await get_tree().process_frame
	await click_button("To the next impact: I")
	assert_almost_eq(_timeline().impact_time(0, -1), -1.0, 0.0, "at the first impact")
	var there := _timeline().time
	await student.settle()
	assert_eq(_timeline().time, there)


func test_without_a_timeline_the_keys_of_impacts_do_nothing() -> void:
	var first := _model().world.state()
	await student.press(&"lab_next_impact")
	assert_eq(_model().world.state(), first)


func test_frames_and_scrubbing_lead_to_the_same_place() -> void:
	await _choose_event_world()
	for i: int in 6:
		await student.press(&"lab_next_frame")
	var there := _model().ball().position.copy()
	_bar().grab_focus()
	await student.press(&"ui_right")
	await student.press(&"ui_left")
	assert_vec2(_model().ball().position, there, 1e-9)


func test_all_balls_of_every_preset_play_in_the_event_world() -> void:
	await _choose_event_world()
	for preset: int in [3, 7, 8]:
		await student.press(StringName("lab_preset_%d" % preset))
		await student.press(&"lab_pause")
		for i: int in 30:
			await get_tree().process_frame
		await student.press(&"lab_pause")
		assert_gt(_model().world.frames, 20)
		assert_eq(_model().world.lost_count(), 0)


func test_the_comparison_has_the_event_world_as_its_fourth_row() -> void:
	assert_eq(readout_text(4, 0), "event world")
	assert_eq(readout_text(4, 1), "1")


func test_godots_body_exists_only_while_it_is_switched_on() -> void:
	assert_eq(_bodies(), 0)
	await click_button("Godot")
	assert_gt(_bodies(), 0)
	await student.press(&"lab_next_frame")
	assert_true(_engine().is_on())
	await click_button("Godot")
	assert_eq(_bodies(), 0)


func test_godots_body_flies_as_the_ball_does_and_parts_from_it_at_a_bounce() -> void:
	await click_button("Godot")
	assert_almost_eq(_gap(), 0.0, 1e-4)
	while _model().world.bounces == 0:
		assert_almost_eq(_gap(), 0.0, 1e-3)
		await student.press(&"lab_next_frame")
	for i: int in 60:
		await student.press(&"lab_next_frame")
	assert_gt(_gap(), 0.1)


func test_the_name_of_godots_body_and_where_it_parted_never_lie_on_one_another() -> void:
	await student.press(&"lab_gravity_left")
	await click_button("Godot")
	var closest := INF
	for i: int in 125:
		await student.press(&"lab_next_frame")
		if _gap() > 1.0:
			var way := (_engine().parting_place() - _engine().label_place()).abs()
			closest = minf(closest, way.y if way.x < 150.0 else INF)
	assert_between(closest, 18.0, 60.0)


func test_godots_body_starts_again_when_the_shot_changes() -> void:
	await click_button("Godot")
	for i: int in 60:
		await student.press(&"lab_next_frame")
	assert_gt(_gap(), 0.0)
	await student.press(&"lab_preset_6")
	assert_almost_eq(_gap(), 0.0, 1e-4)


func _model() -> AngledLinesModel:
	return frame().lesson.get(&"_model")


func _timeline() -> EventTimeline:
	return _model().timeline


func _card() -> TimelineCard:
	return frame().lesson.get_node("%TimelineCard") as TimelineCard


func _bar() -> TimelineBar:
	return _card().get_node("%Bar") as TimelineBar


func _engine() -> EngineLane:
	return frame().lesson.get_node("%Engine") as EngineLane


func _gap() -> float:
	return _engine().gap()


func _bodies() -> int:
	return frame().lesson.find_children("*", "CollisionObject2D", true, false).size()


func _on_bar(seconds: float) -> Vector2:
	return _bar().get_global_transform() * Vector2(_bar().pixel_of(seconds), 20.0)


# By the keyboard: the last entry of the list.
func _choose_event_world() -> void:
	var list := Screen.named(screen(), "How a frame is stepped") as OptionButton
	list.grab_focus()
	await student.press(&"ui_accept")
	for i: int in list.item_count:
		if list.get_popup().get_focused_item() != list.item_count - 1:
			await student.press(&"ui_down")
	await student.press(&"ui_accept")
	student.window.gui_release_focus()
