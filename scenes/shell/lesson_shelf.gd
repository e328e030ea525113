class_name LessonShelf
extends Container
## Headings and the cards below them, in as many equal columns as there is room for, without a hole
## between the parts: a part begins beside the end of the one before. A line above the cards shows
## which belong together; where it goes on in the next row it has no heading again.

## A column is never narrower, in pixels.
const NARROWEST := 264.0
const _GAP := 16.0
## Between the line above the cards and what is above and below it.
const _AROUND_LINE := Vector2(12.0, 4.0)

var _height := 0.0
# Where the lines are drawn, each as a rectangle without height.
var _lines: Array[Rect2] = []


## Puts the cards below the heading that comes before them in the tree.
func _notification(what: int) -> void:
	if what == NOTIFICATION_SORT_CHILDREN:
		_lay()
	elif what == NOTIFICATION_TRANSLATION_CHANGED:
		queue_sort()


func _get_minimum_size() -> Vector2:
	return Vector2(0.0, _height)


func _draw() -> void:
	for line in _lines:
		draw_line(line.position, line.end, Palette.BORDER, 2.0)


## The cards in their order.
func cards() -> Array[ShelfCard]:
	var found: Array[ShelfCard] = []
	for child in get_children():
		if child is ShelfCard:
			found.append(child as ShelfCard)
	return found


func _lay() -> void:
	_lines.clear()
	var columns := maxi(floori((size.x + _GAP) / (NARROWEST + _GAP)), 1)
	var width := (size.x - _GAP * (columns - 1)) / columns
	var all := cards()
	var y := 0.0
	for first in range(0, all.size(), columns):
		var row := all.slice(first, first + columns)
		y = _lay_headings(row, width, y)
		y = _lay_cards(row, width, y) + _GAP
	if _height != y - _GAP:
		_height = y - _GAP
		update_minimum_size()
	queue_redraw()


# Each heading above its first card, as wide as its cards in this row. Returns where cards begin.
func _lay_headings(row: Array[ShelfCard], width: float, y: float) -> float:
	var begun := _places_of_headings(row)
	# A row in the middle of a part.
	if begun.is_empty():
		return y
	var top := y + _AROUND_LINE.x + _AROUND_LINE.y
	var bottom := top
	if begun[0] > 0:
		begun.insert(0, 0)
	for i in begun.size():
		var end := begun[i + 1] if i + 1 < begun.size() else row.size()
		var extent := (width + _GAP) * (end - begun[i]) - _GAP
		var left := (width + _GAP) * begun[i]
		_lines.append(Rect2(left, y + _AROUND_LINE.x, extent, 0.0))
		var heading := _heading_of(row[begun[i]])
		if heading:
			var height := heading.lay(extent)
			fit_child_in_rect(heading, Rect2(left, top, extent, height))
			bottom = maxf(bottom, top + height)
	return bottom + _AROUND_LINE.x


func _places_of_headings(row: Array[ShelfCard]) -> PackedInt32Array:
	var found: PackedInt32Array = []
	for place in row.size():
		if _heading_of(row[place]):
			found.append(place)
	return found


# The heading right before a card; null where the card is not the first one of its part.
func _heading_of(card: ShelfCard) -> LessonHeading:
	return get_child(card.get_index() - 1) as LessonHeading if card.get_index() else null


# All as high as the highest. Returns where they end.
func _lay_cards(row: Array[ShelfCard], width: float, y: float) -> float:
	var height := 0.0
	for card in row:
		height = maxf(height, card.lay(width))
	for place in row.size():
		fit_child_in_rect(row[place], Rect2((width + _GAP) * place, y, width, height))
	return y + height
