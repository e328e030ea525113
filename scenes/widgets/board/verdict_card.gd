class_name VerdictCard
extends PanelContainer
## What a lesson finds, in words, with a colored ball that also carries a sign.

const _MARGIN := 12
# Two lines of words need so much; more is kept once it was needed.
const _STRIP := 74.0
# Where it may stand, the first that is free.
const _CORNERS: Array[LayoutPreset] = [
	PRESET_BOTTOM_LEFT, PRESET_TOP_RIGHT, PRESET_TOP_LEFT, PRESET_BOTTOM_RIGHT
]
# So much of its height a board leaves for its drawing.
const _FOR_DRAWING := 0.55

## The corner of the board where the card is, until [method keep_off] chooses one.
@export var home_corner := PRESET_BOTTOM_LEFT

@onready var _corner := home_corner
@onready var _ball: Control = %Ball
@onready var _sign: Label = %Sign
@onready var _words: Label = %Words
@onready var _board := get_parent() as Board


func _ready() -> void:
	if _board:
		_board.resized.connect(_settle)
		resized.connect(_keep_strip)
		visibility_changed.connect(_keep_strip)
		# How high the words are is known only once they are as wide as the strip.
		minimum_size_changed.connect(_shrink, CONNECT_DEFERRED)


## Shows [param sign_text], one letter, on a ball in the color of [param role], and beside it
## [param words], translated, a line each, which wraps so that no short word is left alone; angles
## in degrees are shown in the unit that is chosen.
func show_verdict(sign_text: String, role: Palette.Role, words: PackedStringArray) -> void:
	_sign.text = sign_text
	_ball.self_modulate = Palette.color(role)
	var lines := Conventions.in_unit("\n".join(words)).split("\n")
	_words.text = "\n".join(Array(lines).map(Steps.with_whole_ending))
	_settle()


## Moves to the lower left, or, where that would cover one of [param pixels] of the board or what
## is up to [param around] pixels beside it, to the next corner that covers none; to the upper right
## where all do.
func keep_off(pixels: PackedVector2Array, around: float) -> void:
	_corner = PRESET_TOP_RIGHT
	for corner in _CORNERS:
		var place := _place_in(corner).grow(around)
		var is_free := true
		for pixel in pixels:
			is_free = is_free and not place.has_point(pixel)
		if is_free:
			_corner = corner
			break
	_settle()


## Moves to this corner of the board.
func stand_in(corner: LayoutPreset) -> void:
	_corner = corner
	_settle()


func _place_in(corner: LayoutPreset) -> Rect2:
	var near := Vector2(_MARGIN, _MARGIN)
	var far := get_parent_area_size() - size - near
	var is_right := corner in [PRESET_TOP_RIGHT, PRESET_BOTTOM_RIGHT]
	var is_low := corner in [PRESET_BOTTOM_LEFT, PRESET_BOTTOM_RIGHT]
	return Rect2(far.x if is_right else near.x, far.y if is_low else near.y, size.x, size.y)


# Makes the card as small as its words allow and puts it into its corner.
func _settle() -> void:
	var is_strip := _is_strip()
	_words.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART if is_strip else TextServer.AUTOWRAP_OFF
	_words.size_flags_horizontal = SIZE_EXPAND_FILL if is_strip else SIZE_FILL
	if is_strip:
		_lie_along_edge()
	else:
		_stand_in_corner()
	_keep_strip()


func _lie_along_edge() -> void:
	grow_horizontal = GROW_DIRECTION_END
	grow_vertical = GROW_DIRECTION_BEGIN if _is_low() else GROW_DIRECTION_END
	var edge := PRESET_BOTTOM_WIDE if _is_low() else PRESET_TOP_WIDE
	set_anchors_and_offsets_preset(edge, PRESET_MODE_MINSIZE, _MARGIN)


func _shrink() -> void:
	if _is_strip():
		_lie_along_edge()


# On a small board the card is a strip along its edge, which the board leaves free.
func _is_strip() -> bool:
	return _board and _board.is_small()


# A strip stays where the scene has it: the board leaves it free.
func _is_low() -> bool:
	return home_corner in [PRESET_BOTTOM_LEFT, PRESET_BOTTOM_RIGHT]


func _keep_strip() -> void:
	if not _board:
		return
	var strip := 0.0
	if _is_strip():
		# The words of a hidden card are not laid out.
		var height := size.y if is_visible_in_tree() else 0.0
		strip = minf(maxf(_STRIP, height) + _MARGIN, _board.size.y * (1.0 - _FOR_DRAWING))
	_board.keep_free(0.0 if _is_low() else strip, strip if _is_low() else 0.0)


func _stand_in_corner() -> void:
	var is_right := _corner in [PRESET_TOP_RIGHT, PRESET_BOTTOM_RIGHT]
	grow_horizontal = GROW_DIRECTION_BEGIN if is_right else GROW_DIRECTION_END
	var is_low := _corner in [PRESET_BOTTOM_LEFT, PRESET_BOTTOM_RIGHT]
	grow_vertical = GROW_DIRECTION_BEGIN if is_low else GROW_DIRECTION_END
	set_anchors_and_offsets_preset(_corner, PRESET_MODE_MINSIZE, _MARGIN)
