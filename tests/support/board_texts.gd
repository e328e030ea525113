class_name BoardTexts
extends RefCounted
## The texts that are drawn on the boards of a lesson: which are cut off, covered by a card, or lie
## on each other. The numbers of the axes are left out: everything lies on top of them.

# Letters that touch by less can still be read.
const _TOUCH := 2.0

var _lesson: Lesson
var _texts: Array[Drawn] = []


## A text as it was drawn.
class Drawn:
	extends RefCounted
	var part: BoardPart
	var text: String
	var letters: Rect2
	var font_size: int


## Has all that is on the boards of [param lesson] drawn anew, and listens. What was drawn is known
## after the next frame.
func listen(lesson: Lesson) -> void:
	_lesson = lesson
	_texts.clear()
	for part in parts():
		var note := _note.bind(part)
		if not part.text_drawn.is_connected(note):
			part.text_drawn.connect(note)
			# Emitted before the part draws.
			part.draw.connect(_forget.bind(part))
		part.queue_redraw()


## All parts of the boards that can be seen.
func parts() -> Array[BoardPart]:
	var found: Array[BoardPart] = []
	_find_parts(_lesson, found)
	return found


## One sentence for each text that the edge of its board cuts off.
func cut_off_ones() -> PackedStringArray:
	var found: PackedStringArray = []
	for drawn in _texts:
		var room := Rect2(Vector2.ZERO, drawn.part.board.size)
		if room.intersects(drawn.letters) and not room.grow(1.0).encloses(drawn.letters):
			found.append("“%s” on the board is cut off" % drawn.text)
	return found


## One sentence for each text on which a card or another text lies. In extreme states that cannot
## be helped.
func covered_ones() -> PackedStringArray:
	var found: PackedStringArray = []
	for i: int in _texts.size():
		for card in Layout.cards(_texts[i].part.board):
			if _lie_on_each_other(card.get_rect(), _texts[i].letters):
				found.append("%s lies on “%s”" % [card.name, _texts[i].text])
		for j: int in i:
			if (
				_can_strike(_texts[i], _texts[j])
				and _lie_on_each_other(_texts[i].letters, _texts[j].letters)
			):
				found.append("“%s” lies on “%s” on the board" % [_texts[i].text, _texts[j].text])
	return found


## The smallest letters, in pixels of the board; INF where there is no text.
func smallest() -> float:
	var least := INF
	for drawn in _texts:
		least = minf(least, drawn.font_size)
	return least


# A part can draw twice in a frame.
func _forget(part: BoardPart) -> void:
	_texts = _texts.filter(func(drawn: Drawn) -> bool: return drawn.part != part)


func _note(text: String, letters: Rect2, font_size: int, part: BoardPart) -> void:
	var drawn := Drawn.new()
	drawn.part = part
	drawn.text = text
	drawn.letters = part.get_transform() * letters
	drawn.font_size = font_size
	_texts.append(drawn)


# The same text in the same place reads as one, such as that of an arrow that begins to turn.
static func _can_strike(one: Drawn, other: Drawn) -> bool:
	var is_one_text := one.text == other.text and one.letters.is_equal_approx(other.letters)
	return one.part.board == other.part.board and not is_one_text


static func _lie_on_each_other(one: Rect2, other: Rect2) -> bool:
	var common := one.intersection(other)
	return minf(common.size.x, common.size.y) > _TOUCH


static func _find_parts(above: Node, found: Array[BoardPart]) -> void:
	if above is CanvasItem and not (above as CanvasItem).is_visible_in_tree():
		return
	if above is BoardPart and above is not GridLines:
		found.append(above as BoardPart)
	for child: Node in above.get_children():
		_find_parts(child, found)
