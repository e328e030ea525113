@tool
class_name SpacePicture
extends Board
## Both vectors in space: heads that can be dragged in the plane of the picture, axes that turn with
## a drag on the empty board.

## The student wants the head of a vector, `a` or `b`, to be seen at [param point] of the picture.
signal head_moved(letter: String, point: Vec2)
## The student turns the view by these angles, in radians.
signal turned(yaw: float, pitch: float)
## A drag or nudge of a head has ended.
signal head_released

# The arc of the angle: pixels from the origin, and how many strokes it has.
const _ARC_PIXELS := 46.0
const _STROKES := 24
# Where heads are seen nearer to each other than this, in pixels, one name is beside its arrow.
const _NAMES_APART := 30.0

## Radians for each pixel of a drag.
const _TURN_PER_PIXEL := 0.01

## The view at the start, turned about the y axis: what [member Axonometry.yaw] is then.
@export_range(-180.0, 180.0, 0.001, "radians_as_degrees") var yaw := 0.5
## The view at the start, tilted: what [member Axonometry.pitch] is then.
@export_range(-80.0, 80.0, 0.001, "radians_as_degrees") var pitch := -0.45

var _reach := 1.0
# Where the drag that turns the view was last; null while there is none.
var _grip: Vec2

@onready var _axes: Array[Arrow] = [%XAxis, %YAxis, %ZAxis]
@onready var _ticks: AxisTicks = %Ticks
@onready var _arrow_of_a: Arrow = %ArrowOfA
@onready var _arrow_of_b: Arrow = %ArrowOfB
@onready var _head_of_a: Handle = %HeadOfA
@onready var _head_of_b: Handle = %HeadOfB
@onready var _shadow: Arrow = %Shadow
@onready var _to_shadow: Arrow = %ToShadow
@onready var _arc: Line2D = %Arc
@onready var _drops: Array[Arrow] = [%DropOfA, %DropOfB]
@onready var _floors: Array[Arrow] = [%FloorOfA, %FloorOfB]


func _ready() -> void:
	super()
	# In the editor the board is fitted to what is drawn on it.
	if Engine.is_editor_hint():
		return
	_head_of_a.moved.connect(func(point: Vec2) -> void: head_moved.emit("a", point))
	_head_of_b.moved.connect(func(point: Vec2) -> void: head_moved.emit("b", point))
	_head_of_a.released.connect(head_released.emit)
	_head_of_b.released.connect(head_released.emit)
	pointed.connect(_turn)
	released.connect(_let_go)
	resized.connect(_fit)


## Chooses the scale so that both vectors of [param model] are seen from every side.
func fit_model(model: MoreDimensionsModel) -> void:
	_reach = 1.0
	for i in 3:
		_reach = maxf(_reach, maxf(absf(model.a[i]), absf(model.b[i])))
	_fit()


## Shows the first three components of both vectors of [param model]; from the step of the sign on
## the shadow of a on b, and with the last one the angle.
func show_model(model: MoreDimensionsModel, step: int) -> void:
	var view := model.view
	for i in 3:
		var end: PackedFloat64Array = [0.0, 0.0, 0.0]
		end[i] = _reach * 1.15
		_axes[i].lay(Vec2.new(), view.seen_at(end[0], end[1], end[2]))
	_ticks.show_view(view, _reach)
	_lay(view, model.a, _arrow_of_a, _head_of_a, 0)
	_lay(view, model.b, _arrow_of_b, _head_of_b, 1)
	_part_names()
	_lay_shadow(model, step)
	_lay_arc(model, step)


# An arrow alone could lie anywhere in depth: its shadow on the floor y = 0 says where.
func _lay(
	view: Axonometry, vector: PackedFloat64Array, arrow: Arrow, handle: Handle, index: int
) -> void:
	var head := view.seen_at(vector[0], vector[1], vector[2])
	var foot := view.seen_at(vector[0], 0.0, vector[2])
	arrow.lay(Vec2.new(), head)
	handle.place(head)
	_floors[index].lay(Vec2.new(), foot)
	_drops[index].lay(foot, head)


func _part_names() -> void:
	var apart := to_screen(_head_of_a.at()).distance_to(to_screen(_head_of_b.at()))
	var is_crowded := apart < _NAMES_APART
	_arrow_of_a.label_place = Arrow.LabelPlace.MIDDLE if is_crowded else Arrow.LabelPlace.HEAD


func _lay_shadow(model: MoreDimensionsModel, step: int) -> void:
	var shadow := model.shadow()
	var foot := model.view.seen_at(shadow[0], shadow[1], shadow[2])
	_shadow.lay(Vec2.new(), foot)
	_to_shadow.lay(model.view.seen_at(model.a[0], model.a[1], model.a[2]), foot)
	_shadow.visible = step >= MoreDimensionsTexts.Step.SIGN and model.has_angle()
	_to_shadow.visible = _shadow.visible


# Between both directions in space, drawn as it is seen.
func _lay_arc(model: MoreDimensionsModel, step: int) -> void:
	_arc.visible = step >= MoreDimensionsTexts.Step.ANGLE and model.has_angle()
	_arc.default_color = Palette.color(Palette.Role.INK)
	_arc.position = to_screen(Vec2.new())
	_arc.clear_points()
	if _arc.visible:
		for i in _STROKES + 1:
			var share := float(i) / _STROKES
			var mixed: PackedFloat64Array = [0.0, 0.0, 0.0]
			for axis in 3:
				mixed[axis] = (
					model.a[axis] / model.length_of_a() * (1.0 - share)
					+ model.b[axis] / model.length_of_b() * share
				)
			var length := maxf(ComponentLists.length(mixed), 1e-300)
			var seen := model.view.seen_at(mixed[0] / length, mixed[1] / length, mixed[2] / length)
			_arc.add_point(seen.to_vector2() * _ARC_PIXELS)


## The view turns over in space, so that z turns with y: see [member Axonometry.is_y_up].
func turn_over(_y_is_up: bool) -> void:
	pass


func _fit() -> void:
	fit([Vec2.new(_reach * 1.3, _reach * 1.3)] as Array[Vec2])


func _turn(at: Vec2, _button: MouseButton) -> void:
	if _grip:
		var way := at.minus(_grip).scaled(pixels_per_unit * _TURN_PER_PIXEL)
		turned.emit(-way.x, way.y)
	_grip = at.copy()


func _let_go() -> void:
	_grip = null
	head_released.emit()
