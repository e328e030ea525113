@tool
class_name FlightLine
extends BoardPart
## The way of the ball's centre through the frame: thin as a whole, thick as far as it has come.

## Colour of the line.
@export var role := Palette.Role.INK
## Dashed: the way of a wrong ball.
@export var dashed := false

var _whole: Array[Vec2] = []
var _flown: Array[Vec2] = []


## Shows [param flight] as it is after the [param fraction] of the frame.
func show_flight(flight: BallFlight, fraction: float) -> void:
	_whole = flight.corners(1.0)
	_flown = flight.corners(fraction)
	queue_redraw()


func _draw() -> void:
	_draw_way(_whole, 1.0)
	_draw_way(_flown, 3.0)


func _draw_way(corners: Array[Vec2], width: float) -> void:
	var color := Palette.color(role)
	for i in range(1, corners.size()):
		var from := board.to_screen(corners[i - 1])
		var to := board.to_screen(corners[i])
		if dashed:
			draw_strokes(from, to, color, width)
		else:
			draw_line(from, to, color, width, true)
