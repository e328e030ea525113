@tool
class_name BallTrails
extends BoardPart
## The paths that the balls of a world have taken, frame by frame and through every point of impact;
## forgets the latest frame when time goes back.

# At most this many frames are drawn, of all balls together.
const _MOST_FRAMES := 1500
# At most this many frames are kept to go back.
const _LONGEST := 1800

# More trails than this are drawn as hairlines, with one stroke for two frames: they cross each
# other so often that nobody sees the difference.
const _MOST_BROAD := 20
# Wide enough to be seen from the back of a classroom, in pixels.
const _WIDTH := 3.0
# From the end of a trail to a point where the line has faded out, in pixels of the plane.
const _SEAM := Vector2(0.01, 0.0)

## Colour of the lines.
@export var role := Palette.Role.A

# The strokes of each ball's path: the start and the end of each stroke.
var _trails: Array[PackedVector2Array] = []
# How many strokes each ball got in each frame; the latest frame is last.
var _counts: Array[PackedInt32Array] = []
# Whether the next frame gets strokes of its own, or makes the latest ones longer.
var _is_new_stroke := true


## Forgets all paths and begins new ones where the balls of [param world] are.
func begin(world: SteppedWorld) -> void:
	_counts.clear()
	_trails.clear()
	_is_new_stroke = true
	for ball in world.balls:
		var place := ball.position.to_vector2()
		_trails.append(PackedVector2Array([place, place]))
	queue_redraw()


## Adds the latest step of [param world].
func add_frame(world: SteppedWorld) -> void:
	var counts: PackedInt32Array = []
	counts.resize(world.balls.size())
	for record in world.latest_bounces:
		_add_stroke(record.ball_index, record.position.to_vector2())
		counts[record.ball_index] += 1
	for i in world.balls.size():
		var place := world.balls[i].position.to_vector2()
		if _is_new_stroke or counts[i] > 0:
			_add_stroke(i, place)
			counts[i] += 1
		else:
			_trails[i][-1] = place
	_counts.append(counts)
	_shorten()
	_turn_stroke()
	queue_redraw()


## Takes the latest frame away; [param world] is as it was before that frame.
func remove_frame(world: SteppedWorld) -> void:
	if _counts.is_empty():
		return
	var counts: PackedInt32Array = _counts.pop_back()
	for i in _trails.size():
		_trails[i].resize(maxi(_trails[i].size() - 2 * counts[i], 2))
		_trails[i][-1] = world.balls[i].position.to_vector2()
	_turn_stroke()
	queue_redraw()


## Whether each trail ends where its ball in [param world] is: then it can go on.
func lead_to(world: SteppedWorld) -> bool:
	if _trails.size() != world.balls.size():
		return false
	for i in _trails.size():
		if _trails[i][-1] != world.balls[i].position.to_vector2():
			return false
	return true


## The places of the trail of one ball, the latest last.
func places_of(index: int) -> PackedVector2Array:
	var trail := _trails[index]
	var places: PackedVector2Array = []
	for i in range(1, trail.size(), 2):
		places.append(trail[i])
	return places


func _add_stroke(index: int, place: Vector2) -> void:
	var trail := _trails[index]
	trail.append(trail[-1])
	trail.append(place)


func _turn_stroke() -> void:
	_is_new_stroke = not _is_new_stroke or not _has_hairlines()


func _has_hairlines() -> bool:
	return _trails.size() > _MOST_BROAD


func _shorten() -> void:
	var frames_per_stroke := 2.0 if _has_hairlines() else 1.0
	var most := floori(_MOST_FRAMES / frames_per_stroke / maxi(_trails.size(), 1))
	var longest := mini(most, _LONGEST)
	if _counts.size() > _LONGEST:
		_counts.pop_front()
	for i in _trails.size():
		# Cut seldom and a lot: each cut copies the array.
		if _trails[i].size() > 2.5 * longest:
			_trails[i] = _trails[i].slice(_trails[i].size() - 2 * longest)


# All trails are drawn with one call, because a call costs as much as a long trail.
func _draw() -> void:
	var scale_now := board.pixels_per_unit
	draw_set_transform(board.to_screen(Vec2.new()), 0.0, Vector2(scale_now, scale_now))
	if _has_hairlines():
		_draw_hairlines()
	elif _trails:
		_draw_broad(_WIDTH / scale_now)


# One pixel wide at any scale, and the cheapest lines there are.
func _draw_hairlines() -> void:
	var strokes: PackedVector2Array = []
	for trail in _trails:
		strokes.append_array(trail)
	draw_multiline(strokes, _color())


# One line through all places. From the end of a trail to the start of the next it is invisible.
func _draw_broad(width: float) -> void:
	var places: PackedVector2Array = []
	var seams: PackedInt32Array = []
	for trail in _trails:
		seams.append(places.size())
		places.append(trail[0] - _SEAM)
		for i in range(2, trail.size(), 2):
			places.append(trail[i])
		places.append(trail[-1])
		seams.append(places.size())
		places.append(trail[-1] + _SEAM)
	draw_polyline_colors(places, _colors_of(places.size(), seams), width)


func _colors_of(count: int, seams: PackedInt32Array) -> PackedColorArray:
	var colors: PackedColorArray = []
	colors.resize(count)
	colors.fill(_color())
	for seam in seams:
		colors[seam] = Color(_color(), 0.0)
	return colors


func _color() -> Color:
	return Color(Palette.color(role), 0.55)
