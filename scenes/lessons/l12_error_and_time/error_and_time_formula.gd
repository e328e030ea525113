class_name ErrorAndTimeFormula
extends RefCounted
## The formula of the lesson on error and run time: the order of the method that is pointed at,
## from two of its settings.

const _ORDER := "{p} = log( {e1} / {e2} ) / log( {t2} / {t1} )"

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the order between the measurement at [param place] and its neighbour. Says what is missing
## where nothing is pointed at ([param place] -1), where the method has one setting only, or where
## the errors cannot be compared.
func show_order(measurements: Array[Measurement], place: int) -> void:
	_put_symbols()
	var other := ErrorAndTimeModel.neighbour(measurements, place) if place >= 0 else -1
	if other >= 0:
		_show_pair(measurements[place], measurements[other])
	else:
		var hint := tr("Point at a method with several settings:")
		_formula.show_lines([_ORDER, hint, tr("its slope is the order p.")])


func _put_symbols() -> void:
	_formula.put_symbol("p", "p", Palette.Role.PROJECTION)
	_formula.put_symbol("e1", "e₁", Palette.Role.B)
	_formula.put_symbol("e2", "e₂", Palette.Role.B)
	_formula.put_symbol("t1", "t₁", Palette.Role.A)
	_formula.put_symbol("t2", "t₂", Palette.Role.A)


func _show_pair(one: Measurement, other: Measurement) -> void:
	var order := ErrorAndTimeModel.order(one, other)
	if not is_finite(order):
		_formula.show_lines([_ORDER, tr("An error of 0, or no answer,"), tr("has no order.")])
		return
	_put("p_number", order, Palette.Role.PROJECTION)
	_put("e1_number", one.error, Palette.Role.B)
	_put("e2_number", other.error, Palette.Role.B)
	_put("t1_number", one.run_time_us, Palette.Role.A)
	_put("t2_number", other.run_time_us, Palette.Role.A)
	(
		_formula
		. show_lines(
			[
				_ORDER + " = {p_number}",
				"{e1} / {e2} = {e1_number} / {e2_number}",
				"{t2} / {t1} = {t2_number} / {t1_number}",
			]
		)
	)


# What is measured has three digits at most.
func _put(name_in_line: String, value: float, role: Palette.Role) -> void:
	_formula.put_text(name_in_line, NumberText.short(value, 3), role)
