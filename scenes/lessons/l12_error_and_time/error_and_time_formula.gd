class_name ErrorAndTimeFormula
extends RefCounted
## The formula of the lesson on error and run time: the order of the method that is pointed at,
## from two of its settings.

const _ORDER := "{p} = log( {e1} / {e2} ) / log( {t2} / {t1} )"
const _LINES: PackedStringArray = [
	_ORDER,
	"{e1} / {e2} = {e1_number} / {e2_number} = {errors}",
	"{t2} / {t1} = {t2_number} / {t1_number} = {times}",
	"{p} = log( {errors} ) / log( {times} ) = {p_number}",
]

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the order between the measurement at [param place] and its neighbour. Says what is missing
## where nothing is pointed at ([param place] -1), where the method has one setting only, or where
## the two cannot be compared.
func show_order(measurements: Array[Measurement], place: int) -> void:
	_put_symbols()
	var other := ErrorAndTimeModel.neighbour(measurements, place) if place >= 0 else -1
	if other < 0:
		_show_hint(tr("Point at a mark on a line"), tr("to see its order p."))
	elif is_nan(ErrorAndTimeModel.order(measurements[place], measurements[other])):
		_show_hint(_reason(measurements[place], measurements[other]), tr("So there is no order p."))
	else:
		_show_pair(measurements[place], measurements[other])


func _put_symbols() -> void:
	_formula.put_symbol("p", "p", Palette.Role.PROJECTION)
	_formula.put_symbol("e1", "e₁", Palette.Role.B)
	_formula.put_symbol("e2", "e₂", Palette.Role.B)
	_formula.put_symbol("t1", "t₁", Palette.Role.A)
	_formula.put_symbol("t2", "t₂", Palette.Role.A)


func _show_hint(first: String, second: String) -> void:
	_formula.show_lines([_ORDER, first, second])


# Why two settings have no order.
func _reason(one: Measurement, other: Measurement) -> String:
	if not (one.has_answer() and other.has_answer()):
		return tr("One of the two settings has no answer.")
	if one.error == 0.0 or other.error == 0.0:
		return tr("One of the two errors is 0.")
	return tr("Both settings take the same time.")


func _show_pair(one: Measurement, other: Measurement) -> void:
	_formula.put_number("e1_number", one.error, Palette.Role.B)
	_formula.put_number("e2_number", other.error, Palette.Role.B)
	_formula.put_number("t1_number", one.run_time_us, Palette.Role.A)
	_formula.put_number("t2_number", other.run_time_us, Palette.Role.A)
	_formula.put_number("errors", ErrorAndTimeModel.error_ratio(one, other), Palette.Role.B)
	_formula.put_number("times", ErrorAndTimeModel.time_ratio(one, other), Palette.Role.A)
	_formula.put_number("p_number", ErrorAndTimeModel.order(one, other), Palette.Role.PROJECTION)
	_formula.show_lines(_LINES)
