@tool
class_name HitRings
extends BoardPart
## Rings that spread from a hit and fade.

const _SECONDS := 0.8
const _RINGS := 3
const _REACH := 70.0

var _place := Vec2.new()
var _since := INF


## Shows the rings of a hit at [param place], [param since] seconds after it.
func show_hit(place: Vec2, since: float) -> void:
	var was_seen := _since < _SECONDS
	_place = place.copy()
	_since = since
	if was_seen or _since < _SECONDS:
		queue_redraw()


func _draw() -> void:
	if not (_since >= 0.0 and _since < _SECONDS):
		return
	var share := _since / _SECONDS
	for ring in _RINGS:
		var radius := _REACH * share * (ring + 1.0) / _RINGS + GameTarget.RADIUS
		var color := Color(Palette.color(Palette.Role.RIGHT), 1.0 - share)
		draw_arc(
			board.to_screen(_place),
			radius * board.pixels_per_unit,
			0.0,
			TAU,
			48,
			color,
			Palette.stroke(3.0),
			true
		)
