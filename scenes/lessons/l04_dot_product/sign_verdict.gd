class_name SignVerdict
extends PanelContainer
## What the sign of the dot product says, in words, with the course's ball: green ahead, red behind.

@onready var _ball: Control = %Ball
@onready var _sign: Label = %Sign
@onready var _words: Label = %Words


## Shows sign and size of the scalar projection, and how much too big it is without normalizing.
func show_model(model: DotProductModel) -> void:
	var scalar := NumberText.short(model.scalar_projection())
	_words.text = tr("Scalar projection %s") % scalar + "\n" + _second_line(model)
	_sign.text = [NumberText.MINUS, "0", "+"][model.side() + 1]
	var roles: Array[Palette.Role] = [Palette.Role.WRONG, Palette.Role.QUIET, Palette.Role.RIGHT]
	_ball.self_modulate = Palette.color(roles[model.side() + 1])


func _second_line(model: DotProductModel) -> String:
	if not model.normalizes:
		var letter := DotProductTexts.onto_symbol(model)
		var times := NumberText.short(model.onto().length())
		return tr("wrong: |%s| = %s times too big") % [letter, times]
	var sentences: PackedStringArray = [
		tr("negative: the angle is above 90°"),
		tr("zero: no shadow at all"),
		tr("positive: the angle is below 90°"),
	]
	return sentences[model.side() + 1]
