class_name BallTrails
extends BoardPart
## The paths that the balls of a world have taken, frame by frame and through every point of impact;
## forgets the latest frame when time goes back.

# Places of all balls together that are drawn at most; a single ball keeps a shorter trail still.
const _MOST_PLACES := 2000
const _LONGEST := 1800
# More trails than this are drawn as hairlines: so many cross each other anyway.
const _MOST_BROAD := 20
# From the end of a trail to where it cannot be seen any more, in pixels of the plane.
const _SEAM := Vector2(0.01, 0.0)

## Colour of the lines.
@export var role := Palette.Role.A

var _trails: Array[PackedVector2Array] = []
# How many places each ball got in each frame, the latest last.
var _counts: Array[PackedInt32Array] = []


## Forgets all paths and begins new ones where the balls of [param world] are.
func begin(world: SteppedWorld) -> void:
	_counts.clear()
	_trails.clear()
	for ball in world.balls:
		_trails.append(PackedVector2Array([ball.position.to_vector2()]))
	queue_redraw()


## Adds the latest step of [param world].
func add_frame(world: SteppedWorld) -> void:
	var counts: PackedInt32Array = []
	counts.resize(world.balls.size())
	for record in world.latest_bounces:
		_trails[record.ball_index].append(record.position.to_vector2())
		counts[record.ball_index] += 1
	for i in world.balls.size():
		_trails[i].append(world.balls[i].position.to_vector2())
		counts[i] += 1
	_counts.append(counts)
	_shorten()
	queue_redraw()


## Takes the latest frame away again.
func remove_frame() -> void:
	if _counts.is_empty():
		return
	var counts: PackedInt32Array = _counts.pop_back()
	for i in _trails.size():
		_trails[i].resize(maxi(_trails[i].size() - counts[i], 0))
	queue_redraw()


## How many places the trail of one ball has now.
func length_of(index: int) -> int:
	return _trails[index].size()


func _shorten() -> void:
	var longest := mini(floori(float(_MOST_PLACES) / maxi(_trails.size(), 1)), _LONGEST)
	if _counts.size() > _LONGEST:
		_counts.pop_front()
	for i in _trails.size():
		# Cut rarely and much: cutting moves the whole array.
		if _trails[i].size() > longest * 1.25:
			_trails[i] = _trails[i].slice(_trails[i].size() - longest)


func _draw() -> void:
	var scale_now := board.pixels_per_unit
	draw_set_transform(board.to_screen(Vec2.new()), 0.0, Vector2(scale_now, scale_now))
	if _trails.size() > _MOST_BROAD:
		_draw_hairlines()
	else:
		_draw_broad(1.5 / scale_now)


# One pixel wide at any scale, and the cheapest line there is.
func _draw_hairlines() -> void:
	for trail in _trails:
		if trail.size() > 1:
			draw_polyline(trail, _color())


# All trails are one polyline, because each call of its own costs as much as a long trail: from the
# end of one to the start of the next it cannot be seen.
func _draw_broad(width: float) -> void:
	var points: PackedVector2Array = []
	var seams: PackedInt32Array = []
	for trail in _trails:
		if trail.size() > 1:
			seams.append(points.size())
			points.append(trail[0] - _SEAM)
			points.append_array(trail)
			seams.append(points.size())
			points.append(trail[-1] + _SEAM)
	if points:
		draw_polyline_colors(points, _colors_of(points.size(), seams), width)


func _colors_of(count: int, seams: PackedInt32Array) -> PackedColorArray:
	var colors: PackedColorArray = []
	colors.resize(count)
	colors.fill(_color())
	for seam in seams:
		colors[seam] = Color(_color(), 0.0)
	return colors


func _color() -> Color:
	return Color(Palette.color(role), 0.55)
