@tool
class_name DotTexture
extends RefCounted
## Pictures of round things with a rim. All that share a picture are drawn in one call; as circles
## each would take several, which is slow without a graphics card.

## Thickness of the rim in pixels.
const RIM := 3.0

const _SVG := (
	'<svg xmlns="http://www.w3.org/2000/svg" width="%s" height="%s">'
	+ '<circle cx="%s" cy="%s" r="%s" fill="#%s" stroke="#%s" stroke-width="%s"/></svg>'
)

static var _made: Dictionary[String, Texture2D] = {}


## A disc in the colors [param fill] and [param rim], of [param radius] pixels to the middle of the
## rim; sharp at any scale of the window. The same picture for every call with the same arguments.
static func of(fill: Color, rim: Color, radius: float) -> Texture2D:
	var side := 2.0 * radius + RIM + 1.0
	var middle := side / 2.0
	var colors: PackedStringArray = [fill.to_html(false), rim.to_html(false)]
	var source := _SVG % [side, side, middle, middle, radius, colors[0], colors[1], RIM]
	if not _made.has(source):
		_made[source] = DPITexture.create_from_string(source)
	return _made[source]
