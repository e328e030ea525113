@tool
class_name AxisTicks
extends BoardPart
## Ticks along the three axes of the picture in space, the last one of each with its number.

# At most so many ticks an axis, and none closer to each other than this, in pixels.
const _MOST := 5.0
const _CLOSEST := 16.0
const _HALF_TICK := 4.0
# From the axis to the middle of a number, in pixels.
const _BESIDE := 15.0
const _FONT_SIZE := 14

var _view := Axonometry.new()
var _reach := 0.0


## Shows ticks up to [param reach] on axes that are seen as in [param view].
func show_view(view: Axonometry, reach: float) -> void:
	_view = view
	_reach = reach
	queue_redraw()


func _draw() -> void:
	var step := _step()
	var count := floori(_reach / step)
	for axis in 3:
		if board.to_screen(Vec2.new()).distance_to(_pixel_of(axis, step)) >= _CLOSEST:
			for i in count:
				_draw_tick(axis, step * (i + 1), i == count - 1)


# 1, 2 or 5 times a power of ten.
func _step() -> float:
	var power := 10.0 ** floorf(log(maxf(_reach / _MOST, 1.0)) / log(10.0))
	for times: float in [1.0, 2.0, 5.0]:
		if _reach <= _MOST * times * power:
			return times * power
	return 10.0 * power


func _draw_tick(axis: int, value: float, has_number: bool) -> void:
	var at := _pixel_of(axis, value)
	var across := board.to_screen(Vec2.new()).direction_to(at).orthogonal()
	var color := Palette.color(Palette.Role.QUIET)
	draw_line(at - across * _HALF_TICK, at + across * _HALF_TICK, color, 2.0, true)
	if has_number:
		draw_text(NumberText.short(value), at - across * _BESIDE, color, _FONT_SIZE)


func _pixel_of(axis: int, value: float) -> Vector2:
	var place: PackedFloat64Array = [0.0, 0.0, 0.0]
	place[axis] = value
	return board.to_screen(_view.seen_at(place[0], place[1], place[2]))
