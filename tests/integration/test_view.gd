extends ScreenTest
## How the lab is shown, as the student chooses it by keys and in the menu: the panel, the size of
## text, high contrast, error and run time, help only where there are keys.

const _SIZES: Array[Vector2i] = [
	Vector2i(390, 844), Vector2i(844, 390), Vector2i(720, 1280), Vector2i(1280, 720)
]
# A tooltip comes after half a second.
const _FRAMES_TO_TOOLTIP := 60


func after_each() -> void:
	Keyboard.is_there = true
	await super.after_each()
	HighContrast.show_chosen()
	WindowFit.fit(student.window)


func test_a_key_folds_the_panel_and_the_board_has_its_room() -> void:
	for size: Vector2i in _SIZES:
		await resize(size)
		await open_lesson(LessonIndex.find(&"dot_product"))
		var before := frame().lesson.size
		await student.press(&"lab_panel")
		var board := frame().lesson.size
		assert_gt(board.x * board.y, before.x * before.y * 1.3, str(size))
		assert_false((frame().get_node("%Panel") as Control).is_visible_in_tree())
		await click_button("Show or fold the panel")
		assert_eq(frame().lesson.size, before, str(size))
		screen().free()


func test_the_panel_stays_folded_in_the_next_lesson() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	await student.press(&"lab_panel")
	screen().free()
	KeptChoices.read_again()
	await open_lesson(LessonIndex.find(&"normals"))
	assert_false(frame().view.layout.has_panel())


func test_without_a_panel_good_news_lies_on_the_board() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	await student.press(&"lab_panel")
	await student.press(&"lab_copy_link")
	var board := (frame().get_node("%BoardPlace") as Control).get_global_rect()
	assert_true(board.encloses((frame().get_node("%NoticePlace") as Control).get_global_rect()))


func test_keys_make_text_larger_and_smaller_on_every_screen() -> void:
	for open: Callable in [open_start_screen, open_lesson.bind(LessonIndex.find(&"dot_product"))]:
		await open.call()
		var sizes: Array[Vector2i] = []
		for action: StringName in [
			&"lab_larger_text", &"lab_larger_text", &"lab_larger_text", &"lab_smaller_text"
		]:
			await student.press(action)
			sizes.append(student.window.content_scale_size)
		assert_eq(
			sizes,
			(
				[Vector2i(1024, 576), Vector2i(853, 480), Vector2i(853, 480), Vector2i(1024, 576)]
				as Array[Vector2i]
			)
		)
		await student.press(&"lab_smaller_text")
		screen().free()


func test_the_size_of_text_is_kept() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	await pick_in_view_menu("Larger text")
	screen().free()
	KeptChoices.read_again()
	await open_start_screen()
	assert_eq(student.window.content_scale_size, Vector2i(1024, 576))


func test_high_contrast_is_black_on_white_and_can_be_taken_back() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	var label := frame().get_node("%Title") as Label
	var usual := label.get_theme_color(&"font_color")
	var fields := frame().find_children("*", "NumberField", true, false)
	var usual_role := (fields[0] as Control).get_theme_color(&"font_color")
	await student.press(&"lab_high_contrast")
	assert_eq(label.get_theme_color(&"font_color"), Color.BLACK)
	fields = frame().find_children("*", "NumberField", true, false)
	assert_ne((fields[0] as Control).get_theme_color(&"font_color"), usual_role)
	await pick_in_view_menu("High contrast")
	assert_eq(label.get_theme_color(&"font_color"), usual)


func test_every_color_of_the_theme_comes_back() -> void:
	var theme := ThemeDB.get_project_theme()
	var before := _colors(theme)
	await open_lesson(LessonIndex.find(&"dot_product"))
	await student.press(&"lab_high_contrast")
	assert_ne(_colors(theme), before)
	await student.press(&"lab_high_contrast")
	assert_eq(_colors(theme), before)


func test_error_and_run_time_are_folded_until_they_are_wanted_in_every_lesson() -> void:
	KeptChoices.forget("numbers")
	await open_lesson(LessonIndex.find(&"line_distance"))
	await go_to_step()
	assert_true(_readout().folded)
	await student.press(&"lab_numbers")
	assert_false(_readout().folded)
	screen().free()
	await open_lesson(LessonIndex.find(&"reflection"))
	await go_to_step(ReflectionModel.Step.BOUNCE)
	assert_false(_readout().folded)
	await student.scroll_to(_readout())
	await student.click_at(_readout().get_global_rect().position + Vector2(60.0, 20.0))
	assert_true(_readout().folded)
	await student.click(frame().view.menu)
	assert_false(frame().view.menu.is_on(&"lab_numbers"))


func test_they_are_open_where_the_step_is_about_them() -> void:
	for id: StringName in [&"class_or_value", &"dot_product", &"angled_lines", &"error_and_time"]:
		await open_lesson(LessonIndex.find(id))
		await go_to_step()
		assert_true(_readout().is_visible_in_tree(), id)
		assert_false(_readout().folded, id)
		screen().free()


func test_a_phone_has_no_help_for_keys() -> void:
	for size: Vector2i in [Vector2i(390, 844), Vector2i(844, 390)]:
		await resize(size)
		await open_lesson(LessonIndex.find(&"dot_product"))
		assert_false(_has_help(), str(size))
		screen().free()


func test_on_a_screen_to_touch_help_comes_with_the_first_key() -> void:
	Keyboard.is_there = false
	await open_lesson(LessonIndex.find(&"dot_product"))
	assert_false(_has_help())
	await student.click(frame().view.menu)
	assert_eq(frame().view.menu.get_popup().get_item_text(0), "Answers")
	await student.press_key(KEY_ESCAPE)
	await student.press_key(KEY_F9)
	assert_true(_has_help())
	await student.press(&"lab_view")
	assert_eq(frame().view.menu.get_popup().get_item_text(0), "Answers   H")


func test_on_a_screen_to_touch_tooltips_come_with_a_mouse() -> void:
	Keyboard.is_there = false
	await open_lesson(LessonIndex.find(&"dot_product"))
	var fold := frame().get_node("%FoldPanel") as Control
	await _point_at(fold, InputEvent.DEVICE_ID_EMULATION)
	assert_false(_has_tooltip())
	await _point_at(frame().view.menu, 0)
	await _point_at(fold, 0)
	assert_true(_has_tooltip())


func test_the_buttons_of_the_frame_are_there_at_every_size() -> void:
	for size: Vector2i in _SIZES:
		await resize(size)
		await open_lesson(LessonIndex.find(&"dot_product"))
		for title: String in ["Undo", "Redo", "View", "Show or fold the panel"]:
			var button := Screen.button(screen(), title)
			var rect := button.get_global_rect()
			assert_true(screen().get_global_rect().encloses(rect), "%s at %s" % [title, size])
			assert_gte(minf(rect.size.x, rect.size.y), 44.0, "%s at %s" % [title, size])
		screen().free()


func _colors(theme: Theme) -> Dictionary:
	var colors := {}
	for type in theme.get_color_type_list():
		for item in theme.get_color_list(type):
			colors["%s/%s" % [type, item]] = theme.get_color(item, type)
	for type in theme.get_stylebox_type_list():
		for item in theme.get_stylebox_list(type):
			var box := theme.get_stylebox(item, type) as StyleBoxFlat
			if box:
				var look := [box.bg_color, box.border_color, box.border_width_left]
				colors["%s.%s" % [type, item]] = look
	return colors


func _readout() -> Readout:
	return frame().lesson.services[&"readout"] as Readout


func _point_at(control: Control, device: int) -> void:
	var motion := InputEventMouseMotion.new()
	motion.device = device
	motion.position = (
		student.window.get_final_transform() * control.get_global_rect().get_center()
	)
	Input.parse_input_event(motion)
	for wait: int in _FRAMES_TO_TOOLTIP:
		await get_tree().process_frame


func _has_tooltip() -> bool:
	return get_tree().root.find_children("*", "PopupPanel", true, false).any(
		func(popup: PopupPanel) -> bool:
			return popup.theme_type_variation == &"TooltipPanel" and popup.visible
	)


func _has_help() -> bool:
	return (frame().get_node("%Help") as Control).is_visible_in_tree()
