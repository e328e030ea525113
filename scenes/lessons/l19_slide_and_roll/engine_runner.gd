@tool
class_name EngineRunner
extends BoardPart
## Godot's own body on the line of the ball: a ghost, and how far it is from the ball. There is no
## such body while this is switched off, as at the start.

## The body has come to the end of the line.
signal measured

const _ROLE := Palette.Role.REST
const _FONT_SIZE := 16

## The body; null where it is switched off.
var roll: EngineRoll

var _radius := 0.0
# The body, null where its frame is not there; the ball; and the side of the line on which it lies.
var _place: Vec2
var _gap := 0.0
var _up := Vec2.new()
var _state: Dictionary = {}


func _exit_tree() -> void:
	super()
	_finish()


## Lets a body run as the ball of [param model] does, where it is switched on: anew, if anything has
## changed.
func show_model(model: SlideAndRollModel) -> void:
	var state := model.to_dictionary()
	state.erase("mistake")
	if model.has_engine and roll and state == _state:
		return
	_finish()
	_state = state
	if not model.has_engine:
		return
	_radius = model.radius
	_up = model.up()
	var along := model.segment().along().normalized()
	var ball := Ball.new(model.center_at(0.0), model.radius, along.scaled(model.speed))
	roll = EngineRoll.new(self, ball, model.segment(), model.gravity, model.friction)
	roll.ended.connect(measured.emit)


## How far the body is from the ball, in pixels; as long as it is seen.
func gap() -> float:
	return _gap


## Shows where the body is after [param seconds], while the ball is at [param center].
func show_moment(seconds: float, center: Vec2) -> void:
	_place = roll.place_at(seconds) if roll else null
	if _place:
		_gap = _place.distance_to(center)
	queue_redraw()


func _finish() -> void:
	if roll:
		roll.finish()
		roll = null
	_place = null
	queue_redraw()


func _draw() -> void:
	if not _place:
		return
	var color := Palette.color(_ROLE)
	var middle := board.to_screen(_place)
	var pixels := _radius * board.pixels_per_unit
	draw_circle(middle, pixels, Color(color, 0.12), true, -1.0, true)
	draw_circle(middle, pixels, color, false, 2.5, true)
	var below := board.direction_to_screen(_up) * -(pixels + 18.0)
	var text := tr("Godot, %s px off") % NumberText.short(_gap, 2)
	var extent := Vector2(text_extent(text, _FONT_SIZE).x, 0.0)
	draw_text(text, kept_on_board(middle + below, extent, Vector2(6.0, 14.0)), color, _FONT_SIZE)
