class_name GodotTable
extends PanelContainer
## Godot's own methods beside ours: which call is which, what it answers, and how far the 32 bits of
## Vector2 are from the exact answer.
##
## The cells are labels in the scene, row by row; here the last two of each row are filled.

const _COLUMNS := 4
const _MARGIN := 12

@onready var _cells: GridContainer = %Cells


## Shows what the three answer for the velocity and the normal of [param model]. They are not asked
## where the normal is not of length 1: Godot prints an error then.
func show_model(model: ReflectionModel) -> void:
	if model.refusal():
		for row: int in [1, 2, 3]:
			_show(row, tr("an error"), "")
		return
	var velocity := model.velocity.to_vector2()
	var normal := model.unit_normal().to_vector2()
	_show_answer(1, velocity.bounce(normal), model, 2.0)
	_show_answer(2, velocity.slide(normal), model, 1.0)
	_show_answer(3, velocity.reflect(normal), model, 2.0)


## Moves to this corner of the board; stays where it is in the panel.
func stand_in(corner: LayoutPreset) -> void:
	if get_parent() is Container:
		return
	var is_right := corner in [PRESET_TOP_RIGHT, PRESET_BOTTOM_RIGHT]
	grow_horizontal = GROW_DIRECTION_BEGIN if is_right else GROW_DIRECTION_END
	var is_low := corner in [PRESET_BOTTOM_LEFT, PRESET_BOTTOM_RIGHT]
	grow_vertical = GROW_DIRECTION_BEGIN if is_low else GROW_DIRECTION_END
	set_anchors_and_offsets_preset(corner, PRESET_MODE_MINSIZE, _MARGIN)


func _show_answer(row: int, answer: Vector2, model: ReflectionModel, times: float) -> void:
	# Godot's reflect answers the negative of ours.
	var compared := Vec2.from_vector2(-answer if row == 3 else answer)
	var error := ExactReflection.error_of(compared, model.velocity, model.along, times)
	_show(row, NumberText.pair(answer.x, answer.y), NumberText.size(error))


func _show(row: int, value: String, error: String) -> void:
	(_cells.get_child(row * _COLUMNS + 2) as Label).text = value
	(_cells.get_child(row * _COLUMNS + 3) as Label).text = error
	for label: Label in _cells.get_children():
		_wrap(label)


# In the panel of a phone there is no room for long numbers in one line.
func _wrap(label: Label) -> void:
	if get_parent() is Container:
		WordWidth.keep_whole(label)
	else:
		label.autowrap_mode = TextServer.AUTOWRAP_OFF
		label.custom_minimum_size.x = 0.0
