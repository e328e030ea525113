@tool
class_name BallsView
extends BoardPart
## All balls of a world in their true size, drawn in one go; where it shows a mistake, outlines with
## a cross.

## Colour of the balls.
@export var role := Palette.Role.A
## Outlines with a cross: the balls that a mistake moves.
@export var is_wrong := false

## Where the time of drawing is counted.
var meter: FrameMeter

var _world: SteppedWorld
# A disc for each radius in pixels.
var _discs: Dictionary[float, Texture2D] = {}


## Shows the balls of [param world] where they are now; null for none.
func show_world(world: SteppedWorld) -> void:
	_world = world
	queue_redraw()


func _draw() -> void:
	if not _world:
		return
	meter.start()
	var color := Palette.color(role)
	# As Board.to_screen, once for all balls: they are never far away, and there may be many.
	var origin := board.to_screen(Vec2.new())
	var unit := Vector2(1.0, board.y_sign()) * board.pixels_per_unit
	for i in _world.balls.size():
		if _world.is_lost[i] == 0:
			var ball := _world.balls[i]
			var middle := origin + ball.position.to_vector2() * unit
			_draw_ball(middle, maxf(ball.radius * unit.x, 2.0), color)
	meter.stop()


func _draw_ball(middle: Vector2, pixels: float, color: Color) -> void:
	if is_wrong:
		var arm := Vector2(pixels, pixels) * 0.5
		draw_circle(middle, pixels, color, false, 2.5, true)
		draw_line(middle - arm, middle + arm, color, 2.0)
		draw_line(middle + Vector2(arm.x, -arm.y), middle + Vector2(-arm.x, arm.y), color, 2.0)
	else:
		var disc := _disc(pixels, color)
		draw_texture(disc, middle - disc.get_size() / 2.0)


# The rim lies inside the ball, so that its edge is where the ball ends.
func _disc(pixels: float, color: Color) -> Texture2D:
	var radius := snappedf(maxf(pixels - DotTexture.RIM / 2.0, 1.0), 0.25)
	if not _discs.has(radius):
		_discs[radius] = DotTexture.of(color.lerp(Palette.PAPER, 0.7), color, radius)
	return _discs[radius]
