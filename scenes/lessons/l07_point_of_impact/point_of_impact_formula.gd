class_name PointOfImpactFormula
extends RefCounted
## The formula of the lesson on the point of impact: its lines, and what each name in them is.

const _WAYS := (
	"{a_symbol} = {old_distance} − {r_value} = {a}     "
	+ "{b_symbol} = {old_distance} − {new_distance} = {b}"
)
# The lines that the steps after the first add.
const _LATER_LINES: PackedStringArray = [
	"{reset} = new + ({r_value} − {new_distance}) {n} = {reset_pair}",
	_WAYS,
	"t = {a_symbol} / {b_symbol} = {a} / {b} = {t}",
	"{poi} = old + t v = {poi_pair}",
]
# What each mistake takes for t.
const _WRONG_TERMS: Dictionary[int, String] = {
	PointOfImpactMistakes.OVER_NEW: "a / new = {wrong_t}",
	PointOfImpactMistakes.UNSIGNED: "a / (old − |new|) = {wrong_t}",
	PointOfImpactMistakes.NOT_LIMITED: "any t, even {wrong_t}",
	PointOfImpactMistakes.FROM_NEW: "(new − r) / b = {wrong_t}",
}

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of all steps up to [param step] with the numbers of [param model].
func show_model(model: PointOfImpactModel, step: int) -> void:
	_put_symbols()
	_put_what_is_typed(model)
	_put_distances(model)
	_put_places(model)
	_formula.show_lines(_lines(model, step))


func _lines(model: PointOfImpactModel, step: int) -> PackedStringArray:
	var found: PackedStringArray = [
		"old ( {old_x} , {old_y} )     new ( {new_x} , {new_y} )",
		tr("l: ( {sx} , {sy} ) to ( {ex} , {ey} )   r = {r}"),
	]
	if model.mistake != 0:
		# The wrong t beside the right one replaces motion, reset and POI.
		found.append(_WAYS)
		found.append("t = {t}     {wrong}: " + _WRONG_TERMS[model.mistake])
		return found
	found.append("v = new − old = {v_pair}     |v| = {speed}")
	found.append_array(_LATER_LINES.slice(0, step))
	return found


func _put_symbols() -> void:
	_formula.put_symbol("a_symbol", "a", Palette.Role.A)
	_formula.put_symbol("b_symbol", "b", Palette.Role.B)
	_formula.put_symbol("n", "n̂", Palette.Role.UNIT)
	_formula.put_symbol("poi", "POI", Palette.Role.PROJECTION)
	_formula.put_symbol("reset", tr("reset"), Palette.Role.REST)
	_formula.put_symbol("wrong", tr("wrong"), Palette.Role.WRONG)


# Each of these has its counterpart in PointOfImpactModel.enter.
func _put_what_is_typed(model: PointOfImpactModel) -> void:
	var ink := Palette.Role.INK
	_formula.put_number("old_x", model.old_position.x, ink, tr("x of the old position"))
	_formula.put_number("old_y", model.old_position.y, ink, tr("y of the old position"))
	_formula.put_number("new_x", model.new_position.x, ink, tr("x of the new position"))
	_formula.put_number("new_y", model.new_position.y, ink, tr("y of the new position"))
	_formula.put_number("sx", model.line.start.x, ink, tr("x of the line's start"))
	_formula.put_number("sy", model.line.start.y, ink, tr("y of the line's start"))
	_formula.put_number("ex", model.line.end.x, ink, tr("x of the line's end"))
	_formula.put_number("ey", model.line.end.y, ink, tr("y of the line's end"))
	_formula.put_number("r", model.radius, ink, tr("radius of the ball"))
	_formula.put_number("speed", model.motion().length(), ink, tr("speed in pixels per frame"))


func _put_distances(model: PointOfImpactModel) -> void:
	_formula.put_number("old_distance", model.old_distance(), Palette.Role.INK)
	_formula.put_number("new_distance", model.new_distance(), Palette.Role.INK)
	_formula.put_number("r_value", model.radius, Palette.Role.INK)
	_formula.put_number("a", model.way_to_contact(), Palette.Role.A)
	_formula.put_number("b", model.way_of_frame(), Palette.Role.B)
	_formula.put_text("t", NumberText.short(model.fraction()), Palette.Role.INK)
	_formula.put_text(
		"wrong_t", NumberText.short(model.fraction_with_mistake()), Palette.Role.WRONG
	)


func _put_places(model: PointOfImpactModel) -> void:
	_formula.put_vector("v_pair", model.motion(), Palette.Role.INK)
	_formula.put_text("reset_pair", tr("not needed"), Palette.Role.REST)
	_formula.put_text("poi_pair", tr("none"), Palette.Role.PROJECTION)
	if model.is_reset():
		_formula.put_vector("reset_pair", model.reset_position(), Palette.Role.REST)
	var impact := model.impact()
	if impact.hit:
		_formula.put_vector("poi_pair", impact.position, Palette.Role.PROJECTION)
