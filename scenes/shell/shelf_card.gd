class_name ShelfCard
extends Button
## A card on the start screen: picture, title, one line, and what has been done. The picture is
## above the text, or beside it on a card that is wide enough for that.

const _MARGIN := 12.0
## A card of this width has its picture at the side.
const _WIDE := 310.0
const _SHARE_OF_PICTURE := 0.36
## Height over width.
const _SHAPE_OF_PICTURE := 364.0 / 480.0

@onready var _picture: Control = %Picture
@onready var _title: Label = %Title
@onready var _summary: Label = %Summary
@onready var _done: Label = %Done


## Lays out for this width what the card shows, and returns the height that it needs.
func lay(width: float) -> float:
	var is_wide := width >= _WIDE
	var inside := width - 2.0 * _MARGIN
	var extent := Vector2(inside * _SHARE_OF_PICTURE if is_wide else inside, 0.0)
	extent.y = extent.x * _SHAPE_OF_PICTURE
	_picture.position = Vector2(_MARGIN, _MARGIN)
	_picture.size = extent
	var at := _picture.position
	if is_wide:
		at.x += extent.x + _MARGIN
	else:
		at.y += extent.y + _MARGIN / 2.0
	for label: Label in [_title, _summary, _done]:
		if label.visible:
			at.y += lay_text(label, at, width - _MARGIN - at.x)
	return maxf(at.y, _picture.position.y + extent.y) + _MARGIN


## Puts [param label] there with this width, and returns its height.
static func lay_text(label: Label, at: Vector2, width: float) -> float:
	label.position = at
	label.size = Vector2(width, 0.0)
	label.size.y = label.get_minimum_size().y
	return label.size.y


# What has been done, in a color of its own; nothing where it is "".
func _tell_done(words: String, role: Palette.Role) -> void:
	_done.text = words
	_done.visible = words != ""
	_done.add_theme_color_override(&"font_color", Palette.color(role))
