class_name SvgText
extends RefCounted
## Builds a picture as SVG text, element by element. Lengths are in the picture's own units.

var _width: int
var _height: int
var _elements: PackedStringArray = []


## An empty picture of this size.
func _init(width: int, height: int) -> void:
	_width = width
	_height = height
	_elements.append('<rect width="%d" height="%d" fill="%s"/>' % [width, height, paper()])


## The colour of the paper.
static func paper() -> String:
	return hex(Palette.PAPER)


## A colour as SVG writes it.
static func hex(color: Color) -> String:
	return "#" + color.to_html(false)


## The text with & < > and quotes escaped, so that SVG does not take them as markup.
static func escaped(words: String) -> String:
	return words.xml_escape(true)


## A straight line.
func line(x1: float, y1: float, x2: float, y2: float, color: String, width: float = 1.0) -> void:
	var numbers := [x1, y1, x2, y2, color, width]
	_elements.append(
		'<line x1="%.1f" y1="%.1f" x2="%.1f" y2="%.1f" stroke="%s" stroke-width="%.1f"/>' % numbers
	)


## A line through points, given as x, y, x, y and so on.
func path(points: PackedFloat64Array, color: String, width: float, dashes: String = "") -> void:
	var texts: PackedStringArray = []
	for i in range(0, points.size(), 2):
		texts.append("%.1f,%.1f" % [points[i], points[i + 1]])
	var style := ' stroke-dasharray="%s"' % dashes if dashes else ""
	_elements.append(
		(
			'<polyline points="%s" fill="none" stroke="%s" stroke-width="%.1f"%s/>'
			% [" ".join(texts), color, width, style]
		)
	)


## A text; [param anchor] is start, middle or end.
func text(
	words: String, x: float, y: float, size: int, color: String, anchor: String = "start"
) -> void:
	var parts := [x, y, size, color, anchor, escaped(words)]
	_elements.append(
		'<text x="%.1f" y="%.1f" font-size="%d" fill="%s" text-anchor="%s">%s</text>' % parts
	)


## A text from bottom to top, with its middle at this point.
func upright_text(words: String, x: float, y: float, size: int, color: String) -> void:
	var parts := [size, color, x, y, escaped(words)]
	_elements.append(
		(
			(
				'<text font-size="%d" fill="%s" text-anchor="middle" '
				+ 'transform="translate(%.1f %.1f) rotate(-90)">%s</text>'
			)
			% parts
		)
	)


## Adds an element that is SVG text already.
func add(element: String) -> void:
	_elements.append(element)


## The complete file.
func to_text() -> String:
	var head := (
		'<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" viewBox="0 0 %d %d" '
		% [_width, _height, _width, _height]
	)
	return head + 'font-family="sans-serif">\n' + "\n".join(_elements) + "\n</svg>\n"
