class_name Grid
extends BoardPart
## Grid with axes: lines at every step, numbers where there is room, x to the right and y down, or
## up where the board has it so.
##
## It stands still while balls move, so it is drawn once into a picture, and again when the view
## changes: without a graphics card its many thin lines and numbers would take a tenth of a frame.

# The picture hides all below it; mixing the two would cost as much again.
const _OPAQUE := "shader_type canvas_item; render_mode unshaded, blend_disabled;"

## Also draw the axes with their numbers, not just the lines.
@export var axes := true

var _canvas := SubViewport.new()


func _ready() -> void:
	var lines := GridLines.new()
	lines.axes = axes
	_canvas.add_child(lines)
	_canvas.disable_3d = true
	_canvas.size_2d_override_stretch = true
	add_child(_canvas)
	var opaque := ShaderMaterial.new()
	opaque.shader = Shader.new()
	opaque.shader.code = _OPAQUE
	material = opaque
	board.has_paper = false
	board.view_changed.connect(_draw_again)
	get_viewport().size_changed.connect(_draw_again)
	_draw_again()


# As many pixels as the board has in the window, so that the picture is as sharp as a drawing.
func _draw_again() -> void:
	var window_scale := get_viewport().get_screen_transform().get_scale()
	_canvas.size = (board.size * window_scale).round().max(Vector2.ONE)
	_canvas.size_2d_override = board.size.max(Vector2.ONE)
	_canvas.render_target_update_mode = SubViewport.UPDATE_ONCE
	queue_redraw()


func _draw() -> void:
	draw_texture_rect(_canvas.get_texture(), Rect2(Vector2.ZERO, board.size), false)
