class_name LeadTargetFormula
extends RefCounted
## The formula of the lesson on leading a target: its lines, and what each name in them is.

const _PLACES := "S = ( {Sx} , {Sy} )   T = ( {Tx} , {Ty} )"
const _GIVEN: PackedStringArray = [
	"{v} = ( {vx} , {vy} )   {u} = ( {ux} , {uy} )",
	"{s} = {speed}   R = {radius}",
]
const _RELATIVE := "{P} = T − S = {P_pair}   {V} = {v} − {u} = {V_pair}"
const _SHORT_RELATIVE := "{P} = {P_pair}   {V} = {v} − {u} = {V_pair}"
const _SQUARED: PackedStringArray = [
	"a = {V} · {V} − {s}² = {V_square} − {s_square} = {a}",
	"b = {P} · {V} − {s} R = {dot} − {s_R} = {b}",
	"c = {P} · {P} − R² = {P_square} − {R_square} = {c}",
]
const _DISCRIMINANT := "D = b² − a c = {b}² − {a}·{c} = {D}"

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of [param step] with the numbers of [param model].
func show_model(model: LeadTargetModel, shots: LeadShots, step: int) -> void:
	_put_given(model)
	_put_equation(model.equation())
	if model.can_hit():
		_put_hit(model, shots)
	if shots.wrong.is_fired():
		_formula.put_vector("wrong_pair", shots.wrong.direction, Palette.Role.WRONG)
	_formula.show_lines(_lines(model, shots, step))


func _lines(model: LeadTargetModel, shots: LeadShots, step: int) -> PackedStringArray:
	var found := _GIVEN.duplicate()
	# The roots need the room.
	if step == LeadTargetModel.Step.TIME:
		found.append(_SHORT_RELATIVE)
	else:
		found.insert(0, _PLACES)
		if step >= LeadTargetModel.Step.RELATIVE:
			found.append(_RELATIVE)
	if step in [LeadTargetModel.Step.REACH, LeadTargetModel.Step.TIME]:
		found.append("|{P} + {V} t| = R + {s} t")
	if step == LeadTargetModel.Step.TIME:
		found.append_array(_lines_on_time(model))
	if step >= LeadTargetModel.Step.AIM and model.can_hit():
		found.append_array(_lines_on_aim(model))
	if step == LeadTargetModel.Step.FIRE and shots.right.is_right:
		found.append("T + {v} t = {there}   S + {w} t = {place}")
	if LeadTargetTexts.is_compared(model, step) and shots.wrong.is_fired():
		found.append("{wrong}: {wrong_pair}")
	return found


func _lines_on_time(model: LeadTargetModel) -> PackedStringArray:
	if model.shot_case() == LeadTargetModel.Case.TOUCHES:
		return [_SQUARED[2], "c ≤ 0: " + tr("they touch already")]
	var found := _SQUARED.duplicate()
	found.append(_DISCRIMINANT)
	match model.shot_case():
		LeadTargetModel.Case.GETS_AWAY:
			found.append(tr("no root from 0 on"))
			return found
		LeadTargetModel.Case.KEEPS_AWAY:
			found.append(tr("no root from 0 on"))
			return found
	found.append_array(_lines_of_roots(model.equation()))
	return found


# With a sum in place of a difference nothing cancels, and a may be 0.
func _lines_of_roots(equation: LeadEquation) -> PackedStringArray:
	if equation.b >= 0.0 and equation.a == 0.0:
		return [tr("a is 0 but for rounding: the hit is very far away")]
	if equation.b > 0.0:
		return [
			"{t} = −(b + √D) / a = −({b} + {root}) / {a} = {first}",
			"{t2} = −c / (b + √D) = −{c} / ({b} + {root}) = {other}"
		]
	var found: PackedStringArray = ["{t} = c / (√D − b) = {c} / ({root} − {b}) = {first}"]
	if not is_nan(equation.other_root()):
		found.append("{t2} = (√D − b) / a = ({root} − {b}) / {a} = {other}")
	return found


func _lines_on_aim(model: LeadTargetModel) -> PackedStringArray:
	var found: PackedStringArray = [
		"{t} = {first}   {P} + {V} t = {sum}",
	]
	if model.aim().direction.length() > 0.0:
		found.append("{d} = ({P} + {V} t) / |{P} + {V} t| = {d_pair}")
		found.append("{w} = {u} + {s} {d} = {w_pair}")
	return found


# Each of these has its counterpart in LeadTargetModel.enter.
func _put_given(model: LeadTargetModel) -> void:
	_formula.put_number("Sx", model.shooter.x, Palette.Role.INK, tr("x of the shooter"))
	_formula.put_number("Sy", model.shooter.y, Palette.Role.INK, tr("y of the shooter"))
	_formula.put_number("Tx", model.target.x, Palette.Role.INK, tr("x of the target"))
	_formula.put_number("Ty", model.target.y, Palette.Role.INK, tr("y of the target"))
	_formula.put_symbol("v", "v", Palette.Role.B)
	_formula.put_number("vx", model.velocity.x, Palette.Role.B, tr("x of the target's velocity"))
	_formula.put_number("vy", model.velocity.y, Palette.Role.B, tr("y of the target's velocity"))
	_formula.put_symbol("u", "u", Palette.Role.UNIT)
	_formula.put_number("ux", model.own.x, Palette.Role.UNIT, tr("x of the shooter's velocity"))
	_formula.put_number("uy", model.own.y, Palette.Role.UNIT, tr("y of the shooter's velocity"))
	_formula.put_symbol("s", "s", Palette.Role.PROJECTION)
	_formula.put_number("speed", model.speed, Palette.Role.PROJECTION, tr("speed of the bullet"))
	_formula.put_number("radius", model.radius, Palette.Role.INK, tr("radii of both together"))
	_formula.put_symbol("wrong", tr("mistake"), Palette.Role.WRONG)


func _put_equation(equation: LeadEquation) -> void:
	_formula.put_symbol("P", "P", Palette.Role.A)
	_formula.put_symbol("V", "V", Palette.Role.REST)
	_formula.put_vector("P_pair", equation.way, Palette.Role.A)
	_formula.put_vector("V_pair", equation.velocity, Palette.Role.REST)
	_formula.put_number("V_square", equation.velocity.length_squared(), Palette.Role.INK)
	_formula.put_number("s_square", equation.speed * equation.speed, Palette.Role.INK)
	_formula.put_number("dot", equation.way.dot(equation.velocity), Palette.Role.INK)
	_formula.put_number("s_R", equation.speed * equation.radius, Palette.Role.INK)
	_formula.put_number("P_square", equation.way.length_squared(), Palette.Role.INK)
	_formula.put_number("R_square", equation.radius * equation.radius, Palette.Role.INK)
	_formula.put_number("a", equation.a, Palette.Role.INK)
	_formula.put_number("b", equation.b, Palette.Role.INK)
	_formula.put_number("c", equation.c, Palette.Role.INK)
	_formula.put_number("D", equation.discriminant, Palette.Role.INK)
	_formula.put_number("root", sqrt(maxf(equation.discriminant, 0.0)), Palette.Role.INK)
	_formula.put_symbol("t", "t", Palette.Role.PROJECTION)
	_formula.put_symbol("t2", "t₂", Palette.Role.QUIET)
	_formula.put_number("other", equation.other_root(), Palette.Role.QUIET)


func _put_hit(model: LeadTargetModel, shots: LeadShots) -> void:
	var aim := model.aim()
	var blue := Palette.Role.PROJECTION
	_formula.put_number("first", aim.time, blue)
	_formula.put_symbol("d", "d", blue)
	_formula.put_symbol("w", "w", blue)
	# What rounding leaves of a sum grows with its terms.
	var size := model.way().length() + model.relative_velocity().length() * aim.time
	var size_of_w := model.own.length() + model.speed
	_put_sum("sum", model.equation().way_after(aim.time), size, Palette.Role.INK)
	_formula.put_vector("d_pair", aim.direction, blue)
	_put_sum("w_pair", model.own.plus(aim.direction.scaled(model.speed)), size_of_w, blue)
	size = model.target.length() + model.velocity.length() * aim.time
	_put_sum("there", aim.target, size, Palette.Role.B)
	if shots.right.is_right:
		size = model.shooter.length() + size_of_w * aim.time
		_put_sum("place", shots.right.place_after(aim.time), size, blue)


func _put_sum(name_in_line: String, sum: Vec2, size: float, role: Palette.Role) -> void:
	_formula.put_vector_sum(name_in_line, sum, Vec2.new(size, size), role)
