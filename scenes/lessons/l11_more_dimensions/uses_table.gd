class_name UsesTable
extends PanelContainer
## What the dot product is for: each use with its formula and the lessons that show it.

# The use (source text), its formula, and the numbers of the lessons.
const _USES: Array[Array] = [
	["length", "|a| = √(a · a)", "3"],
	["angle", "cos α = a · b / (|a| |b|)", "4"],
	["below, at or above 90°", "a · b > 0, = 0, < 0", "4, 11"],
	["shadow, projection", "p = (a · b̂) b̂", "4, 5"],
	["distance from a line", "(c − p) · n̂", "6"],
	["side of a line", "(c − p) · n̂ > 0", "6"],
	["moment of the touch", "t = (distance − r) / (−v · n̂)", "7"],
	["bounce", "v − (1 + C) (v · n̂) n̂", "8, 9"],
	["touch at the end of a line", "v · v t² + 2 d · v t + d · d = r²", "10"],
]

const _COLUMNS := 2
# Between two letters: no line is broken there.
const _JOINER := "\u2060"

@onready var _rows: GridContainer = %Rows


func _ready() -> void:
	_add_row(["%s (%s)" % [tr("use"), tr("lesson")], tr("formula")], &"LabelQuiet")
	for use in _USES:
		_add_row(["", _unbroken(str(use[1]))], &"")
	show_uses()


## Names the uses, their angles in the unit that is chosen.
func show_uses() -> void:
	for i in _USES.size():
		var name_of_use: String = _USES[i][0]
		var lessons: String = _USES[i][2]
		var label := _rows.get_child((i + 1) * _COLUMNS) as Label
		label.text = "%s (%s)" % [Conventions.in_unit(tr(name_of_use)), lessons]
		WordWidth.keep_whole(label)


# A formula is broken between its words only, and not beside a |.
static func _unbroken(formula: String) -> String:
	return formula.replace("|", _JOINER + "|" + _JOINER)


func _add_row(texts: PackedStringArray, variation: StringName) -> void:
	for column in texts.size():
		var label := Label.new()
		label.text = texts[column]
		label.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
		label.theme_type_variation = variation
		label.vertical_alignment = VERTICAL_ALIGNMENT_CENTER
		label.size_flags_vertical = Control.SIZE_EXPAND_FILL
		label.size_flags_horizontal = Control.SIZE_EXPAND_FILL
		_rows.add_child(label)
		WordWidth.keep_whole(label)
