class_name ReflectionDrawing
extends Node2D
## The drawing of the lesson on reflection: the velocity before and after, what is subtracted,
## Godot's own methods beside it, and the verdict.

## Pixels that the ball is drawn wide, at every scale.
const _BALL_PIXELS := 16.0
# The corners in which the card may stand; the table takes the last one that is left.
const _CORNERS: Array[Control.LayoutPreset] = [
	Control.PRESET_TOP_LEFT,
	Control.PRESET_TOP_RIGHT,
	Control.PRESET_BOTTOM_RIGHT,
	Control.PRESET_BOTTOM_LEFT,
]
# Pixels that are kept free around the card, and around the table.
const _AROUND_CARD := 28.0
# So high is a line of the card.
const _PIXELS_OF_LINE := 26.0

@onready var _line: Arrow = %Line
@onready var _perpendicular: Arrow = %Perpendicular
@onready var _normal: Arrow = %Normal
@onready var _coming: Arrow = %Coming
@onready var _velocity: Arrow = %Velocity
@onready var _part: Arrow = %Part
@onready var _drop: Arrow = %Drop
@onready var _first: Arrow = %First
@onready var _second: Arrow = %Second
@onready var _slide: Arrow = %Slide
@onready var _mirror: Arrow = %Mirror
@onready var _leaving: Arrow = %Leaving
@onready var _wrong: Arrow = %Wrong
@onready var _angle_in: AngleArc = %AngleIn
@onready var _angle_out: AngleArc = %AngleOut
@onready var _ball: BallView = %Ball
@onready var _wrong_ball: BallView = %WrongBall
@onready var _table: GodotTable = %Table
@onready var _verdict: VerdictCard = %Verdict


## Draws [param model] as far as [param step] has got.
func show_model(model: ReflectionModel, step: ReflectionModel.Step) -> void:
	var is_split := step >= ReflectionModel.Step.SPLIT and not model.refusal()
	_lay_line(model)
	_lay_split(model, step, is_split)
	_lay_slide(model, step, is_split)
	_lay_subtracted(model, step, is_split)
	_lay_angles(model, step, is_split)
	_lay_handles(model, step)
	_lay_wrong(model)
	show_ball(model, step)
	_table.visible = step == ReflectionModel.Step.BOUNCE
	_table.show_model(model)
	_show_verdict(model, step)


## Shows the ball where it is now.
func show_ball(model: ReflectionModel, step: ReflectionModel.Step) -> void:
	var radius := _BALL_PIXELS / _ball.board.pixels_per_unit
	var leaving := model.velocity_after(model.times_subtracted(step))
	_ball.lay(model.ball_centre(radius, leaving), radius)
	# Up to the line both balls are one.
	_wrong_ball.visible = model.mistake_shows() and model.time > 0.0
	_wrong_ball.lay(model.ball_centre_with_mistake(radius), radius)


func _lay_line(model: ReflectionModel) -> void:
	var reach := model.facing_normal().scaled(model.velocity.length())
	_line.lay(model.along.negated(), model.along)
	_perpendicular.lay(reach.negated(), reach)
	_normal.label = model.normal_symbol()
	_normal.lay(Vec2.new(), model.used_normal())
	_normal.keep_label_from(model.velocity.negated())
	_coming.lay(model.velocity.negated(), Vec2.new())
	_coming.keep_label_from(model.facing_normal())


func _lay_split(model: ReflectionModel, step: ReflectionModel.Step, is_split: bool) -> void:
	var is_next := step == ReflectionModel.Step.NEXT_FRAME
	var split := model.velocity_out() if is_next else model.velocity
	var part := model.normal_part_of(split)
	_velocity.lay(Vec2.new(), model.velocity)
	_velocity.keep_label_from(model.facing_normal())
	var lies_on_line := model.is_along_line()
	_velocity.label_place = Arrow.LabelPlace.MIDDLE if lies_on_line else Arrow.LabelPlace.HEAD
	# In between, the arrows that are subtracted carry the name.
	var names_part := is_next or step == ReflectionModel.Step.SPLIT
	# Along the line it is nothing, and on the way back it lies on v out.
	var is_crowded := model.is_along_line() or is_next and model.stops_after(1.0)
	_part.label = "(v·n̂) n̂" if names_part and not is_crowded else ""
	_part.label_place = Arrow.LabelPlace.HEAD if is_next else Arrow.LabelPlace.MIDDLE
	_part.lay(Vec2.new(), part)
	_part.keep_label_from(split)
	_drop.lay(part, split)
	_velocity.visible = is_split and not is_next
	_part.visible = is_split
	_drop.visible = is_split and names_part


func _lay_slide(model: ReflectionModel, step: ReflectionModel.Step, is_split: bool) -> void:
	_slide.lay(Vec2.new(), model.velocity_after(1.0))
	_slide.keep_label_from(model.normal_part().negated())
	# Where v out lies on it, it says nothing.
	var is_hidden := model.is_along_line() and step >= ReflectionModel.Step.MIRROR
	is_hidden = is_hidden or model.stops_after(1.0) or step == ReflectionModel.Step.NEXT_FRAME
	_slide.visible = is_split and step >= ReflectionModel.Step.SLIDE and not is_hidden


func _lay_subtracted(model: ReflectionModel, step: ReflectionModel.Step, is_split: bool) -> void:
	var slide := model.velocity_after(1.0)
	var leaving := model.velocity_after(model.times_subtracted(step))
	var is_next := step == ReflectionModel.Step.NEXT_FRAME
	var bounces := is_split and step >= ReflectionModel.Step.MIRROR
	_first.lay(model.velocity, slide)
	_first.keep_label_from(Vec2.new())
	_second.lay(slide, leaving)
	_second.keep_label_from(Vec2.new())
	_second.label = "−(v·n̂) n̂" if step == ReflectionModel.Step.MIRROR else "−C (v·n̂) n̂"
	_leaving.lay(Vec2.new(), leaving)
	_place_name_of_leaving(model)
	_mirror.lay(Vec2.new(), model.velocity_after(2.0))
	var has_part := not model.is_along_line() and not is_next
	_second.visible = bounces and has_part and leaving.distance_to(slide) > 0.0
	_first.visible = is_split and step >= ReflectionModel.Step.SLIDE and has_part
	_leaving.visible = bounces
	# Where it would lie on the arrow out of the line, it says nothing.
	var turns := not model.has_equal_angles(model.times_subtracted(step))
	_mirror.visible = bounces and model.mistake == 0 and turns and has_part


# On the line or on the way back, what lies beyond the head is in the way of the name.
func _place_name_of_leaving(model: ReflectionModel) -> void:
	var is_along := model.is_along_line()
	var is_beside := is_along or model.stops_after(1.0)
	_leaving.label_place = Arrow.LabelPlace.MIDDLE if is_beside else Arrow.LabelPlace.HEAD
	_leaving.label_share = 0.5 if is_along else 0.9
	_leaving.keep_label_from(model.facing_normal() if is_along else model.along)


func _lay_wrong(model: ReflectionModel) -> void:
	var is_into_table := model.mistake == ReflectionMistakes.NORMAL_OF_NORMAL
	_wrong.label_place = Arrow.LabelPlace.MIDDLE if is_into_table else Arrow.LabelPlace.HEAD
	_wrong.keep_label_from(model.velocity)
	_wrong.lay(Vec2.new(), model.velocity_with_mistake())
	_wrong.visible = model.mistake_shows()
	# Reflected again, the wrong arrow ends where these have their names.
	var is_crowded := model.mistake == ReflectionMistakes.REFLECTED_AGAIN
	_first.label = "" if is_crowded else "−(v·n̂) n̂"
	# Nor where v out lies along the line on it.
	_velocity.label = "" if is_crowded or _leaving.visible and model.is_along_line() else "v"


func _lay_angles(model: ReflectionModel, step: ReflectionModel.Step, is_split: bool) -> void:
	var leaving := model.velocity_after(model.times_subtracted(step))
	_angle_in.measure(Vec2.new(), model.facing_normal(), model.velocity.negated())
	_angle_out.measure(Vec2.new(), model.facing_normal(), leaving)
	# A ball at rest makes no angle.
	_angle_in.visible = _angle_in.visible and model.velocity.length() > 0.0
	var is_last := step == ReflectionModel.Step.NEXT_FRAME
	_angle_in.visible = _angle_in.visible and not is_last
	var bounces := is_split and step >= ReflectionModel.Step.MIRROR and not is_last
	_angle_out.visible = _angle_out.visible and bounces


func _lay_handles(model: ReflectionModel, step: ReflectionModel.Step) -> void:
	(%LineStart as Handle).place(model.along.negated())
	(%LineEnd as Handle).place(model.along)
	(%NormalHead as Handle).place(model.used_normal())
	(%ComingTail as Handle).place(model.velocity.negated())
	(%VelocityHead as Handle).place(model.velocity)
	(%VelocityHead as Handle).visible = _velocity.visible
	# Hidden, it lies where the last step shows it: the lesson reads the bounciness there at the
	# start.
	var seen := step if _leaving.visible else ReflectionModel.Step.BOUNCE
	(%LeavingHead as Handle).place(model.velocity_after(model.times_subtracted(seen)))
	(%LeavingHead as Handle).visible = _leaving.visible


# Where the normal is refused, the notice line says so in the same place.
func _show_verdict(model: ReflectionModel, step: ReflectionModel.Step) -> void:
	_verdict.visible = model.refusal() == "" and step >= ReflectionModel.Step.SLIDE
	var sign_text := ReflectionTexts.verdict_sign(model, step)
	var role := Palette.Role.RIGHT if sign_text == "=" else Palette.Role.QUIET
	if model.mistake_shows():
		role = Palette.Role.WRONG
	var words := ReflectionTexts.verdict(model, step)
	_verdict.show_verdict(sign_text, role, words)
	_keep_free(model, words.size())


# Card and table stand where they hide neither a handle nor the ball at either end of its flight.
func _keep_free(model: ReflectionModel, line_count: int) -> void:
	var busy := model.places_to_keep_free()
	var corners := _CORNERS.duplicate()
	# The card itself grows only later.
	var card := Vector2(_verdict.size.x, _PIXELS_OF_LINE * line_count + _AROUND_CARD)
	var corner := _free_corner(corners, card, busy)
	_verdict.stand_in(corner)
	corners.erase(corner)
	corners.reverse()
	_table.stand_in(_free_corner(corners, _table.size, busy))


# The first of these corners in which something of this size hides nothing; else the first.
func _free_corner(
	corners: Array[Control.LayoutPreset], size: Vector2, busy: Array[Vec2]
) -> Control.LayoutPreset:
	var board := _ball.board
	var room := board.size - size
	for corner in corners:
		var is_right := corner in [Control.PRESET_TOP_RIGHT, Control.PRESET_BOTTOM_RIGHT]
		var is_low := corner in [Control.PRESET_BOTTOM_LEFT, Control.PRESET_BOTTOM_RIGHT]
		var at := Vector2(room.x if is_right else 0.0, room.y if is_low else 0.0)
		var place := Rect2(at, size).grow(_AROUND_CARD)
		var hides := func(point: Vec2) -> bool: return place.has_point(board.to_screen(point))
		if not busy.any(hides):
			return corner
	return corners[0]
