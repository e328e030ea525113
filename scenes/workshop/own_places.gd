class_name OwnPlaces
extends RefCounted
## Finds places for words on a board on which a lesson has drawn already: beside what they are
## about, and where they hide as little as possible.

const _DIRECTIONS := 8
# Pixels between what the words are about and the words: the nearest that is free is best.
const _GAPS: PackedFloat64Array = [10.0, 36.0, 70.0, 110.0, 150.0]
# What it costs to hide a card or other words, compared with a point of an arrow or a ball, and to
# be one gap further away, or one direction beside the wanted one.
const _COST_OF_CARD := 100.0
const _COST_OF_GAP := 0.8
const _COST_OF_TURN := 0.3
const _POINTS := 12
# Half of what a name takes, in pixels.
const _HALF_NAME := 16.0
# A larger handle is no point, but lies along an arrow.
const _LARGEST_HANDLE := 80.0
const _EDGE := 5.0

var _board: Board
var _cards: Array[Rect2] = []
var _points: PackedVector2Array = []


## Looks at what [param board] shows now.
func _init(board: Board) -> void:
	_board = board
	for child in board.get_children():
		if (child is PanelContainer or child is Plot) and (child as Control).visible:
			_cards.append((child as Control).get_rect())
	for part: BoardPart in board.find_children("*", "BoardPart", true, false):
		if part.board == board and part.is_visible_in_tree():
			_keep_off(part)
	for handle in board.handles():
		if handle.size.x < _LARGEST_HANDLE:
			_points.append(handle.global_position - board.global_position + handle.size / 2.0)


## The middle of words of the size [param extent] about [param around], in the board's pixels, which
## is [param reach] wide to each side; if possible in the direction [param aside] from there. Later
## words keep off it.
func take(around: Vector2, reach: float, aside: Vector2, extent: Vector2) -> Vector2:
	# What is outside of the board has its words at the edge.
	var room := _board.free_area()
	var anchor := around.clamp(room.position, room.end)
	var best := anchor
	var least := INF
	for turn in _DIRECTIONS:
		# To both sides in turns: 0, 1, -1, 2, -2 ...
		var steps := ceili(turn / 2.0)
		var direction := aside.rotated(TAU / _DIRECTIONS * (steps if turn % 2 == 1 else -steps))
		for gap in _GAPS.size():
			var middle := _beside(anchor, reach + _GAPS[gap], direction, extent)
			var cost := _cost_of(Rect2(middle - extent / 2.0, extent))
			cost += gap * _COST_OF_GAP + steps * _COST_OF_TURN
			if cost < least:
				least = cost
				best = middle
	_cards.append(Rect2(best - extent / 2.0, extent))
	return best


func _beside(around: Vector2, gap: float, direction: Vector2, extent: Vector2) -> Vector2:
	var half := absf(direction.x) * extent.x / 2.0 + absf(direction.y) * extent.y / 2.0
	var room := _board.free_area().grow_individual(
		-extent.x / 2.0 - _EDGE,
		-extent.y / 2.0 - _EDGE,
		-extent.x / 2.0 - _EDGE,
		-extent.y / 2.0 - _EDGE
	)
	return (around + direction * (gap + half)).clamp(room.position, room.end.max(room.position))


func _cost_of(place: Rect2) -> float:
	var cost := 0.0
	for card in _cards:
		if card.grow(3.0).intersects(place):
			cost += _COST_OF_CARD
	var near := place.grow(4.0)
	for point in _points:
		if near.has_point(point):
			cost += 1.0
	return cost


func _keep_off(part: BoardPart) -> void:
	if part is Arrow:
		_keep_off_arrow(part as Arrow)
	elif part is DimensionLine:
		var dimension := part as DimensionLine
		_keep_off_name(dimension.label_pixel())
		_points.append(_board.to_screen(Vec2.from_vector2(dimension.from)))
		_points.append(_board.to_screen(Vec2.from_vector2(dimension.to)))
	elif part is BallView:
		_keep_off_disc((part as BallView).at(), (part as BallView).radius)
	elif part is TargetMark:
		var target := part as TargetMark
		_keep_off_disc(target.at(), target.radius)
		if target.label:
			_keep_off_name(target.label_pixel())
	elif part is AngleArc and (part as AngleArc).shows_value:
		_keep_off_name((part as AngleArc).label_pixel())


func _keep_off_arrow(arrow: Arrow) -> void:
	var tail := _board.to_screen(Vec2.from_vector2(arrow.tail))
	var head := _board.to_screen(Vec2.from_vector2(arrow.head))
	for i in _POINTS + 1:
		_points.append(tail.lerp(head, float(i) / _POINTS))
	if arrow.label:
		_keep_off_name(arrow.label_pixel())


func _keep_off_disc(center: Vec2, radius: float) -> void:
	var middle := _board.to_screen(center)
	_points.append(middle)
	for i in _POINTS:
		var out := Vector2.from_angle(TAU * i / _POINTS)
		_points.append(middle + out * radius * _board.pixels_per_unit)


func _keep_off_name(middle: Vector2) -> void:
	for beside: float in [-_HALF_NAME, 0.0, _HALF_NAME]:
		_points.append(middle + Vector2(beside, 0.0))
