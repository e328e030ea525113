class_name BankShotDrawing
extends Node2D
## The drawing of the lesson on bank shots: walls, start and target, the moved walls, the images,
## the way with its bounces, all orders of walls, and the flying balls.

# So long a normal is drawn, in pixels.
const _NORMAL_PIXELS := 44.0
# Where along a wall its normal is.
const _NORMAL_SHARE := 0.1
# What the card must not hide is so far away from it, in pixels.
const _AROUND_CARD := 12.0

@onready var _walls: Array[DraggableVector] = [%Wall1, %Wall2, %Wall3, %Wall4]
@onready var _moved: Array[Arrow] = [%Moved1, %Moved2, %Moved3]
@onready var _normals: Array[Arrow] = [%Normal1, %Normal2, %Normal3]
@onready var _mirrors: Array[Arrow] = [%Mirror1, %Mirror2, %Mirror3]
@onready var _images: Array[TargetMark] = [%Image1, %Image2, %Image3]
@onready var _bounces: Array[BallView] = [%Bounce1, %Bounce2, %Bounce3]
@onready var _straights: Array[FlightPath] = [%Straight1, %Straight2, %Straight3]
@onready var _path: FlightPath = %Path
@onready var _orders: BankOrdersView = %Orders
@onready var _wrong_path: FlightPath = %WrongPath
@onready var _depth: DimensionLine = %Depth
@onready var _image_depth: DimensionLine = %ImageDepth
@onready var _ball: BallView = %Ball
@onready var _target: TargetMark = %Target
@onready var _flying: BallView = %Flying
@onready var _wrong_ball: BallView = %WrongBall
@onready var _start_handle: BallHandle = %StartHandle
@onready var _target_handle: BallHandle = %TargetHandle
@onready var _radius_handle: Handle = %RadiusHandle
@onready var _image_handle: Handle = %ImageHandle
@onready var _verdict: VerdictCard = %Verdict


## Draws [param model] as far as [param step] has got, [param seconds] after the shot.
func show_model(model: BankShotModel, step: BankShotModel.Step, seconds: float) -> void:
	_lay_walls(model)
	_ball.lay(model.board.start, model.board.radius)
	_target.lay(model.board.target, model.board.radius)
	_start_handle.place_ball(model.board.start, model.board.radius)
	_target_handle.place_ball(model.board.target, model.board.radius)
	for place in _moved.size():
		_lay_mirror(model, step, place)
	_lay_depths(model, step)
	_lay_way(model, step)
	_lay_handles(model)
	show_balls(model, step, seconds)
	_show_verdict(model, step)


## Shows the balls as they are so many [param seconds] after the shot.
func show_balls(model: BankShotModel, step: BankShotModel.Step, seconds: float) -> void:
	var answer := model.answer()
	var flies := step == BankShotModel.Step.FIRE and answer.way.hit
	_flying.visible = flies and seconds > 0.0
	if _flying.visible:
		# It stays where it has arrived.
		var place := answer.right_place_after(minf(seconds, BankShotAnswer.SECONDS))
		_flying.lay(place, model.board.radius)
	_wrong_ball.visible = flies and seconds > 0.0 and answer.mistake_shows()
	if _wrong_ball.visible:
		_wrong_ball.lay(answer.wrong_place_after(seconds), model.board.radius)


func _lay_walls(model: BankShotModel) -> void:
	for place in _walls.size():
		_walls[place].visible = place < model.board.walls.size()
		if _walls[place].visible:
			_walls[place].lay(model.board.walls[place].start, model.board.walls[place].end)


# The wall of the bounce that comes at `place`, counted from the first one, moved by the radius, and
# the image that lies behind it.
func _lay_mirror(model: BankShotModel, step: BankShotModel.Step, place: int) -> void:
	var way := model.answer().way
	var is_there := place < way.sides.size()
	var is_crowded := step >= BankShotModel.Step.ORDERS
	_moved[place].visible = is_there and step >= BankShotModel.Step.MOVED_WALL and not is_crowded
	_normals[place].visible = _moved[place].visible
	_images[place].visible = is_there and step >= BankShotModel.Step.IMAGE and not is_crowded
	_mirrors[place].visible = _images[place].visible
	if not is_there:
		return
	var wall := model.board.walls[way.walls[place]]
	var normal := wall.normal().scaled(way.sides[place])
	var away := normal.scaled(model.board.radius)
	_moved[place].lay(wall.start.plus(away), wall.end.plus(away))
	var foot := wall.start.lerped(wall.end, _NORMAL_SHARE)
	var length := _NORMAL_PIXELS / _ball.board.pixels_per_unit
	_normals[place].lay(foot, foot.plus(normal.scaled(length)))
	var count := way.walls.size()
	_images[place].label = BankShotTexts.image_symbol(count - place, count)
	_images[place].lay(way.images[place], model.board.radius)
	_mirrors[place].lay(way.images[place + 1], way.images[place])


# How far the target is before the last wall, and its image behind it.
func _lay_depths(model: BankShotModel, step: BankShotModel.Step) -> void:
	var way := model.answer().way
	var is_shown := step == BankShotModel.Step.IMAGE and way.walls.size() == 1
	is_shown = is_shown and not way.images.is_empty()
	_depth.visible = is_shown
	_image_depth.visible = is_shown
	if not is_shown:
		return
	var wall := model.board.walls[way.walls[0]]
	var normal := wall.normal().scaled(way.sides[0])
	var height := model.board.target.minus(wall.start).dot(normal) - model.board.radius
	var foot := model.board.target.minus(normal.scaled(height))
	# On the side on which the ball is not.
	var beside := wall.along()
	if beside.dot(model.board.start.minus(model.board.target)) > 0.0:
		beside = beside.negated()
	_depth.label = "d = %s" % NumberText.short(height)
	_depth.lay(foot, model.board.target, beside)
	var depth := NumberText.short(height / model.board.bounciness)
	_image_depth.label = "d = %s" % depth if model.board.bounciness == 1.0 else "d / C = %s" % depth
	_image_depth.lay(foot, way.images[0], beside)


func _lay_way(model: BankShotModel, step: BankShotModel.Step) -> void:
	var answer := model.answer()
	var way := answer.way
	var has_way := not way.images.is_empty() and step >= BankShotModel.Step.BOUNCE
	_path.visible = has_way and way.hit
	_orders.visible = step == BankShotModel.Step.ORDERS
	_orders.show_ways(answer.ways, model.board.start)
	_path.show_path(answer.corners)
	for place in _bounces.size():
		_lay_straight(model, place, has_way and step == BankShotModel.Step.BOUNCE)
		var is_there := place < way.bounces.size() and has_way
		_bounces[place].visible = is_there and step != BankShotModel.Step.ORDERS
		if is_there:
			_bounces[place].label = BankShotTexts.numbered("B", place + 1, way.walls.size())
			_bounces[place].lay(way.bounces[place], model.board.radius)
	var has_mistake := answer.mistake_shows() and step != BankShotModel.Step.ORDERS
	_wrong_path.visible = has_mistake and step >= BankShotModel.Step.BOUNCE
	_wrong_path.show_path(answer.wrong_corners)


# The straight line along which the ball flies to the bounce that comes at `place`, up to the image
# at which it flies.
func _lay_straight(model: BankShotModel, place: int, is_shown: bool) -> void:
	var way := model.answer().way
	var is_there := place < way.sides.size() and place <= way.bounces.size()
	_straights[place].visible = is_shown and is_there
	if _straights[place].visible:
		var from := model.board.start if place == 0 else way.bounces[place - 1]
		var straight: Array[Vec2] = [from, way.images[place]]
		_straights[place].show_path(straight)


func _lay_handles(model: BankShotModel) -> void:
	var grip := model.radius_grip()
	_radius_handle.visible = _moved[0].visible and grip != null
	if grip:
		_radius_handle.place(grip)
	var way := model.answer().way
	_image_handle.visible = _images[0].visible and model.board.bounces == 1
	if _image_handle.visible:
		_image_handle.place(way.images[0])


func _show_verdict(model: BankShotModel, step: BankShotModel.Step) -> void:
	var answer := model.answer()
	_verdict.visible = step >= BankShotModel.Step.BOUNCE
	var is_wrong := not answer.way.hit or answer.mistake_shows()
	_verdict.show_verdict(
		"✗" if is_wrong else "✓",
		Palette.Role.WRONG if is_wrong else Palette.Role.RIGHT,
		BankShotTexts.verdict(model, step)
	)
	var seen := model.board.points() + answer.corners
	if step == BankShotModel.Step.BOUNCE:
		seen.append_array(answer.way.images)
	var busy: PackedVector2Array = []
	for point in seen:
		busy.append(_ball.board.to_screen(point))
	_verdict.keep_off(busy, _AROUND_CARD)
