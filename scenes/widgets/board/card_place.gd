class_name CardPlace
extends Node
## Where a card is that lies on a board: there, or in the panel while the board is too small for
## both.

## The card has come into the panel, or back to the board.
signal changed

# The sides of its place on the board.
const _SIDES: Array[Side] = [SIDE_LEFT, SIDE_TOP, SIDE_RIGHT, SIDE_BOTTOM]

var _card: Control
var _board: Board
var _above: Control
var _home: Node
# The scene in which its unique name counts.
var _scene: Node
var _index: int
var _anchors: PackedFloat32Array = []
var _offsets: PackedFloat32Array = []


## Of [param card], which lies on [param board] now; in the panel it is below [param above], which
## is there.
func _init(card: Control, board: Board, above: Control) -> void:
	_card = card
	_board = board
	_above = above
	_home = card.get_parent()
	_scene = card.owner


func _ready() -> void:
	_board.resized.connect(_choose)
	_choose()


func _choose() -> void:
	if _board.size == Vector2.ZERO:
		return
	var fits := not _board.is_small()
	if not fits and _card.get_parent() == _home:
		_go_into_panel()
	elif fits and _card.get_parent() != _home:
		_go_back()


func _go_into_panel() -> void:
	_index = _card.get_index()
	_anchors = _SIDES.map(_card.get_anchor)
	_offsets = _SIDES.map(_card.get_offset)
	_card.reparent(_above.get_parent(), false)
	_above.get_parent().move_child(_card, _above.get_index() + 1)
	changed.emit()


# A container has moved its sides.
func _go_back() -> void:
	_card.reparent(_home, false)
	_card.owner = _scene
	# Others may not be back yet.
	_home.move_child(_card, mini(_index, _home.get_child_count() - 1))
	for side in _SIDES:
		_card.set_anchor_and_offset(side, _anchors[side], _offsets[side], true)
	changed.emit()
