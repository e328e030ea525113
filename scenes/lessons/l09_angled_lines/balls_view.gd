@tool
class_name BallsView
extends BoardPart
## All balls of a world in their true size, drawn in one go. Balls that a mistake moves are outlines
## with a cross.

## The centres of the balls at the start, in units of the plane.
@export var centers: PackedVector2Array:
	set(value):
		centers = value
		show_change()
## Their velocities at the start, in px/s: one for each of [member centers].
@export var velocities: PackedVector2Array
## The radius of each of them at the start.
@export_range(0.1, 200.0, 0.1, "suffix:px") var radius := 1.0:
	set(value):
		radius = value
		show_change()
## Colour of the balls.
@export var role := Palette.Role.A
## Draws outlines with a cross: the balls that a mistake moves.
@export var is_wrong := false

## Measures the time of drawing.
var meter: FrameMeter

var _world: SteppedWorld
# A disc for each radius in pixels.
var _discs: Dictionary[float, Texture2D] = {}


## Shows the balls of [param world] where they are now; null for none.
func show_world(world: SteppedWorld) -> void:
	_world = world
	queue_redraw()


## Copies of the balls at the start. Where there is not one velocity for each centre, that is pushed
## as an error.
func balls_at_start() -> Array[Ball]:
	var found: Array[Ball] = []
	if velocities.size() != centers.size():
		push_error("%d balls cannot have %d velocities." % [centers.size(), velocities.size()])
	for i in mini(centers.size(), velocities.size()):
		var velocity := Vec2.from_vector2(velocities[i])
		found.append(Ball.new(Vec2.from_vector2(centers[i]), radius, velocity))
	return found


func spanned_points() -> Array[Vec2]:
	var found: Array[Vec2] = []
	for center in centers:
		found.append(Vec2.from_vector2(center))
	return found


func _draw() -> void:
	if _world:
		_draw_world()
	elif Engine.is_editor_hint():
		for center in centers:
			var middle := board.to_screen(Vec2.from_vector2(center))
			_draw_ball(middle, radius * board.pixels_per_unit, Palette.color(role))


func _draw_world() -> void:
	meter.start()
	var color := Palette.color(role)
	# The same as Board.to_screen, but with one call for all balls: there may be many. That they may
	# be far away plays no part, because a lost ball is not drawn.
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


# The rim lies inside the ball: its outer edge is the ball's.
func _disc(pixels: float, color: Color) -> Texture2D:
	var rim := snappedf(maxf(pixels - DotTexture.RIM / 2.0, 1.0), 0.25)
	if not _discs.has(rim):
		_discs[rim] = DotTexture.of(color.lerp(Palette.drawn(Palette.PAPER), 0.7), color, rim)
	return _discs[rim]
