class_name ReflectionDrawing
extends Node2D
## The drawing of the lesson on reflection: the velocity before and after, what is subtracted,
## Godot's own methods beside it, and the verdict.

## Pixels that the ball is drawn wide, at every scale.
const _BALL_PIXELS := 16.0

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
	_normal.lay(Vec2.new(), model.used_normal())
	_coming.lay(model.velocity.negated(), Vec2.new())
	_coming.keep_label_from(model.facing_normal())


func _lay_split(model: ReflectionModel, step: ReflectionModel.Step, is_split: bool) -> void:
	var part := model.normal_part()
	_velocity.lay(Vec2.new(), model.velocity)
	# From the next step on, the arrows that are subtracted carry the name.
	_part.label = "(v·n) n" if step == ReflectionModel.Step.SPLIT else ""
	_part.lay(Vec2.new(), part)
	_part.keep_label_from(model.velocity)
	_drop.lay(part, model.velocity)
	_slide.lay(Vec2.new(), model.velocity_after(1.0))
	_slide.keep_label_from(part.negated())
	_velocity.visible = is_split
	_part.visible = is_split
	_drop.visible = is_split and step == ReflectionModel.Step.SPLIT
	var slides := step >= ReflectionModel.Step.SLIDE and not model.stops_after(1.0)
	_slide.visible = is_split and slides


func _lay_subtracted(model: ReflectionModel, step: ReflectionModel.Step, is_split: bool) -> void:
	var slide := model.velocity_after(1.0)
	var leaving := model.velocity_after(model.times_subtracted(step))
	var bounces := is_split and step >= ReflectionModel.Step.MIRROR
	_first.lay(model.velocity, slide)
	_first.keep_label_from(Vec2.new())
	_second.lay(slide, leaving)
	_second.keep_label_from(Vec2.new())
	_second.label = "−(v·n) n" if step == ReflectionModel.Step.MIRROR else "−C (v·n) n"
	_leaving.lay(Vec2.new(), leaving)
	_mirror.lay(Vec2.new(), model.velocity_after(2.0))
	var has_part := not model.is_along_line()
	_second.visible = bounces and has_part and leaving.distance_to(slide) > 0.0
	_first.visible = is_split and step >= ReflectionModel.Step.SLIDE and has_part
	_leaving.visible = bounces
	# Where it would lie on the arrow out of the line, it says nothing.
	var turns := not model.has_equal_angles(model.times_subtracted(step))
	_mirror.visible = bounces and model.mistake == 0 and turns and has_part


func _lay_wrong(model: ReflectionModel) -> void:
	var is_into_table := model.mistake == ReflectionMistakes.NORMAL_OF_NORMAL
	_wrong.label_place = Arrow.LabelPlace.MIDDLE if is_into_table else Arrow.LabelPlace.HEAD
	_wrong.keep_label_from(model.velocity)
	_wrong.lay(Vec2.new(), model.velocity_with_mistake())
	_wrong.visible = model.mistake_shows()
	# Reflected again, the wrong arrow ends where these have their names.
	var is_crowded := model.mistake == ReflectionMistakes.REFLECTED_AGAIN
	_first.label = "" if is_crowded else "−(v·n) n"
	_velocity.label = "" if is_crowded else "v"


func _lay_angles(model: ReflectionModel, step: ReflectionModel.Step, is_split: bool) -> void:
	var leaving := model.velocity_after(model.times_subtracted(step))
	_angle_in.measure(Vec2.new(), model.facing_normal(), model.velocity.negated())
	_angle_out.measure(Vec2.new(), model.facing_normal(), leaving)
	# A ball at rest makes no angle.
	_angle_in.visible = _angle_in.visible and model.velocity.length() > 0.0
	var bounces := is_split and step >= ReflectionModel.Step.MIRROR
	_angle_out.visible = _angle_out.visible and bounces


func _lay_handles(model: ReflectionModel, step: ReflectionModel.Step) -> void:
	(%LineStart as Handle).place(model.along.negated())
	(%LineEnd as Handle).place(model.along)
	(%NormalHead as Handle).place(model.used_normal())
	(%ComingTail as Handle).place(model.velocity.negated())
	(%VelocityHead as Handle).place(model.velocity)
	(%VelocityHead as Handle).visible = _velocity.visible
	# Hidden, it lies where the last step shows it: the lesson reads the bounciness there at the start.
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
	_verdict.show_verdict(sign_text, role, ReflectionTexts.verdict(model, step))
