class_name StillPicture
extends MarginContainer
## Shows its children as a picture, which is drawn again only when something in it changes.
##
## Without a graphics card a panel full of buttons and text takes longer to draw than everything
## that flies over the board; and it stands still while it flies.

## Its children do not fill it: what lies below is seen at round corners and in gaps.
@export var is_see_through := false

var _canvas := StillCanvas.new()


func _ready() -> void:
	_canvas.transparent_bg = is_see_through
	add_child(_canvas, false, Node.INTERNAL_MODE_FRONT)
	_canvas.prepare(self)
	for child in get_children():
		_take(child)
	child_entered_tree.connect(_take)
	resized.connect(_fit)
	get_viewport().size_changed.connect(_fit)
	_fit()


func _draw() -> void:
	_canvas.draw_on(self)


func _fit() -> void:
	_canvas.fit(size)


func _take(child: Node) -> void:
	_canvas.take(child as CanvasItem)
