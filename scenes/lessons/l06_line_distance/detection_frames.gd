@tool
class_name DetectionFrames
extends BoardPart
## The ball in each frame of its flight, red where the test sees it, with the number of the frame.

const _FONT_SIZE := 18
const _FAINT := 0.5

var _centers: Array[Vec2] = []
var _is_red: Array[bool] = []
var _radius := 1.0


## Shows a ball of radius [param its_radius] at each of [param centers], from frame 0 on, and where
## it [param is_red].
func lay(centers: Array[Vec2], is_red: Array[bool], its_radius: float) -> void:
	_centers = centers
	_is_red = is_red
	_radius = its_radius
	queue_redraw()


func _draw() -> void:
	# In 32 bits a circle larger than 1e6 pixels is drawn wrongly.
	var pixels := clampf(_radius * board.pixels_per_unit, 1.5, 1e6)
	for frame: int in _centers.size():
		var middle := board.to_screen(_centers[frame])
		var color := Palette.color(Palette.Role.WRONG if _is_red[frame] else Palette.Role.INK)
		var is_last := frame == _centers.size() - 1
		if _is_red[frame]:
			draw_circle(middle, pixels, Color(color, 0.3), true, -1.0, true)
		var rim := color if is_last or _is_red[frame] else Color(color, _FAINT)
		draw_circle(middle, pixels, rim, false, 3.5 if is_last else 2.0, true)
		draw_text(str(frame), middle, color, _FONT_SIZE)
