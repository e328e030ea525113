class_name MoreDimensionsLayout
extends RefCounted
## Where the picture in space and the bars are on the board.

# Pixels between the card and the bars below it.
const _GAP := 8.0
# So much of a narrow board the picture takes; the bars have the rest.
const _UPPER_SHARE := 0.58
const _SIDES: Array[Side] = [SIDE_LEFT, SIDE_TOP, SIDE_RIGHT, SIDE_BOTTOM]

var _board: Board
var _picture: Control
var _bars: Control
var _place_of_bars: Control
var _hint: Control
var _card: Control


## Of the parts of [param board] in the scene of the lesson.
func _init(board: Board) -> void:
	_board = board
	_picture = board.get_node(^"%Picture")
	_bars = board.get_node(^"%Bars")
	_place_of_bars = board.get_node(^"%PlaceOfBars")
	_hint = board.get_node(^"%Hint")
	_card = board.get_node(^"%VerdictCard")


## Three axes fit into a picture; with more, [param is_beyond_space], the bars take its place, below
## the card. The picture is beside the bars, or above them where the board is narrow.
func arrange(is_beyond_space: bool) -> void:
	var is_small := _board.is_small()
	var is_narrow := _board.size.x < Board.SMALL
	_picture.anchor_right = 1.0 if is_narrow else 0.5
	_picture.anchor_bottom = _UPPER_SHARE if is_narrow else 1.0
	_picture.offset_bottom = -_GAP if is_small else _hint.offset_top
	_place_of_bars.anchor_left = 0.0 if is_narrow else 0.5
	_place_of_bars.anchor_top = _UPPER_SHARE if is_narrow else 0.0
	_place_of_bars.anchor_bottom = 1.0 if is_small else 0.5
	if is_beyond_space and is_small:
		_bars.set_anchors_and_offsets_preset(
			Control.PRESET_FULL_RECT, Control.PRESET_MODE_MINSIZE, int(_GAP)
		)
	else:
		_place_bars(is_beyond_space)


func _place_bars(is_beyond_space: bool) -> void:
	var place := _picture if is_beyond_space else _place_of_bars
	for side in _SIDES:
		_bars.set_anchor_and_offset(side, place.get_anchor(side), place.get_offset(side))
	if is_beyond_space:
		_bars.offset_top += _card.get_combined_minimum_size().y + _GAP
