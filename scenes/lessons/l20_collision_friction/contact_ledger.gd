@tool
class_name ContactLedger
extends Control
## What a contact does with energy and angular momentum, as bars: before it and after it, in parts
## of the flight and of the spin. A bar of the same length is kept.

const _FONT_SIZE := 15
const _LEFT := 34.0
const _RIGHT := 16.0
const _BAR := 18.0
# Tops of the legend and of the four bars.
const _LEGEND := 22.0
const _TOPS: PackedFloat64Array = [34.0, 58.0, 98.0, 122.0]
const _NAMES: PackedStringArray = ["E", "E′", "L", "L′"]
const _ROLES: Array[Palette.Role] = [
	Palette.Role.PROJECTION, Palette.Role.A, Palette.Role.INK, Palette.Role.QUIET
]

# The parts of the energy along n, along t, of the spin; behind them what is lost.
var _energies: Array[PackedFloat64Array] = [[3.0, 1.0, 0.0], [3.0, 0.5, 0.2, 0.3]]
# The parts of the angular momentum: of the flight, of the spin.
var _momenta: Array[PackedFloat64Array] = [[3.0, 0.0], [2.0, 1.0]]


func _ready() -> void:
	resized.connect(queue_redraw)
	# The editor would save it.
	if not Engine.is_editor_hint():
		accessibility_name = tr("Energy and angular momentum before and after")


## Shows those of [param contact].
func show_contact(contact: FrictionContact) -> void:
	var leaving := contact.after()
	var lost := maxf(contact.lost_to_bounce() + contact.lost_to_friction(), 0.0)
	var energy_after := contact.energy_parts(leaving)
	energy_after.append(lost)
	_energies = [contact.energy_parts(contact.before()), energy_after]
	_momenta = [
		FrictionContact.momentum_parts(contact.before()), FrictionContact.momentum_parts(leaving)
	]
	queue_redraw()


func _draw() -> void:
	draw_style_box(get_theme_stylebox(&"panel", &"PanelCard"), Rect2(Vector2.ZERO, size))
	_draw_legend()
	for place: int in _TOPS.size():
		_write(_NAMES[place], 12.0, _TOPS[place] + _BAR - 4.0, Palette.Role.INK)
	for place: int in 2:
		_draw_energy(_energies[place], _TOPS[place])
	_draw_momenta()


func _draw_legend() -> void:
	var words: PackedStringArray = [tr("along n"), tr("along t"), tr("spin"), tr("lost")]
	var x := _LEFT
	for place: int in words.size():
		var color := Palette.color(_ROLES[place])
		draw_rect(Rect2(x, _LEGEND - 10.0, 10.0, 10.0), Color(color, _opacity(place)))
		_write(words[place], x + 14.0, _LEGEND, _ROLES[place])
		x += 14.0 + _width(words[place]) + 12.0


# What is lost is not there any more: pale.
static func _opacity(place: int) -> float:
	return 0.25 if place == 3 else 0.8


func _draw_energy(parts: PackedFloat64Array, top: float) -> void:
	var whole := _energies[0][0] + _energies[0][1] + _energies[0][2]
	var x := _LEFT
	for place: int in parts.size():
		var length := _room() * parts[place] / maxf(whole, 1e-300)
		_draw_part(x, length, top, place)
		x += length


# What is below 0 reaches from 0 to the left. The mark is at the sum.
func _draw_momenta() -> void:
	var low := 0.0
	var high := 0.0
	for parts in _momenta:
		low = minf(low, minf(parts[0], 0.0) + minf(parts[1], 0.0))
		high = maxf(high, maxf(parts[0], 0.0) + maxf(parts[1], 0.0))
	var unit := _room() / maxf(high - low, 1e-300)
	var zero := _LEFT - low * unit
	for row: int in 2:
		var ends: PackedFloat64Array = [zero, zero]
		for place: int in 2:
			var length := _momenta[row][place] * unit
			var side := 0 if length < 0.0 else 1
			_draw_part(ends[side], length, _TOPS[2 + row], place + 1)
			ends[side] += length
	var sum := zero + (_momenta[0][0] + _momenta[0][1]) * unit
	_draw_mark(zero, Palette.drawn(Palette.AXIS))
	_draw_mark(sum, Palette.color(Palette.Role.REST))


func _draw_mark(x: float, color: Color) -> void:
	var top := Vector2(x, _TOPS[2] - 6.0)
	draw_line(top, Vector2(x, _TOPS[3] + _BAR + 6.0), color, Palette.stroke(2.0))


func _draw_part(x: float, length: float, top: float, place: int) -> void:
	var color := Color(Palette.color(_ROLES[place]), _opacity(place))
	draw_rect(Rect2(x, top, length, _BAR).abs(), color)


func _room() -> float:
	return size.x - _LEFT - _RIGHT


func _width(text: String) -> float:
	var font := get_theme_default_font()
	return font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE).x


func _write(text: String, x: float, y: float, role: Palette.Role) -> void:
	var font := get_theme_default_font()
	var color := Palette.color(role)
	draw_string(font, Vector2(x, y), text, HORIZONTAL_ALIGNMENT_LEFT, -1, _FONT_SIZE, color)
