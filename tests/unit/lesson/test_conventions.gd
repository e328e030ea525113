extends LabTest
## Angles are written in the unit and the range that were chosen, and the choice is kept.

const _FILE := "user://conventions_in_test.cfg"

var _file_before := ""


func before_each() -> void:
	_file_before = KeptChoices.file
	KeptChoices.file = _FILE
	KeptChoices.read_again()


func after_each() -> void:
	for choice: Conventions.Choice in Conventions.Choice.values():
		Conventions.choose(choice, false)
	DirAccess.remove_absolute(_FILE)
	KeptChoices.file = _file_before
	KeptChoices.read_again()


func test_without_a_choice_all_is_as_in_the_course() -> void:
	assert_false(Conventions.uses_radians())
	assert_false(Conventions.is_y_up())
	assert_false(Conventions.has_full_turn())
	assert_eq(Conventions.angle_text(-36.8698976), "−36.87°")
	assert_eq(Conventions.in_range(-36.0), -36.0)
	assert_eq(Conventions.in_unit("above 90°"), "above 90°")


func test_a_choice_is_kept_and_told() -> void:
	watch_signals(Conventions.changed().get_object())
	Conventions.choose(Conventions.Choice.Y_UP, true)
	assert_signal_emit_count(Conventions.changed().get_object(), "changed", 1)
	KeptChoices.read_again()
	assert_true(Conventions.is_y_up())
	assert_false(Conventions.uses_radians())


func test_what_a_link_asks_for_is_not_kept() -> void:
	Conventions.choose_for_now(Conventions.Choice.RADIANS, true)
	assert_true(Conventions.uses_radians())
	assert_false(FileAccess.file_exists(_FILE))
	Conventions.choose(Conventions.Choice.RADIANS, false)
	assert_false(Conventions.uses_radians(), "the student's choice ends it")


func test_radians_are_shares_of_pi_where_they_are_simple_ones() -> void:
	Conventions.choose(Conventions.Choice.RADIANS, true)
	var texts: Dictionary[float, String] = {
		90.0: "π/2",
		-90.0: "−π/2",
		180.0: "π",
		360.0: "2π",
		135.0: "3π/4",
		-65.0: "−13π/36",
		60.00000000000001: "π/3",
		90.0000001: "1.571 rad",
		53.13010235415598: "0.9273 rad",
		0.0: "0 rad",
		1e-9: "1.745e−11 rad",
	}
	for degrees in texts:
		assert_eq(Conventions.angle_text(degrees), texts[degrees])
	assert_eq(Conventions.share_of_pi(0.0), "")
	assert_eq(Conventions.mark_text(53.13010235415598), "0.9273")
	assert_eq(Conventions.mark_text(-90.0), "−π/2")
	assert_eq(Conventions.share_of_pi(1e20), "")


func test_a_full_turn_begins_at_0() -> void:
	Conventions.choose(Conventions.Choice.FULL_TURN, true)
	assert_eq(Conventions.in_range(-90.0), 270.0)
	assert_eq(Conventions.in_range(0.0), 0.0)
	assert_eq(Conventions.in_range(135.0), 135.0)
	assert_eq(Vec2.new(0.0, -1.0).angle_degrees(), -90.0, "Vec2 returns what it did")


func test_angles_in_a_text_get_the_unit() -> void:
	Conventions.choose(Conventions.Choice.RADIANS, true)
	var texts: Dictionary[String, String] = {
		"below, at or above 90°": "below, at or above π/2",
		"+90°, and −90°": "+π/2, and −π/2",
		"cos 90° = 0     sin 90° = 1": "cos π/2 = 0     sin π/2 = 1",
		"not 46°.": "not 0.8029 rad.",
		"no angle in 90 px": "no angle in 90 px",
	}
	for text in texts:
		assert_eq(Conventions.in_unit(text), texts[text])


func test_what_is_typed_is_in_the_unit_that_is_shown() -> void:
	assert_eq(Conventions.typed(30.0), 30.0)
	Conventions.choose(Conventions.Choice.RADIANS, true)
	assert_almost_eq(Conventions.typed(PI / 6.0), 30.0, 1e-12)
	assert_almost_eq(Conventions.shown(30.0), PI / 6.0, 1e-15)
