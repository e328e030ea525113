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


## The color of a role.
static func color(role: Role) -> Color:
	return _COLORS[role]
