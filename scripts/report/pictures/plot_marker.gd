class_name PlotMarker
extends RefCounted
## The marker of a method in a picture, with a shape and a colour of its own. Markers of the lab's
## own methods are filled, those of baselines are hollow.

## The dashes of the frontier, as SVG writes them.
const DASHES := "7 5"

## Corners of the shapes around (0, 0), as x, y, x, y; the circle has none.
const _SHAPES: Array[Array] = [
	[],
	[-0.9, -0.9, 0.9, -0.9, 0.9, 0.9, -0.9, 0.9],
	[0.0, -1.2, 1.1, 0.8, -1.1, 0.8],
	[0.0, -1.3, 1.3, 0.0, 0.0, 1.3, -1.3, 0.0],
	[0.0, 1.2, 1.1, -0.8, -1.1, -0.8],
	[
		-0.4,
		-1.2,
		0.4,
		-1.2,
		0.4,
		-0.4,
		1.2,
		-0.4,
		1.2,
		0.4,
		0.4,
		0.4,
		0.4,
		1.2,
		-0.4,
		1.2,
		-0.4,
		0.4,
		-1.2,
		0.4,
		-1.2,
		-0.4,
		-0.4,
		-0.4
	],
	[-1.2, 0.0, 0.8, -1.1, 0.8, 1.1],
	[1.2, 0.0, -0.8, -1.1, -0.8, 1.1],
	[-0.6, -1.1, 0.6, -1.1, 1.2, 0.0, 0.6, 1.1, -0.6, 1.1, -1.2, 0.0],
	[0.0, -1.3, 0.35, -0.35, 1.3, 0.0, 0.35, 0.35, 0.0, 1.3, -0.35, 0.35, -1.3, 0.0, -0.35, -0.35],
]

const _ROLES: Array[Palette.Role] = [
	Palette.Role.PROJECTION,
	Palette.Role.B,
	Palette.Role.A,
	Palette.Role.REST,
	Palette.Role.UNIT,
	Palette.Role.QUIET,
	Palette.Role.WRONG,
]

## The index in the list of shapes.
var shape: int
## The colour as SVG writes it.
var color: String
## Whether only the outline is drawn.
var is_hollow: bool


## The marker of the method with this index among the lab's own, or among the baselines.
func _init(index: int, is_baseline: bool) -> void:
	shape = index % _SHAPES.size()
	color = SvgText.hex(Palette.color(_ROLES[index % _ROLES.size()]))
	is_hollow = is_baseline


## The SVG element; [param words] are shown when the pointer rests on it.
func element(x: float, y: float, size: float, words: String = "") -> String:
	var style := 'fill="%s" stroke="%s" stroke-width="2"' % [_fill(), color]
	var title := "<title>%s</title>" % SvgText.escaped(words) if words else ""
	if _SHAPES[shape].is_empty():
		return '<circle cx="%.1f" cy="%.1f" r="%.1f" %s>%s</circle>' % [x, y, size, style, title]
	var corners: PackedStringArray = []
	var numbers := PackedFloat64Array(_SHAPES[shape])
	for i in range(0, numbers.size(), 2):
		corners.append("%.1f,%.1f" % [x + size * numbers[i], y + size * numbers[i + 1]])
	return '<polygon points="%s" %s>%s</polygon>' % [" ".join(corners), style, title]


## The SVG element of the ring around a point on the frontier.
static func ring(x: float, y: float) -> String:
	var ink := SvgText.hex(Palette.color(Palette.Role.INK))
	var style := 'fill="none" stroke="%s" stroke-width="2"' % ink
	return '<circle cx="%.1f" cy="%.1f" r="13" %s/>' % [x, y, style]


## A marker for each method: the lab's own first, then the baselines, in order of appearance.
static func for_methods(measurements: Array[Measurement]) -> Dictionary[String, PlotMarker]:
	var found: Dictionary[String, PlotMarker] = {}
	for is_baseline: bool in [false, true]:
		var count := 0
		for measurement in measurements:
			if measurement.is_baseline == is_baseline and not found.has(measurement.method):
				found[measurement.method] = PlotMarker.new(count, is_baseline)
				count += 1
	return found


func _fill() -> String:
	return SvgText.paper() if is_hollow else color
