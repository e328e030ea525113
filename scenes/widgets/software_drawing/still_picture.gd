class_name StillPicture
extends MarginContainer
## Shows its children as a picture, which is drawn again only when something in it changes.
##
## Without a graphics card a panel full of buttons and text takes longer to draw than everything
## that flies over the board. Where a graphics card draws, this is a plain container.

## Its children do not fill it: what lies below is seen at round corners and in gaps.
@export var is_see_through := false
## Once on the screen it is not put there again while nothing changes. For a window that is not
## cleared, where only menus, tooltips and other windows inside of it are drawn over the picture.
@export var stays_on_screen := false

## It is put on the screen with the next frame.
var is_put_on_screen := true:
	set(value):
		is_put_on_screen = value
		RenderingServer.canvas_item_set_visible(get_canvas_item(), value and is_visible_in_tree())

var _canvas: StillCanvas


func _ready() -> void:
	if not SoftwareDrawing.is_on:
		return
	_canvas = StillCanvas.new()
	_canvas.transparent_bg = is_see_through
	add_child(_canvas, false, Node.INTERNAL_MODE_FRONT)
	_canvas.prepare(self)
	for child in get_children():
		_take(child)
	child_entered_tree.connect(_take)
	resized.connect(_fit)
	get_viewport().size_changed.connect(_fit)
	if stays_on_screen:
		set_notify_transform(true)
		_canvas.changed.connect(_put_on_screen)
		RenderingServer.frame_post_draw.connect(_stay)
	_fit()


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSFORM_CHANGED:
		_put_on_screen()


func _draw() -> void:
	if _canvas:
		_canvas.draw_on(self)


func _put_on_screen() -> void:
	is_put_on_screen = true


# It has just been put there; other windows may come and go over it.
func _stay() -> void:
	is_put_on_screen = not get_window().get_embedded_subwindows().is_empty()


func _fit() -> void:
	_canvas.fit(size)


func _take(child: Node) -> void:
	_canvas.take(child as CanvasItem)
