@tool
class_name EngineLane
extends BoardPart
## Godot's own body on the same shot as the selected ball: a ghost with its path, and the place
## where it parts from the ball. There is no such body while this is switched off, as at the start.

# From this distance on, in pixels of the plane, the body has parted from the ball.
const _PARTED := 1.0
const _ROLE := Palette.Role.REST
const _LONGEST := 1800
# Two texts whose middles are closer than this would overlap, in pixels of the screen.
const _TEXT_SIZE := Vector2(170.0, 20.0)

var _shot: EngineShot
var _radius := 0.0
var _first_seconds := 0.0
var _place: Vec2
var _gap := 0.0
var _path: Array[Vec2] = []
# The place of the body and the seconds since its start when it was first seen apart; null before.
var _parting: Vec2
var _parting_seconds := 0.0


func _exit_tree() -> void:
	super()
	_switch_off()


## Whether the body is there.
func is_on() -> bool:
	return _shot != null


## How far the body is from the ball, in pixels.
func gap() -> float:
	return _gap


## Lets the body start where the selected ball of [param model] is now, or takes it away. "" or one
## sentence on why there can be none.
func switch(on: bool, model: AngledLinesModel) -> String:
	if on and not model.has_endless_lines:
		_begin(model)
		return ""
	_switch_off()
	return tr("Godot's lines have ends here: choose lines that end first.") if on else ""


func _begin(model: AngledLinesModel) -> void:
	_switch_off()
	_shot = EngineShot.new(self, model.ball(), model.world.surroundings)
	_radius = model.ball().radius
	_first_seconds = model.elapsed_seconds()
	_path.clear()
	_parting = null
	show_moment(model)


## Lets the body start anew where it is switched on: the shot has changed. Among endless lines,
## which the body does not know, it is switched off.
func begin_anew(model: AngledLinesModel) -> void:
	if not is_on():
		return
	if model.has_endless_lines:
		_switch_off()
	else:
		_begin(model)


func _switch_off() -> void:
	if is_on():
		_shot.finish()
		_shot = null
	queue_redraw()


## Shows where the body is at the moment of [param model], and how far from the ball.
func show_moment(model: AngledLinesModel) -> void:
	if not is_on():
		return
	var seconds := maxf(model.elapsed_seconds() - _first_seconds, 0.0)
	_place = _shot.place_at(snappedf(seconds / AngledLinesModel.FRAME, 1e-6))
	_gap = _place.distance_to(model.ball().position)
	_follow(seconds)
	if _gap > _PARTED and not _parting:
		_parting = _place.copy()
		_parting_seconds = seconds
	queue_redraw()


# The path from the start until now, frame by frame, even if time has jumped.
func _follow(seconds: float) -> void:
	var frames := mini(floori(seconds / AngledLinesModel.FRAME + 1e-6) + 1, _LONGEST)
	while _path.size() < frames:
		_path.append(_shot.place_at(_path.size()))
	_path.resize(frames)


func _draw() -> void:
	if not is_on():
		return
	var color := Palette.color(_ROLE)
	for i in range(1, _path.size(), 2):
		draw_line(board.to_screen(_path[i - 1]), board.to_screen(_path[i]), Color(color, 0.7), 2.0)
	var middle := board.to_screen(_place)
	var pixels := _radius * board.pixels_per_unit
	draw_circle(middle, pixels, Color(color, 0.12), true, -1.0, true)
	draw_circle(middle, pixels, color, false, 2.5, true)
	draw_text(_label(), label_place(), color, 18)
	if _parting:
		_draw_parting(color)


func _label() -> String:
	return tr("Godot, %s px off") % NumberText.short(_gap, 2)


func _draw_parting(color: Color) -> void:
	var at := board.to_screen(_parting)
	var arm := Vector2(6.0, 6.0)
	draw_line(at - arm, at + arm, color, 2.5)
	draw_line(at + Vector2(-arm.x, arm.y), at + Vector2(arm.x, -arm.y), color, 2.5)
	var text := tr("parts after %s s") % NumberText.short(_parting_seconds, 3)
	draw_text(text, parting_place(), color, 16)


## Where the middle of the body's name is, in pixels of the board.
func label_place() -> Vector2:
	return _beside(board.to_screen(_place), _radius * board.pixels_per_unit + 16.0)


## Where the middle of the words at the parting is, in pixels of the board: beside the cross, away
## from the body's name.
func parting_place() -> Vector2:
	var at := board.to_screen(_parting)
	var place := _beside(at, 20.0)
	var way := (place - label_place()).abs()
	if way.x < _TEXT_SIZE.x and way.y < _TEXT_SIZE.y:
		place.y = 2.0 * at.y - place.y
	return place


# Below a point, or above it near the foot of the board; never beyond its sides.
func _beside(at: Vector2, distance: float) -> Vector2:
	var down := distance if at.y < board.size.y * 0.75 else -distance
	var room := Rect2(Vector2.ZERO, board.size).grow_individual(-90.0, -16.0, -90.0, -16.0)
	return (at + Vector2(0.0, down)).clamp(room.position, room.end)
