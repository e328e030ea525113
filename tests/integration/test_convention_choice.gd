extends ScreenTest
## The conventions are chosen for the whole lab: in the menu, by keys, by links. Whatever is chosen,
## handles, keys and guesses work, and no number of the board changes.

const _KEEPING_Y_DOWN: Array[StringName] = [
	&"class_or_value",
	&"easy_bounce",
	&"angled_lines",
	&"error_and_time",
	&"aim_at",
	&"ballistic_aim",
	&"timed_shot",
	&"slide_and_roll",
	&"collision_friction",
	&"moving_platforms",
]


func after_each() -> void:
	LessonRequest.ask("")
	await super.after_each()


func test_each_switch_of_the_menu_is_kept_and_shown() -> void:
	var switches: Dictionary[String, Conventions.Choice] = {
		"Radians": Conventions.Choice.RADIANS,
		"y points up": Conventions.Choice.Y_UP,
		"Angles 0 to 360°": Conventions.Choice.FULL_TURN,
	}
	await open_lesson(LessonIndex.find(&"dot_product"))
	for words in switches:
		await pick_in_view_menu(words)
		assert_true(Conventions.is_chosen(switches[words]), words)
	for action: StringName in [&"lab_radians", &"lab_y_up", &"lab_full_turn"]:
		assert_true(frame().view.menu.is_on(action), action)
		await student.press(action)
		assert_false(frame().view.menu.is_on(action), action)


func test_the_open_lesson_follows_at_once_and_so_does_the_next() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	await go_to_step()
	assert_has(_lines(), "β = atan2(−6, 8) = −36.87°")
	await student.press(&"lab_full_turn")
	assert_has(_lines(), "β = atan2(−6, 8) + 360° = 323.1°")
	assert_has(_lines(), "φ = α − β + 360° = 45°")
	await student.press(&"lab_radians")
	assert_has(_lines(), "β = atan2(−6, 8) + 2π = 5.64")
	assert_has(_lines(), "φ = α − β + 2π = π/4")
	assert_has(_lines(), "|a| cos φ = 7.071·cos π/4 = 5")
	assert_reads("positive: the angle is below π/2")
	screen().free()
	await open_lesson(LessonIndex.find(&"normals"))
	await go_to_step(1)
	assert_has(_lines(), "cos π/2 = 0     sin π/2 = 1")
	assert_reads("Turn v and its triangle by +π/2, clockwise")


func test_only_lessons_without_a_below_turn_over() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		await student.press(&"lab_y_up")
		var is_kept := lesson.id in _KEEPING_Y_DOWN
		assert_eq(frame().lesson.board.is_y_up, not is_kept, lesson.id)
		await student.press(&"lab_view")
		var words := PackedStringArray()
		for entry: int in frame().view.menu.get_popup().item_count:
			words.append(frame().view.menu.get_popup().get_item_text(entry))
		var says_so := "y points up (not in this lesson)" in "\n".join(words)
		assert_eq(says_so, is_kept, lesson.id)
		await student.press_key(KEY_ESCAPE)
		await student.press(&"lab_y_up")
		screen().free()


func test_no_number_of_a_board_depends_on_a_convention() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		var state := frame().lesson.link_state().duplicate(true)
		for choice: Conventions.Choice in Conventions.Choice.values():
			Conventions.choose(choice, true)
		assert_eq(frame().lesson.link_state(), state, lesson.id)
		for choice: Conventions.Choice in Conventions.Choice.values():
			Conventions.choose(choice, false)
		screen().free()


func test_turned_over_a_handle_that_is_dragged_up_has_a_larger_y() -> void:
	Conventions.choose(Conventions.Choice.Y_UP, true)
	for lesson: LessonInfo in LessonIndex.lessons():
		if lesson.id in _KEEPING_Y_DOWN or lesson.id == &"more_dimensions":
			continue
		await open_lesson(lesson)
		# The first steps of the line ends have no handle for the keyboard.
		if lesson.id == &"line_ends":
			await go_to_step()
		var most := 0.0
		for handle: Handle in frame().lesson.board.focusable_handles():
			var at := handle.get_global_rect().get_center()
			if not frame().lesson.board.get_global_rect().has_point(at + Vector2(0, -60)):
				continue
			var before := handle.at().y
			await student.drag(at, at + Vector2(0, -60), true)
			var gained := handle.at().y - before
			assert_gt(gained, -1e-9, "%s of %s" % [handle.title, lesson.id])
			most = maxf(most, gained)
		assert_gt(most, 0.0, lesson.id)
		screen().free()


func test_turned_over_the_arrow_keys_go_up_the_screen() -> void:
	Conventions.choose(Conventions.Choice.Y_UP, true)
	await open_lesson(LessonIndex.find(&"dot_product"))
	(Screen.named(screen(), "Head of a")).grab_focus()
	await student.press(&"ui_up")
	assert_eq(str(frame().lesson.link_state()["a"]), str(PackedFloat64Array([7, 2])))


func test_a_link_asks_for_conventions_and_a_copy_names_them() -> void:
	var kept := FileAccess.get_file_as_string(KeptChoices.file)
	await _open_link("dot_product?a=3,1&angles=radians&y=up&turn=full")
	assert_true(Conventions.uses_radians() and Conventions.is_y_up())
	assert_true(Conventions.has_full_turn())
	assert_true(frame().lesson.board.is_y_up)
	assert_eq(frame().link.text(), "dot_product?a=3,1&angles=radians&y=up&turn=full")
	assert_eq(FileAccess.get_file_as_string(KeptChoices.file), kept, "it is not kept as a choice")
	frame().follow_link("#dot_product?angles=degrees&y=down&turn=signed")
	assert_eq(frame().link.text(), "dot_product")


func test_an_older_link_to_the_normals_still_turns_the_picture_over() -> void:
	await _open_link("normals?line=0,0,3,-4&is_y_up=true")
	assert_true(frame().lesson.board.is_y_up)
	assert_eq(frame().link.text(), "normals?line=0,0,3,-4&y=up")
	frame().follow_link("#normals?is_y_up=false")
	assert_false(Conventions.is_y_up())


func test_what_is_no_convention_is_refused() -> void:
	await _open_link("dot_product?angles=grad")
	assert_reads("angles must be degrees or radians, not “grad”.")
	frame().follow_link("#dot_product?y=left")
	assert_reads("y must be down or up, not “left”.")
	frame().follow_link("#normals?is_y_up=yes")


func test_the_switch_of_the_normals_is_that_of_the_lab() -> void:
	await open_lesson(LessonIndex.find(&"normals"))
	await click_button("y points up")
	assert_true(Conventions.is_y_up())
	await student.press(&"lab_y_up")
	assert_false((Screen.button(screen(), "y points up") as CheckButton).button_pressed)
	assert_reads_no_undo()


func test_a_tilt_is_typed_in_radians() -> void:
	Conventions.choose(Conventions.Choice.RADIANS, true)
	await open_lesson(LessonIndex.find(&"easy_bounce"))
	await student.enter(Screen.named(screen(), "Tilt of the line in radians") as LineEdit, "0.5")
	var tilt: float = frame().lesson.link_state()["tilt_degrees"]
	assert_almost_eq(tilt, rad_to_deg(0.5), 1e-12)
	await click_button("π/6")
	tilt = frame().lesson.link_state()["tilt_degrees"]
	assert_eq(tilt, 30.0)
	await student.enter(Screen.named(screen(), "Tilt of the line in radians") as LineEdit, "2")
	assert_reads("The tilt must be within −π/4 and π/4, not 2 rad.")


func test_the_cards_of_the_start_screen_tell_angles_in_the_unit_that_is_chosen() -> void:
	await open_start_screen()
	assert_reads("Turn a vector by 90°")
	screen().free()
	Conventions.choose(Conventions.Choice.RADIANS, true)
	await open_start_screen()
	assert_reads("Turn a vector by π/2")
	assert_false("\n".join(Screen.texts(screen())).contains("°"))


func test_the_names_of_stiff_cases_follow_the_unit_at_once() -> void:
	await open_lesson(LessonIndex.find(&"error_and_time"))
	var table := frame().lesson.get_node("%Table") as StabilityTable
	var run := StabilityRun.new(StabilityCases.all())
	table.show_run(run)
	var of_wedge := _row_with(table, "wedge of 60°")
	var of_slope := _row_with(table, "slope of 20°")
	Conventions.choose(Conventions.Choice.RADIANS, true)
	table.show_run(run)
	assert_string_contains(_title_of(table, of_wedge), "wedge of π/3")
	assert_string_contains(_title_of(table, of_slope), "slope of π/9")
	for place in run.size() + run.left_out.size():
		assert_false(_title_of(table, place).contains("°"), _title_of(table, place))
	Conventions.choose(Conventions.Choice.RADIANS, false)
	table.show_run(run)
	assert_string_contains(_title_of(table, of_wedge), "wedge of 60°")


func _row_with(table: StabilityTable, words: String) -> int:
	for place in table.get_node("%Rows").get_child_count():
		if _title_of(table, place).contains(words):
			return place
	assert_true(false, words)
	return 0


func _title_of(table: StabilityTable, place: int) -> String:
	return (table.row(place).get_node("%Title") as Label).text


func assert_reads_no_undo() -> void:
	assert_true(Screen.button(screen(), "Undo").disabled, "a convention is no change of the board")


func _lines() -> PackedStringArray:
	return Screen.lines(frame().lesson.services[&"formula"] as Formula)


func _open_link(text: String) -> void:
	LessonRequest.ask(text)
	await open_lesson(LessonIndex.find(LessonRequest.take_id()))
