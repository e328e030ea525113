class_name VerdictCard
extends PanelContainer
## What a lesson finds, in words, with a colored ball that also carries a sign.

const _MARGIN := 12

## The corner of the board where the card is, until [method keep_off] chooses one.
@export var home_corner := PRESET_BOTTOM_LEFT

@onready var _corner := home_corner
@onready var _ball: Control = %Ball
@onready var _sign: Label = %Sign
@onready var _words: Label = %Words


## Shows [param sign_text], one letter, on a ball in the color of [param role], and beside it
## [param words], translated, a line each.
func show_verdict(sign_text: String, role: Palette.Role, words: PackedStringArray) -> void:
	_sign.text = sign_text
	_ball.self_modulate = Palette.color(role)
	_words.text = "\n".join(words)
	_settle()


## Moves to the lower left, or, where that would cover one of [param pixels] of the board or what
## is up to [param around] pixels beside it, at the upper right.
func keep_off(pixels: PackedVector2Array, around: float) -> void:
	var board_size := get_parent_area_size()
	var place := Rect2(_MARGIN, board_size.y - size.y - _MARGIN, size.x, size.y).grow(around)
	_corner = PRESET_BOTTOM_LEFT
	for pixel in pixels:
		if place.has_point(pixel):
			_corner = PRESET_TOP_RIGHT
	_settle()


## Moves to this corner of the board.
func stand_in(corner: LayoutPreset) -> void:
	_corner = corner
	_settle()


# Makes the card as small as its words allow and puts it into its corner.
func _settle() -> void:
	var is_right := _corner in [PRESET_TOP_RIGHT, PRESET_BOTTOM_RIGHT]
	grow_horizontal = GROW_DIRECTION_BEGIN if is_right else GROW_DIRECTION_END
	var is_low := _corner in [PRESET_BOTTOM_LEFT, PRESET_BOTTOM_RIGHT]
	grow_vertical = GROW_DIRECTION_BEGIN if is_low else GROW_DIRECTION_END
	set_anchors_and_offsets_preset(_corner, PRESET_MODE_MINSIZE, _MARGIN)
