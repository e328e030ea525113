class_name VerdictCard
extends PanelContainer
## What a lesson finds, in words, with a coloured ball that also carries a sign.

@onready var _ball: Control = %Ball
@onready var _sign: Label = %Sign
@onready var _words: Label = %Words


## Shows [param sign_text], one letter, on a ball in the colour of [param role], and beside it
## [param words], translated, a line each.
func show_verdict(sign_text: String, role: Palette.Role, words: PackedStringArray) -> void:
	_sign.text = sign_text
	_ball.self_modulate = Palette.color(role)
	_words.text = "\n".join(words)
	_shrink()


# Makes the card as small as its words allow; it grows to where its anchors let it.
func _shrink() -> void:
	offset_right = offset_left
	if grow_vertical == GROW_DIRECTION_BEGIN:
		offset_top = offset_bottom
	else:
		offset_bottom = offset_top
