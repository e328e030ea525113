extends ScreenTest
## Links to a board: copied by button and key, opened again in every lesson, refused where they are
## wrong.

const _FUZZ := preload("res://tests/support/link_fuzz.gd")
const _CASES := 48

## One or two links for each lesson that a person could write, and what they set.
const _GOOD: Dictionary[String, Array] = {
	"class_or_value": ["position=3,-2", "copies=true&old=1,1"],
	"easy_bounce": ["tilt_degrees=30", "is_wall=true&ball=0,0,10,10,20"],
	"normals": ["line=0,0,3,-4&times=1", "mistake=9"],
	"dot_product": ["a=3,4", "b=8,-6.5&b_from=1,1&is_swapped=true"],
	"projection_proof": ["a=3,4&b=0.1,0"],
	"line_distance": ["ball=75,25,30&from_share=0.8", "mistake=-2", "speed=140&rule=2"],
	"point_of_impact": ["old=6,-13&new=6,-3", "radius=0.5&mistake=15"],
	"reflection": ["bounciness=0.5&along=-8,-6", "has_unit_normal=false&normal_length=3"],
	"angled_lines":
	[
		"scene=3",
		"scene=5&method=event_world",
		"scene=10",
		"scene=10&endless=false&method=whole_frame",
		"method=position_reset&endless=true",
		"gravity=0,0&balls=0,0,160,0,12&starts=0,0,160,0&lines=0,100,200,100;-200,50,-100,60",
		"balls=900,0,1,0,12&mistake=14&method=position_reset",
	],
	"line_ends": ["shot=-6,-8,6,16,4&time=0.25"],
	"more_dimensions": ["has_four=true&a=1,2,3,4&view=3,1", "has_five=true&fifth=3,-1"],
	"error_and_time": ["problem=digits_of_pi", "stability=true"],
	"aim_at": ["hull_degrees=45&target=100,20", "fire=0.9&mistake=30"],
	"lead_target": ["velocity=-180,90", "own=0,90&speed=120&mistake=104"],
	"ballistic_aim":
	["target=80,-60&speed=200&gravity=250", "moves=true&velocity=30,-40&arc=1", "gravity=0"],
	"timed_shot": ["muzzle=300,400&target=0,200", "kind=1&circling=-45&fire=2.5", "kind=2"],
	"bank_shot":
	["bounciness=0.5&radius=10", "walls=0,280,320,240;350,250,310,20&bounces=2&order=12"],
	"newton_balls":
	[
		"bounciness=0.5&mistake=25",
		"balls=-3,0,4,1,1;3,0,0,0,1;0,5,0,0,2&has_box=true&has_newton=false"
	],
	"slide_and_roll":
	["friction=0.125", "start=-200,0&end=200,0&speed=300&radius=15&mistake=103&has_engine=true"],
	"collision_friction":
	[
		"spin=-30&friction=0.5",
		"velocity=250,0&along=60,-80&two_balls=true&mistake=105",
		"gravity=900&bounciness=0.8&radius=10&has_friction=false",
	],
	"moving_platforms":
	[
		"kind=1",
		"kind=2",
		"kind=3",
		"kind=4",
		"ball=200,0&velocity=-200,0&bounciness=0.5&mistake=102",
		"kind=1&surface=-192,56,192,-56&surface_speed=348&friction=0.5&from_surface=true",
		"kind=4&way=180&speed=250&surface_speed=80",
	],
}
const _BAD: Dictionary[String, Dictionary] = {
	"class_or_value": {"position=1e39,0": "position must be within −1e38..1e38, not 1e39."},
	"easy_bounce":
	{
		"tilt_degrees=46": "The tilt must be within −45° and 45°, not 46°.",
		"ball=0,0,0,0,-1": "r must be above 0 and at most 200, not −1.",
	},
	"normals": {"mistake=8": "mistake must be one of 0, "},
	"dot_product":
	{
		"a=1,x": "“x” in a must be a number: 0, or from 1e-100 to 1e100 in size.",
		"c=1":
		"There is no value “c” here. There are: a, a_from, b, b_from, is_swapped, normalizes.",
	},
	"projection_proof": {"a=1": "a must have 2 numbers, not 1: “1”."},
	"line_distance":
	{
		"line=1,1,1,1": "A segment must be longer than 0",
		"ball=0,0,-5": "A ball's radius must be above 0 and finite, not -5",
		"mistake=1": "mistake must be one of 0, -2, ",
		"speed=0": "The speed must be above 0",
		"rule=3": "rule must be within 0..2",
	},
	"point_of_impact": {"radius=0": "A ball's radius must be above 0"},
	"reflection":
	{
		"bounciness=1.5": "C must be within 0..1, but is 1.5.",
		"along=0,0": "The line (0, 0) has no direction",
		"normal_length=0": "The length of n must be above 0, but is 0.",
	},
	"angled_lines":
	{
		"scene=11": "scene must be within 0..10, not 11.",
		"endless=true": "Only position reset knows endless lines",
		"endless=true&method=position_reset&mistake=14": "mistake must be one of 0, not “14”.",
		"method=verlet": "method must be one of position_reset, point_of_impact, whole_frame, ",
		"selected=1": "selected must be within 0..0, not 1.",
		"bounciness=-1": "The bounciness C must be within 0..1, not -1",
		"lines=1,1,1,1": "A segment must be longer than 0",
		"balls=0,0,0,0,0": "balls must be within 0.1..200, not 0.",
		"balls=": "selected must be within",
		"balls=0,0,0,0,5;9,9,0,0,5": "starts must have 2 parts, as balls has, not 1.",
		"starts=801,0,0,0": "A ball must be within -800..800 px",
		"method=event_world&mistake=14": "mistake must be one of 0, not “14”.",
	},
	"line_ends":
	{
		"line=1,1,1,1": "The line must be at least 0.001 long",
		"shot=0,0,1,1,0": "A radius of 0 cannot be",
		"time=1.5": "time must be within 0..1, not 1.5.",
	},
	"more_dimensions":
	{
		"fifth=1e7,0": "1e7 cannot be: a component is 0, or from 1e-6 to 1e6 in size.",
		"a=1e7,0,0,0": "1e7 cannot be: a component is 0, or from 1e-6 to 1e6 in size.",
		"view=0,2": "view must be within −1.4..1.4, not 2.",
	},
	"ballistic_aim":
	{
		"speed=0": "s must be within 1..100000, not 0.",
		"gravity=-1": "g must be within 0..100000, not −1.",
		"arc=4": "arc must be within 0..3, not 4.",
		"mistake=9": "mistake must be one of 0, 101, ",
	},
	"timed_shot":
	{
		"bullet=0,0": "The bullet needs a speed of 1 px/s or more, not 0.",
		"kind=1&target=0,-50": "The circle needs a radius of 1 px or more, not 0.",
		"circling=0": "circling must be within 1..720, not 0.",
		"turning=721": "turning must be within −720..720, not 721.",
		"fire=61": "fire must be within 0..60, not 61.",
		"kind=3": "kind must be within 0..2, not 3.",
	},
	"error_and_time":
	{
		"problem=none": "problem must be one of ",
		"situation=-1": "situation must be within 0..",
		"situation=99": "situation must be within 0..",
	},
	"aim_at":
	{
		"hull_degrees=181": "hull_degrees must be within −180..180, not 181.",
		"length=0": "length must be within 0.001..10000, not 0.",
		"mistake=5": "mistake must be one of 0, 101, 4, 30, 102, not “5”.",
	},
	"lead_target":
	{
		"speed=0": "s must be within 0.001..1000000, not 0.",
		"target=2e6,0": "target must be within −1000000..1000000, not 2000000.",
		"radius=-1": "R must be within 0..1000000, not −1.",
	},
	"bank_shot":
	{
		"radius=0": "r must be within 0.01..10000, not 0.",
		"bounces=4": "bounces must be within 1..3, not 4.",
		"order=3": "order must be one of 1, 2, not “3”.",
		"walls=1,1,1,1": "A wall must be at least 0.01 px long",
	},
	"newton_balls":
	{
		"bounciness=1.5": "C must be within 0..1, not 1.5.",
		"balls=0,0,1,0,1;1,0,0,0,1": "Ball 1 and ball 2 must not overlap.",
		"balls=0,0,1,0,0;9,0,0,0,1": "m of ball 1 must be within 0.01..100, not 0.",
		"balls=0,0,1,0,1": "There must be 2 to 50 balls, not 1.",
		"balls=0,0,1,0,1;11.5,0,0,0,1&has_box=true": "Ball 2 must be in the box.",
	},
	"slide_and_roll":
	{
		"friction=-1": "µ must be within 0..10, not −1.",
		"gravity=0": "g must be within 0.001..1000000, not 0.",
		"end=48,-40":
		"The line must lead at least 1 px to the right and not climb: from (−48, −36) to (48, −40)",
	},
	"collision_friction":
	{
		"friction=-1": "µ must be within 0..10, not −1.",
		"spin=2000": "ω must be within −1000..1000, not 2000.",
		"bounciness=1.5": "C must be within 0..1, not 1.5.",
		"along=0,0": "The surface must be at least 1 px long, not 0.",
		"velocity=300,-400": "The ball must come to the surface with at least 1 px/s, not −400.",
	},
	"moving_platforms":
	{
		"kind=5": "kind must be within 0..4, not 5.",
		"bounciness=2": "C must be within 0..1, not 2.",
		"ball=-110,0":
		"At the start the ball's centre must be more than 20 px from the surface, not 10.",
		"kind=4&speed=80":
		"The ball must be at least 1 px/s faster than the wall with 100, not 80.",
	},
}


func after_each() -> void:
	LessonRequest.ask("")
	await super.after_each()


func test_each_link_opens_in_its_lesson_and_is_copied_again_as_it_was() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		assert_has(_GOOD, lesson.id, "say in _GOOD which links %s takes" % lesson.id)
		for text: String in _GOOD.get(lesson.id, []):
			await _open_link(lesson, text)
			assert_false(_notice().contains("link"), _notice())
			var again := frame().link.text().trim_prefix(lesson.id + "?")
			assert_eq(_sorted(again), _sorted(text))
			screen().free()


func test_a_value_that_cannot_be_shown_is_named_and_the_lesson_is_at_its_start() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		assert_has(_BAD, lesson.id, "say in _BAD which links %s refuses" % lesson.id)
		for text: String in _BAD.get(lesson.id, {}):
			await _open_link(lesson, text)
			var sentence: String = _BAD[lesson.id][text]
			assert_string_starts_with(_notice(), "This link cannot be opened: " + sentence)
			assert_eq(frame().link.text(), str(lesson.id), text)
			screen().free()


# Any engine error or warning fails the test.
func test_no_link_breaks_a_lesson() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		var fuzz := _FUZZ.new(20 + LessonIndex.number_of(lesson))
		await open_lesson(lesson)
		var first := frame().lesson.link_state()
		var taken := 0
		for i: int in _CASES:
			taken += await _throw(fuzz.text(i, first), first)
		assert_gt(taken, 0, "%s takes some of them" % lesson.id)
		screen().free()


func test_a_click_on_the_button_copies_the_link() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	await student.enter(Screen.named(screen(), "x of a") as LineEdit, "3.25")
	await click_button("Copy a link to this board")
	assert_string_starts_with(_notice(), "✓ Copied: #dot_product?a=3.25,1 It goes behind")
	var place := frame().get_node("%NoticePlace") as Control
	assert_eq(place.theme_type_variation, &"PanelCard", "good news is not in the frame of errors")
	assert_false(
		place.get_global_rect().intersects(frame().lesson.get_global_rect()), "nor on the board"
	)


func test_a_key_copies_the_link() -> void:
	await open_lesson(LessonIndex.find(&"normals"))
	await student.press(&"lab_copy_link")
	assert_string_starts_with(_notice(), "✓ Copied: #normals It goes behind")


func test_only_the_beginning_of_a_long_link_is_shown() -> void:
	await _open_link(LessonIndex.find(&"angled_lines"), "scene=8")
	await student.press(&"lab_next_frame")
	await student.press(&"lab_copy_link")
	assert_gt(frame().link.text().length(), 1000)
	assert_lt(_notice().length(), 250)


func test_a_board_beyond_the_range_is_not_copied() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	frame().lesson.show_state(
		{"a": PackedFloat64Array([1e-200, 0.0])}.merged(frame().lesson.state())
	)
	await student.press(&"lab_copy_link")
	assert_eq(
		_notice(),
		(
			"This board cannot be put into a link: “1e-200” in a must be a number: 0, or from "
			+ "1e-100 to 1e100 in size."
		)
	)


func test_reset_leads_to_the_lessons_own_start_and_undo_back_to_the_link() -> void:
	await _open_link(LessonIndex.find(&"dot_product"), "a=3,4")
	assert_true(Screen.button(screen(), "Undo").disabled, "opening a link is no change")
	await student.press(&"lab_reset")
	assert_eq(frame().link.text(), "dot_product")
	await student.press(&"lab_undo")
	assert_eq(frame().link.text(), "dot_product?a=3,4")


func test_a_link_that_comes_while_its_lesson_is_open_is_a_change_that_can_be_undone() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	frame().follow_link("#dot_product?a=3,4")
	assert_eq(frame().link.text(), "dot_product?a=3,4")
	frame().follow_link("#dot_product?a=3")
	assert_eq(frame().link.text(), "dot_product?a=3,4", "a wrong link changes nothing")
	assert_string_starts_with(_notice(), "This link cannot be opened")
	frame().follow_link("#dot_product?a=3,4")
	assert_eq(_notice(), "", "a link that can be opened clears the refusal of the last one")
	await student.press(&"lab_undo")
	assert_eq(frame().link.text(), "dot_product")


func test_a_link_to_another_lesson_asks_for_it_and_one_to_none_is_refused() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	watch_signals(frame())
	frame().follow_link("#no_such_lesson?a=1")
	assert_string_starts_with(_notice(), "There is no lesson “no_such_lesson”. There are: ")
	assert_signal_not_emitted(frame(), "other_lesson_wanted")
	frame().follow_link("#normals?mistake=9")
	assert_signal_emitted_with_parameters(
		frame(), "other_lesson_wanted", [LessonIndex.find(&"normals")]
	)


func test_a_link_to_another_lesson_is_opened_in_the_whole_lab() -> void:
	await open_start_screen()
	await student.press_key(KEY_ENTER)
	frame().follow_link("#normals?mistake=9")
	await student.settle()
	assert_eq(frame().lesson_info.id, &"normals")
	assert_eq(frame().link.text(), "normals?mistake=9")


func test_what_a_student_does_comes_back_to_the_last_bit() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		await _play_around()
		var before := frame().lesson.link_state()
		var text := frame().link.text()
		screen().free()
		await _open_link(lesson, text.trim_prefix(lesson.id).trim_prefix("?"))
		assert_eq(LessonLink.text_of(frame().lesson.link_state(), before), "", text)
		screen().free()


# Drags everything a little by the keys, unevenly, and lets time pass.
func _play_around() -> void:
	for handle: Node in get_tree().get_nodes_in_group(Board.HANDLES):
		var control := handle as Handle
		if control.is_visible_in_tree() and control.focus_mode == Control.FOCUS_ALL:
			control.grab_focus()
			await student.press_key(KEY_RIGHT, true)
			await student.press_key(KEY_DOWN, true)
	await student.press(&"lab_pause")
	await student.press(&"lab_pause")


# 1 if the link was taken.
func _throw(text: String, first: Dictionary) -> int:
	var before := frame().lesson.link_state()
	var problem := frame().link.open(text)
	await student.settle()
	var after := frame().lesson.link_state()
	if problem:
		assert_eq(after, before, "refused: " + text)
		return 0
	var wanted := LessonLink.read(text, frame().lesson.link_base(first, after))
	assert_eq(LessonLink.text_of(after, wanted.state), "", "taken: " + text)
	# A switched-on mistake may lead to NaN, and the table of extreme cases shows it.
	if after.get("mistake", 0) == 0 and not after.has("stability"):
		assert_false(PageText.of([frame()]).contains("NaN"), text)
	# Where time can run, it must run on from the linked state.
	await student.press(&"lab_pause")
	await student.press(&"lab_pause")
	return 1


func _open_link(lesson: LessonInfo, text: String) -> void:
	LessonRequest.ask("%s?%s" % [lesson.id, text])
	assert_eq(LessonRequest.take_id(), lesson.id)
	await open_lesson(lesson)


func _notice() -> String:
	var place := frame().get_node("%NoticePlace") as Control
	return (frame().get_node("%Notice") as Label).text if place.visible else ""


func _sorted(text: String) -> PackedStringArray:
	var parts := text.split("&")
	parts.sort()
	return parts
