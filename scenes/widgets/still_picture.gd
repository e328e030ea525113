class_name StillPicture
extends MarginContainer
## Shows its children as a picture, which is drawn again only when something in it changes.
##
## Without a graphics card a panel full of buttons and text takes longer to draw than everything
## that flies over the board; and it stands still while it flies.

var _canvas := StillCanvas.new()


func _ready() -> void:
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
