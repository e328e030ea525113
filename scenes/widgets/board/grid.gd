@tool
class_name Grid
extends BoardPart
## Grid with axes: lines at every step, numbers where there is room, x to the right and y down, or
## up where the board has it so.
##
## Without a graphics card it is drawn once into a picture, and again when the view changes.

## Also draw the axes with their numbers, not just the lines.
@export var axes := true
## Also draw the lines, not just the paper.
@export var has_lines := true

var _canvas: StillCanvas


func _ready() -> void:
	var lines := GridLines.new()
	lines.axes = axes
	lines.has_lines = has_lines
	if Engine.is_editor_hint() or not board or not SoftwareDrawing.is_on:
		add_child(lines)
		return
	_canvas = StillCanvas.new()
	add_child(_canvas)
	_canvas.prepare(self)
	_canvas.add_child(lines)
	board.has_paper = false
	board.view_changed.connect(_fit)
	get_viewport().size_changed.connect(_fit)
	_fit()


## Draws [param item], which lies on the board and seldom changes, together with the grid: below all
## that moves. It stays where it is in the tree, with its input and focus.
func take(item: CanvasItem) -> void:
	if _canvas:
		_canvas.take(item)
	else:
		RenderingServer.canvas_item_set_parent(item.get_canvas_item(), get_canvas_item())


func _fit() -> void:
	_canvas.fit(board.size)
	queue_redraw()


func _draw() -> void:
	if _canvas:
		_canvas.draw_on(self)
