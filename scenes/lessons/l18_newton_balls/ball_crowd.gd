@tool
class_name BallCrowd
extends BoardPart
## All balls of the lesson in their true size, drawn in one go. The two that the formula is about
## have their numbers and colors.

const _FONT_SIZE := 22
# A smaller ball has no room for its number, in pixels.
const _ROOM_FOR_NUMBER := 28.0
# In 32 bits a circle larger than this is drawn wrongly.
const _LARGEST := 2000.0

## The centres of the balls, in units of the plane.
@export var centers: PackedVector2Array:
	set(value):
		centers = value
		show_change()
## Their radii.
@export var radii: PackedFloat32Array:
	set(value):
		radii = value
		show_change()
## Which ball is ball 1 and which is ball 2, counted from 0.
@export var numbered := Vector2i(0, 1)

# A disc for each radius in pixels and color.
var _discs: Dictionary[String, Texture2D] = {}


## Shows these balls, each [param moved] by the same vector; [param first] is ball 1,
## [param second] is ball 2.
func show_balls(balls: Array[Ball], moved: Vec2, first: int, second: int) -> void:
	var places: PackedVector2Array = []
	var sizes: PackedFloat32Array = []
	for ball in balls:
		places.append(ball.position.plus(moved).to_vector2())
		sizes.append(ball.radius)
	numbered = Vector2i(first, second)
	radii = sizes
	centers = places


func spanned_points() -> Array[Vec2]:
	var found: Array[Vec2] = []
	for center in centers:
		found.append(Vec2.from_vector2(center))
	return found


func _draw() -> void:
	for index: int in mini(centers.size(), radii.size()):
		var place := Vec2.from_vector2(centers[index])
		var pixels := clampf(radii[index] * board.pixels_per_unit, 2.0, _LARGEST)
		var color := Palette.color(_role_of(index))
		var middle := board.to_screen(place)
		var disc := _disc(pixels, color)
		draw_texture(disc, middle - disc.get_size() / 2.0)
		if index in [numbered.x, numbered.y] and pixels >= _ROOM_FOR_NUMBER:
			var number := "1" if index == numbered.x else "2"
			draw_text_at(number, middle + Vector2(0.0, pixels * 0.45), color, _FONT_SIZE)


func _role_of(index: int) -> Palette.Role:
	if index == numbered.x:
		return Palette.Role.A
	return Palette.Role.B if index == numbered.y else Palette.Role.QUIET


# The rim lies inside the ball: its outer edge is the ball's.
func _disc(pixels: float, color: Color) -> Texture2D:
	var rim := snappedf(maxf(pixels - DotTexture.RIM / 2.0, 1.0), 0.25)
	var key := "%s %s" % [rim, color.to_html()]
	if not _discs.has(key):
		_discs[key] = DotTexture.of(color.lerp(Palette.drawn(Palette.PAPER), 0.75), color, rim)
	return _discs[key]
