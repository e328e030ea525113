class_name SignVerdict
extends PanelContainer
## What the sign of the dot product says, in words, with the course's ball: green ahead, red behind.

@onready var _ball: Control = %Ball
@onready var _sign: Label = %Sign
@onready var _words: Label = %Words


## Shows the sign [param side], -1, 0 or 1, and the scalar projection in units.
func show_sign(side: int, scalar: float) -> void:
	var words: PackedStringArray = [
		tr("negative: the angle is above 90°"),
		tr("zero: no shadow at all"),
		tr("positive: the angle is below 90°"),
	]
	_words.text = tr("Scalar projection %s") % NumberText.short(scalar) + "\n" + words[side + 1]
	_sign.text = [NumberText.MINUS, "0", "+"][side + 1]
	var roles: Array[Palette.Role] = [Palette.Role.WRONG, Palette.Role.QUIET, Palette.Role.RIGHT]
	_ball.self_modulate = Palette.color(roles[side + 1])
