class_name Signs
extends RefCounted
## The signs that the lessons use and that the engine's font lacks: arrows, check mark, crosses.
##
## On the desktop the engine borrows such signs from the system's fonts; in a browser there are
## none, and each would be an empty box. `tools/draw/make_signs_font.py` draws them.

const _FONT: FontFile = preload("res://assets/signs.ttf")


## Adds them to the engine's font, which all texts use.
static func add_to_font() -> void:
	ThemeDB.fallback_font.fallbacks = [_FONT]
