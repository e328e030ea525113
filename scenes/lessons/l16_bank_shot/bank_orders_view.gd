@tool
class_name BankOrdersView
extends BoardPart
## All orders of walls: each way to the target as a thin line, each refused one as far as it gets,
## in strokes and with a cross.

const _CROSS := 7.0

var _ways: Array[BankWay] = []
var _start := Vec2.new()


## Shows [param ways] of a ball from [param start]. Those without a direction are left out.
func show_ways(ways: Array[BankWay], start: Vec2) -> void:
	_ways = ways
	_start = start.copy()
	queue_redraw()


func _draw() -> void:
	for way in _ways:
		if not way.images.is_empty():
			_draw_way(way)


func _draw_way(way: BankWay) -> void:
	var color := Palette.color(Palette.Role.A if way.hit else Palette.Role.QUIET)
	var places: Array[Vec2] = [_start]
	places.append_array(way.bounces)
	# One that does not come to a wall ends on its way to the image.
	if way.hit or way.outcome == BankWay.Outcome.BLOCKED and way.bounces.size() == way.walls.size():
		places.append(way.images[-1])
	elif way.bounces.is_empty():
		places.append(_start.lerped(way.images[0], 0.5))
	for at in range(1, places.size()):
		var from := board.to_screen(places[at - 1])
		var to := board.to_screen(places[at])
		if way.hit:
			draw_line(from, to, color, Palette.stroke(2.0), true)
		else:
			draw_strokes(from, to, color, 1.5)
	if not way.hit:
		var ends_at_wall := way.outcome != BankWay.Outcome.BLOCKED and not way.bounces.is_empty()
		var fault := places[-1] if ends_at_wall else places[-2].lerped(places[-1], 0.5)
		_draw_cross(board.to_screen(fault))


func _draw_cross(middle: Vector2) -> void:
	var color := Palette.color(Palette.Role.WRONG)
	for corner: Vector2 in [Vector2(_CROSS, _CROSS), Vector2(_CROSS, -_CROSS)]:
		draw_line(middle - corner, middle + corner, color, Palette.stroke(2.5), true)
