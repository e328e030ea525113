@tool
class_name EndlessLineViews
extends BoardPart
## How lines go on beyond what is drawn of them, dashed to the edges of the board, with a normal to
## the side that works. Nothing is drawn of lines that end.

const _NORMAL_PIXELS := 30.0
const _TIP_PIXELS := 10.0
# The normals are there along a line, as a share of its drawn length: the drag of a line is at its
# middle.
const _NORMAL_SHARE := 0.35

var _lines: Array[LineSegment] = []


## Shows the endless lines [param lines]; none for an empty list.
func show_lines(lines: Array[LineSegment]) -> void:
	_lines = lines
	queue_redraw()


func _draw() -> void:
	for line in _lines:
		_draw_way_on(line)
		_draw_normal(line)


func _draw_way_on(line: LineSegment) -> void:
	var from := board.to_screen(line.start)
	var to := board.to_screen(line.end)
	var far := from.direction_to(to) * board.size.length()
	var color := Palette.color(Palette.Role.INK)
	draw_strokes(from, from - far, color, 2.0)
	draw_strokes(to, to + far, color, 2.0)


func _draw_normal(line: LineSegment) -> void:
	var color := Palette.color(Palette.Role.UNIT)
	var normal := line.normal().to_vector2()
	var foot := board.to_screen(line.start.lerped(line.end, _NORMAL_SHARE))
	var tip := foot + normal * _NORMAL_PIXELS
	draw_line(foot, tip - normal * _TIP_PIXELS, color, 3.0, true)
	var neck := tip - normal * _TIP_PIXELS
	var side := normal.orthogonal() * _TIP_PIXELS / 2.0
	draw_primitive([tip, neck + side, neck - side], [color], [])
