@tool
class_name CappedField
extends LineEndsField
## The field with the round caps: it also shows where the ball touches the end, from the quadratic.

@onready var _end_names: Array[BoardText] = [%StartName, %EndName]
@onready var _difference: Arrow = %Difference
@onready var _normal: Arrow = %Normal
@onready var _first: BallView = %First
@onready var _second: BallView = %Second


## Shows the touch on the end up to the step [param step], counted from 0.
func show_cap(model: LineEndsModel, step: int) -> void:
	var equation := model.cap_equation()
	var cap := model.cap_point()
	_lay_names(model)
	_difference.visible = step == LineEndsTexts.Step.CAP
	_difference.lay(cap, model.start)
	var shows_roots := step >= LineEndsTexts.Step.ROOTS and equation.has_roots()
	_first.visible = shows_roots and (step == LineEndsTexts.Step.ROOTS or _touches_later(model))
	_second.visible = shows_roots and step == LineEndsTexts.Step.ROOTS
	if shows_roots:
		var first := model.start.plus(model.motion.scaled(equation.first_root()))
		var second := model.start.plus(model.motion.scaled(equation.second_root()))
		_first.lay(first, model.radius)
		_second.lay(second, model.radius)
	var impact := model.impact_in(LineEndsModel.Field.ROUND_CAPS)
	var is_on_cap := impact.hit and impact.feature != Impact.Feature.LINE
	_normal.visible = step >= LineEndsTexts.Step.BOUNCE and is_on_cap
	if is_on_cap:
		_normal.lay(cap, impact.position)
		_normal.keep_label_from(model.new_position())


# Not where the ball overlaps the end at the start: it touches at t = 0, and t₁ is before that.
func _touches_later(model: LineEndsModel) -> bool:
	return model.bounces_on_the_end() and model.impact_in(kind).fraction > 0.0


# The names of the ends are on the side of the line that is away from the ball's start.
func _lay_names(model: LineEndsModel) -> void:
	var away := model.facing_normal().negated()
	_end_names[0].lay(model.segment.start, away)
	_end_names[1].lay(model.segment.end, away)
