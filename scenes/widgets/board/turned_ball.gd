@tool
class_name TurnedBall
extends BallView
## A ball with two spokes, so that one sees how far it has turned.

## How far it has turned from the start, in radians, clockwise as long as y points down.
@export var turn := 0.0:
	set(value):
		turn = value
		queue_redraw()


func _draw() -> void:
	var middle := board.to_screen(at())
	var pixels := radius * board.pixels_per_unit
	var color := Color(Palette.color(role), 0.8)
	for quarter: int in 2:
		var spoke := Vec2.unit_radians(turn + quarter * PI / 2.0)
		var reach := board.direction_to_screen(spoke) * pixels
		draw_line(middle - reach, middle + reach, color, Palette.stroke(1.5), true)
	# The first half spoke is the one to follow.
	var first := board.direction_to_screen(Vec2.unit_radians(turn)) * pixels
	draw_line(middle, middle + first, Palette.color(role), Palette.stroke(3.5), true)
	super()
