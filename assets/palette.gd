class_name Palette
extends RefCounted
## Every color of the lab, by its role. Nothing else names a color: the theme is painted from here
## by `tools/draw/paint_theme.gd`.
##
## The hues follow the set of Okabe and Ito, darkened until text in them reads on [constant PAPER]
## (contrast 4.5 or more), and can be told apart with any of the three kinds of color blindness; a
## test simulates them. Color is never the only sign: arrows have a label, lines a pattern.

## What a color means in a picture, a formula and a readout.
enum Role { INK, QUIET, A, B, UNIT, PROJECTION, REST, RIGHT, WRONG }

## The board behind arrows and text.
const PAPER := Color("fdfcf8")
## The panel beside the board.
const PANEL := Color("efece3")
## Fields and cards on the panel.
const FIELD := Color("ffffff")
## Thin lines of the grid.
const GRID := Color("e2ded2")
## Borders of fields and cards.
const BORDER := Color("b9b4a5")
## Axes of a grid or plot.
const AXIS := Color("8b8878")
## The ring around what has the keyboard's focus.
const FOCUS := Color("0b63b5")

const _COLORS: Dictionary[Role, Color] = {
	Role.INK: Color("1c2430"),
	Role.QUIET: Color("555d66"),
	Role.A: Color("00785a"),
	Role.B: Color("bf3900"),
	Role.UNIT: Color("543f00"),
	Role.PROJECTION: Color("0b63b5"),
	Role.REST: Color("8e3a8e"),
	Role.RIGHT: Color("00785a"),
	Role.WRONG: Color("b3261e"),
}

# The same for high contrast: on white each of them has a contrast of 7 or more.
const _STRONG_COLORS: Dictionary[Role, Color] = {
	Role.INK: Color("000000"),
	Role.QUIET: Color("3a3f45"),
	Role.A: Color("006046"),
	Role.B: Color("a02800"),
	Role.UNIT: Color("3f2e00"),
	Role.PROJECTION: Color("0048a0"),
	Role.REST: Color("7a2a7a"),
	Role.RIGHT: Color("006046"),
	Role.WRONG: Color("9c1006"),
}
# What replaces the colors of grounds and lines then.
const _STRONG_GROUNDS: Dictionary[Color, Color] = {
	PAPER: Color("ffffff"),
	PANEL: Color("ffffff"),
	GRID: Color("cccccc"),
	BORDER: Color("000000"),
	AXIS: Color("3a3f45"),
	FOCUS: Color("0048a0"),
}
# Lines are drawn so many times as thick then.
const _STRONG_STROKE := 1.4

## Colors and lines are the ones of high contrast.
static var is_high_contrast := false


## The color of a role.
static func color(role: Role) -> Color:
	return _STRONG_COLORS[role] if is_high_contrast else _COLORS[role]


## What [param usual], a color of the palette by its constant, is drawn in now. Keeps the opacity.
static func drawn(usual: Color) -> Color:
	if not is_high_contrast:
		return usual
	var solid := Color(usual, 1.0)
	var found: Color = _STRONG_GROUNDS.get(solid, solid)
	for role in _COLORS:
		if _COLORS[role] == solid:
			found = _STRONG_COLORS[role]
	return Color(found, usual.a)


## How thick a line of [param width] pixels is drawn now.
static func stroke(width: float) -> float:
	return width * _STRONG_STROKE if is_high_contrast else width
