extends LabTest
## The palette reads on every ground and stays apart for colour-blind readers; the theme keeps to
## it.

const ThemeColors := preload("res://tools/draw/theme_colors.gd")
const _READABLE := 4.5
const _WELL_READABLE := 7.0
const _FAR_APART := 10.0
const _GROUNDS: Dictionary[String, Color] = {
	"paper": Palette.PAPER,
	"panel": Palette.PANEL,
	"field": Palette.FIELD,
}
const _ARROWS: Array[Palette.Role] = [
	Palette.Role.A,
	Palette.Role.B,
	Palette.Role.UNIT,
	Palette.Role.PROJECTION,
	Palette.Role.REST,
]


func after_each() -> void:
	Palette.is_high_contrast = false


func test_text_of_every_role_reads_on_paper_panel_and_field() -> void:
	for role: Palette.Role in Palette.Role.values():
		for ground: String in _GROUNDS:
			var contrast := ColorVision.contrast(Palette.color(role), _GROUNDS[ground])
			assert_gte(contrast, _READABLE, "%s on %s" % [_name(role), ground])


func test_with_high_contrast_text_reads_on_white_for_weak_eyes_too() -> void:
	Palette.is_high_contrast = true
	for ground: String in _GROUNDS:
		var white := Palette.drawn(_GROUNDS[ground])
		assert_eq(white, Color.WHITE, ground)
		for role: Palette.Role in Palette.Role.values():
			assert_gte(
				ColorVision.contrast(Palette.color(role), white), _WELL_READABLE, _name(role)
			)


func test_arrows_differ_for_every_kind_of_eyes_also_with_high_contrast() -> void:
	_assert_arrows_differ()
	Palette.is_high_contrast = true
	_assert_arrows_differ()


func test_what_has_a_color_of_the_palette_has_its_strong_color_with_high_contrast() -> void:
	var usual := Palette.color(Palette.Role.B)
	assert_eq(Palette.drawn(usual), usual)
	Palette.is_high_contrast = true
	assert_eq(Palette.drawn(Color(usual, 0.3)), Color(Palette.color(Palette.Role.B), 0.3))
	assert_eq(Palette.drawn(Color.CORAL), Color.CORAL)


func _assert_arrows_differ() -> void:
	for kind: ColorVision.Kind in ColorVision.Kind.values():
		for i: int in _ARROWS.size():
			for j: int in i:
				var one := Palette.color(_ARROWS[i])
				var difference := ColorVision.difference(one, Palette.color(_ARROWS[j]), kind)
				var text := "%s and %s, eyes %d" % [_name(_ARROWS[i]), _name(_ARROWS[j]), kind]
				assert_gte(difference, _FAR_APART, text)


func test_the_ring_of_the_focus_is_seen_on_every_ground() -> void:
	for ground: String in _GROUNDS:
		assert_gte(ColorVision.contrast(Palette.FOCUS, _GROUNDS[ground]), 3.0, ground)


func test_the_theme_has_the_colors_of_the_palette() -> void:
	var theme := FileAccess.get_file_as_string(ThemeColors.FILE)
	assert_gt(theme.count("= Color("), 50, "colors were found")
	var hint := "run: godot --headless --path . -s tools/draw/paint_theme.gd"
	assert_true(ThemeColors.painted(theme) == theme, hint)


func test_another_color_in_the_theme_is_found() -> void:
	var theme := '[sub_resource type="StyleBoxFlat" id="card"]\nbg_color = Color(0, 0, 0, 1)\n'
	assert_string_contains(ThemeColors.painted(theme), "bg_color = Color(1, 1, 1, 1)")


func test_white_on_black_has_the_greatest_contrast() -> void:
	assert_almost_eq(ColorVision.contrast(Color.WHITE, Color.BLACK), 21.0, 1e-3)
	assert_almost_eq(ColorVision.contrast(Color.RED, Color.RED), 1.0, 1e-6)


# 100 is the L* of white; red and green of equal lightness nearly meet for deuteranopes.
func test_the_simulation_brings_red_and_green_together() -> void:
	var kind := ColorVision.Kind.DEUTERANOPIA
	assert_almost_eq(ColorVision.difference(Color.WHITE, Color.BLACK, kind), 100.0, 0.1)
	var red := Color("b35900")
	var green := Color("707000")
	assert_lt(
		ColorVision.difference(red, green, kind),
		ColorVision.difference(red, green, ColorVision.Kind.USUAL) / 3.0
	)


func _name(role: Palette.Role) -> String:
	return Palette.Role.keys()[role]
