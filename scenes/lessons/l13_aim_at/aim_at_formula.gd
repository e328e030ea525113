class_name AimAtFormula
extends RefCounted
## The formula of the lesson on aiming at a target: its lines, and what each name in them is.

const _PLACES := "P = ( {Px} , {Py} )   T = ( {Tx} , {Ty} )"
const _HULL := "α = {hull_degrees}°   β = {barrel_degrees}°"
const _SIZES := "L = {length}   {s} = {speed}"
const _BARREL := "{d} = (cos γ, sin γ) = {d_pair}"
const _NOZZLE := "N = P + L {d} = {N_pair}"
# A component smaller than this is what rounding leaves of 0.
const _ROUNDING := 1e-15

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of [param step] with the numbers of [param model].
func show_model(model: AimAtModel, shots: AimShots, step: int) -> void:
	_put_given(model)
	_put_angles(model)
	_put_shots(model, shots, step)
	_formula.show_lines(_lines(model, step))


func _lines(model: AimAtModel, step: int) -> PackedStringArray:
	var found: PackedStringArray = [_PLACES, _HULL]
	if step in [AimAtModel.Step.CURRENT, AimAtModel.Step.SPRITE, AimAtModel.Step.FIRE]:
		found.append(_SIZES)
	if step in [AimAtModel.Step.CURRENT, AimAtModel.Step.SPRITE]:
		found.append(_line_of_gamma(model))
		found.append(_BARREL)
	if step == AimAtModel.Step.CURRENT:
		found.append(_NOZZLE)
	if step == AimAtModel.Step.SPRITE:
		found.append("{g} = {g_pair}   t = {t}")
		found.append("{v} = {s} {d} + t {g} = {v_pair}")
		found.append("atan2({v_y}, {v_x})%s = {v_degrees}°" % _turn_added(_raw_of_v(model)))
	if step >= AimAtModel.Step.LOOK:
		found.append_array(_lines_on_target(model, step))
	return found


func _lines_on_target(model: AimAtModel, step: int) -> PackedStringArray:
	var found: PackedStringArray = ["T − P = {way_pair}   |T − P| = {distance}"]
	if model.shot_case() == AimAtModel.Case.NO_DIRECTION:
		found.append(tr("no direction"))
		return found
	var seen := model.target_degrees()
	found.append("θ = atan2({way_y}, {way_x})%s = {theta}°" % _turn_added(seen))
	match step:
		AimAtModel.Step.NESTED:
			var raw := Conventions.in_range(seen) - Conventions.in_range(model.hull_degrees)
			var added := _added(raw, Conventions.in_range(model.wanted_degrees()))
			found.append("β′ = θ − α%s = {wanted}°" % added)
		AimAtModel.Step.TURN, AimAtModel.Step.EARLY:
			found.append(_line_of_gamma(model))
			var gamma := Conventions.in_range(model.current_degrees())
			var raw := Conventions.in_range(seen) - gamma
			var added := _added(raw, model.turn_degrees())
			found.append("δ = θ − γ%s = {delta}°" % added)
			found.append("h = {half_life}")
			if step == AimAtModel.Step.EARLY:
				found[-1] += "   t = {fire}   R = {radius}"
		AimAtModel.Step.FIRE:
			found.append("{d} = (cos θ, sin θ) = {d_pair}")
			found.append(_NOZZLE)
			if model.shot_case() == AimAtModel.Case.HITS:
				found.append("t = (|T − P| − L) / {s} = {flight}")
	return found


func _line_of_gamma(model: AimAtModel) -> String:
	var raw := Conventions.in_range(model.hull_degrees)
	raw += Conventions.in_range(model.barrel_degrees)
	var added := _added(raw, Conventions.in_range(model.current_degrees()))
	return "γ = α + β%s = {gamma}°" % added


# The full turn that is added to an angle below 0 where a full turn is chosen: atan2 does not.
static func _turn_added(degrees: float) -> String:
	return _added(degrees, Conventions.in_range(degrees))


# What leads from an angle to the same one within half a turn, or a full one.
static func _added(raw: float, wanted: float) -> String:
	match roundi((wanted - raw) / 360.0):
		1:
			return " + 360°"
		-1:
			return " − 360°"
	return ""


func _raw_of_v(model: AimAtModel) -> float:
	return AimShots.new(model).falling_velocity(AimAtModel.POSES[1]).angle_degrees()


# Each of these has its counterpart in AimAtModel.enter.
func _put_given(model: AimAtModel) -> void:
	var ink := Palette.Role.INK
	_formula.put_number("Px", model.hull.x, Palette.Role.A, tr("x of the hull"))
	_formula.put_number("Py", model.hull.y, Palette.Role.A, tr("y of the hull"))
	_formula.put_number("Tx", model.target.x, Palette.Role.B, tr("x of the target"))
	_formula.put_number("Ty", model.target.y, Palette.Role.B, tr("y of the target"))
	var alpha := Conventions.in_range(model.hull_degrees)
	var beta := Conventions.in_range(model.barrel_degrees)
	_formula.put_angle("hull_degrees", alpha, Palette.Role.A, tr("angle of the hull"))
	_formula.put_angle("barrel_degrees", beta, ink, tr("angle of the barrel on the hull"))
	_formula.put_number("length", model.length, ink, tr("length of the barrel"))
	_formula.put_symbol("s", "s", Palette.Role.PROJECTION)
	_formula.put_number("speed", model.speed, Palette.Role.PROJECTION, tr("speed of the bullet"))
	_formula.put_number("half_life", model.half_life, ink, tr("seconds for half of the turn"))
	_formula.put_number("fire", model.fire, ink, tr("seconds until it fires"))
	_formula.put_number("radius", model.radius, Palette.Role.B, tr("radius of the target"))


func _put_angles(model: AimAtModel) -> void:
	var ink := Palette.Role.INK
	_formula.put_angle("gamma", Conventions.in_range(model.current_degrees()), ink)
	_formula.put_angle("theta", Conventions.in_range(model.target_degrees()), Palette.Role.B)
	_formula.put_angle("wanted", Conventions.in_range(model.wanted_degrees()), ink)
	_formula.put_angle("delta", model.turn_degrees(), ink)
	# What rounding leaves of a difference of places grows with both.
	var size := model.hull.length() + model.target.length()
	_formula.put_vector_sum("way_pair", model.way(), Vec2.new(size, size), Palette.Role.B)
	_formula.put_number("way_x", model.way().x, Palette.Role.B)
	_formula.put_number("way_y", model.way().y, Palette.Role.B)
	_formula.put_sum("distance", model.way().length(), size, Palette.Role.B)


func _put_shots(model: AimAtModel, shots: AimShots, step: int) -> void:
	var blue := Palette.Role.PROJECTION
	var shot := shots.right if step >= AimAtModel.Step.LOOK else shots.current
	_formula.put_symbol("d", "d", blue)
	var direction := _without_rounding(Vec2.unit_degrees(shot.degrees))
	_formula.put_vector("d_pair", direction, blue)
	var barrel := direction.scaled(model.length)
	var sizes := Vec2.new(absf(model.hull.x) + absf(barrel.x), absf(model.hull.y) + absf(barrel.y))
	_formula.put_vector_sum("N_pair", model.hull.plus(barrel), sizes, Palette.Role.INK)
	var size := model.hull.length() + model.length
	_formula.put_sum("flight", shots.right.moment, size / model.speed, blue)
	_formula.put_symbol("g", "g", Palette.Role.UNIT)
	_formula.put_vector("g_pair", Vec2.new(0.0, AimAtModel.GRAVITY), Palette.Role.UNIT)
	_formula.put_number("t", AimAtModel.POSES[1], Palette.Role.INK)
	var velocity := shots.falling_velocity(AimAtModel.POSES[1])
	_formula.put_symbol("v", "v", Palette.Role.REST)
	_formula.put_vector("v_pair", velocity, Palette.Role.REST)
	_formula.put_number("v_x", velocity.x, Palette.Role.REST)
	_formula.put_number("v_y", velocity.y, Palette.Role.REST)
	var degrees := Conventions.in_range(velocity.angle_degrees())
	_formula.put_angle("v_degrees", degrees, Palette.Role.REST)


static func _without_rounding(unit: Vec2) -> Vec2:
	return Vec2.new(
		unit.x if absf(unit.x) > _ROUNDING else 0.0, unit.y if absf(unit.y) > _ROUNDING else 0.0
	)
