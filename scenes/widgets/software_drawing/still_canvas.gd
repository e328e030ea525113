class_name StillCanvas
extends SubViewport
## A picture of what does not move: drawn once, and again only when something in it changes.
##
## Without a graphics card every pixel that is mixed and every letter costs time in every frame. The
## picture is put on the screen as it is, pixel for pixel, which is the cheapest drawing there is.

## What is seen in the picture is another than before.
signal changed

# The picture hides what is below it; mixing the two would cost as much again. Written out, because
# the engine's own fragment shader, which tints the picture as well, takes half as long again.
const _OPAQUE := """
shader_type canvas_item;
render_mode unshaded, blend_disabled;

void fragment() {
	COLOR = vec4(texture(TEXTURE, UV).rgb, 1.0);
}
"""
# What is drawn into a see-through picture is already multiplied by its opacity.
const _SEE_THROUGH := "shader_type canvas_item; render_mode unshaded, blend_premul_alpha;"
# The corners of a picture, as shares of its size.
const _CORNERS: PackedVector2Array = [Vector2.ZERO, Vector2.RIGHT, Vector2.ONE, Vector2.DOWN]


func _init() -> void:
	disable_3d = true
	size_2d_override_stretch = true
	render_target_update_mode = SubViewport.UPDATE_DISABLED


## Prepares [param item], which shows the picture by [method draw_on]; not what lies on it. Comes
## after `transparent_bg`, which is for a picture that does not fill its rectangle.
func prepare(item: CanvasItem) -> void:
	var as_it_is := ShaderMaterial.new()
	as_it_is.shader = Shader.new()
	as_it_is.shader.code = _SEE_THROUGH if transparent_bg else _OPAQUE
	item.material = as_it_is
	# The node's own texture_filter would be inherited by what lies on it.
	var nearest := RenderingServer.CANVAS_ITEM_TEXTURE_FILTER_NEAREST
	RenderingServer.canvas_item_set_default_texture_filter(item.get_canvas_item(), nearest)


## Makes the picture [param extent] large, with as many pixels as that has in the window: it is as
## sharp as a drawing.
func fit(extent: Vector2) -> void:
	var window_scale := get_parent().get_viewport().get_screen_transform().get_scale()
	size = (extent * window_scale).round().max(Vector2.ONE)
	size_2d_override = extent.max(Vector2.ONE)
	_draw_again()


## Draws [param item] and all below it into the picture, in place of where it would be drawn. It
## stays where it is in the tree, with its input, focus and tooltips.
func take(item: CanvasItem) -> void:
	RenderingServer.canvas_item_set_parent(item.get_canvas_item(), find_world_2d().canvas)
	_watch(item)


## Puts the picture on [param item], in its `_draw`.
func draw_on(item: CanvasItem) -> void:
	# Not as a rectangle: of one the engine looks at every pixel whether it is cut off.
	var extent := Transform2D.IDENTITY.scaled(size_2d_override)
	item.draw_primitive(extent * _CORNERS, [Color.WHITE], _CORNERS, get_texture())


# Whatever is seen of a node, or of one that comes below it later, tells of its changes.
func _watch(node: Node) -> void:
	var item := node as CanvasItem
	if not item or item.draw.is_connected(_draw_again):
		return
	item.draw.connect(_draw_again)
	item.item_rect_changed.connect(_draw_again)
	item.visibility_changed.connect(_draw_again)
	item.child_entered_tree.connect(_watch)
	item.child_exiting_tree.connect(_draw_again.unbind(1))
	for child in item.get_children(true):
		_watch(child)


func _draw_again() -> void:
	render_target_update_mode = SubViewport.UPDATE_ONCE
	changed.emit()
