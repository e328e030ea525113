class_name EasyBounceFormula
extends RefCounted
## The formula of the lesson on the easy bounce: its lines, and what each name in them is.
##
## The numbers of either program have the color of its ball: on a level line there is only one.

const _POINT := "{l} = {l_pair}     {n} = {n_pair}"
const _NORMAL := "{n} = {n_pair}"
const _SHORTEST := "{right} ({p} − {l}) · {n} = {dx}·{nx} + {dy}·{ny} = {shortest}     {right_hit}"
const _ON_THE_LINE := "{right} ({p} − {l}) · {n} = {shortest}     {right_hit}"
const _BACK_ALONG_NORMAL := "{right} {p} + {depth} {n} = {p_pair} + {depth} {n_pair} = {p_right}"
const _ALONG_NORMAL := "{right} {v} · {n} = {vx_}·{nx} + {vy_}·{ny} = {along_n}"
const _REFLECTED := "{right} {v} − 2 ({v} · {n}) {n} = {v_pair} − 2·{along_n} {n_pair} = {v_right}"
# A distance of less than this share of P − L.
const _NEAR := 1e-9

var _formula: Formula
var _model: EasyBounceModel
var _moved: Ball


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of [param step] with the numbers of [param model] for its ball [param moved].
func show_model(model: EasyBounceModel, moved: Ball, step: int) -> void:
	_model = model
	_moved = moved
	_put_ball()
	_put_easy()
	_put_right()
	var lines: PackedStringArray = [
		"{p} = ( {px} , {py} )     {v} = ( {vx} , {vy} )",
		"r = {r}     " + tr("tilt") + " = {tilt}°     " + tr("frame") + " {frame}",
	]
	match step:
		EasyBounceTexts.Step.MOVE:
			var before := tr("before")
			lines.append_array([before + " = {old}", before + " + {v} = {p_pair}"])
		EasyBounceTexts.Step.BOUNCE:
			lines.append_array([_easy_distance(), _easy_place(), _easy_velocity()])
		EasyBounceTexts.Step.DETECT:
			_append(lines, _easy_distance(), [_POINT, _right_distance()])
		EasyBounceTexts.Step.PUT_BACK:
			_append(lines, _easy_place(), _right_place())
		EasyBounceTexts.Step.FLIP:
			_append(lines, _easy_velocity(), _right_velocity())
	_formula.show_lines(lines)


# What is right is told where it is not the same as what is easy.
func _append(lines: PackedStringArray, easy: String, right: PackedStringArray) -> void:
	lines.append(easy)
	if not _model.is_level():
		lines.append_array(right)


func _easy_distance() -> String:
	var names := _line_and_axis()
	var distance := "{easy} %s − %s = {line_at} − {p_axis} = {straight}     {easy_hit}"
	return distance % [names[0], names[1]]


func _easy_place() -> String:
	if not _model.easy_detects(_moved):
		return "{easy} " + tr("no hit: P stays")
	var names := _line_and_axis()
	return "{easy} %s = %s − r = {line_at} − {radius} = {back}" % [names[1], names[0]]


func _easy_velocity() -> String:
	if not _model.easy_detects(_moved):
		return "{easy} " + tr("no hit: v stays")
	if not _model.easy_flips(_moved):
		var component := "vx" if _model.is_wall else "vy"
		return "{easy} " + tr("%s is not above 0: v stays") % component
	return "{easy} %s = {v_easy}" % ("(−vx, vy)" if _model.is_wall else "(vx, −vy)")


func _right_place() -> PackedStringArray:
	if not _model.right_detects(_moved):
		return ["{right} " + tr("no hit: P stays")]
	var depth := "{right} " + tr("r − distance") + " = {radius} − {distance} = {depth}"
	return [_NORMAL, depth, _BACK_ALONG_NORMAL]


func _right_velocity() -> PackedStringArray:
	if not _model.right_detects(_moved):
		return ["{right} " + tr("no hit: v stays")]
	if not _model.right_reflects(_moved):
		return [_NORMAL, _ALONG_NORMAL, "{right} " + tr("v · n̂ is not below 0: v stays")]
	return [_NORMAL, _ALONG_NORMAL, _REFLECTED]


# So near to the line that the terms cancel, no number of digits shows it.
func _right_distance() -> String:
	var from_l := _model.from_line_start(_moved.position)
	var is_near := absf(from_l.dot(_model.normal())) < _NEAR * from_l.length()
	return _ON_THE_LINE if is_near else _SHORTEST


# What the easy program looks at: the line by its name, and a single component.
func _line_and_axis() -> PackedStringArray:
	return [tr("wall"), "x"] if _model.is_wall else [tr("floor"), "y"]


func _put_ball() -> void:
	var place := _moved.position
	var velocity := _moved.velocity
	_formula.put_symbol("p", "P", Palette.Role.INK)
	_formula.put_symbol("v", "v", Palette.Role.PROJECTION)
	_formula.put_number("px", place.x, Palette.Role.INK, tr("x of the ball"))
	_formula.put_number("py", place.y, Palette.Role.INK, tr("y of the ball"))
	_formula.put_vector("p_pair", place, Palette.Role.INK)
	_formula.put_vector("old", place.minus(velocity), Palette.Role.QUIET)
	_formula.put_number("vx", velocity.x, Palette.Role.PROJECTION, tr("x of v"))
	_formula.put_number("vy", velocity.y, Palette.Role.PROJECTION, tr("y of v"))
	_formula.put_number("vx_", velocity.x, Palette.Role.PROJECTION)
	_formula.put_number("vy_", velocity.y, Palette.Role.PROJECTION)
	_formula.put_vector("v_pair", velocity, Palette.Role.PROJECTION)
	_formula.put_number("r", _moved.radius, Palette.Role.INK, tr("Radius of the ball"))
	_formula.put_number("radius", _moved.radius, Palette.Role.INK)
	var title := tr("Tilt of the line in degrees")
	if Conventions.uses_radians():
		title = tr("Tilt of the line in radians")
	_formula.put_angle("tilt", _model.tilt_degrees, Palette.Role.INK, title)
	# No answer, so it is not hidden with them.
	_formula.put_text("frame", NumberText.short(_model.frame()), Palette.Role.INK)


func _put_easy() -> void:
	var role := Palette.Role.A if _model.is_level() else Palette.Role.B
	var easy := _model.easy_result(_moved)
	var straight := _model.straight_distance(_moved.position)
	_formula.put_symbol("easy", tr("easy:"), role)
	_formula.put_number("line_at", _model.line_at(_moved.position), Palette.Role.INK)
	_formula.put_number("p_axis", _on_axis(_moved), Palette.Role.INK)
	_formula.put_number("straight", straight, role)
	_formula.put_answer("easy_hit", _hit_text(straight, _model.easy_detects(_moved)), role)
	_formula.put_number("back", _on_axis(easy), role)
	_formula.put_vector("v_easy", easy.velocity, role)


func _put_right() -> void:
	var right := _model.right_result(_moved)
	var from_l := _without_rounding(_model.from_line_start(_moved.position))
	var normal := _model.normal()
	# By the numbers of its line: far out their rounding is not that of the model.
	var shortest := from_l.dot(normal)
	_formula.put_symbol("right", tr("right:"), Palette.Role.A)
	_formula.put_symbol("l", "L", Palette.Role.INK)
	_formula.put_vector("l_pair", _model.line().start, Palette.Role.INK)
	_formula.put_symbol("n", "n̂", Palette.Role.UNIT)
	_formula.put_vector("n_pair", normal, Palette.Role.UNIT)
	_formula.put_number("nx", normal.x, Palette.Role.UNIT)
	_formula.put_number("ny", normal.y, Palette.Role.UNIT)
	_formula.put_number("dx", from_l.x, Palette.Role.INK)
	_formula.put_number("dy", from_l.y, Palette.Role.INK)
	_formula.put_sum("shortest", shortest, from_l.length(), Palette.Role.A)
	_formula.put_number("distance", shortest, Palette.Role.A)
	_formula.put_answer(
		"right_hit", _hit_text(shortest, _model.right_detects(_moved)), Palette.Role.A
	)
	_formula.put_number("depth", _model.depth(_moved), Palette.Role.A)
	_formula.put_vector("p_right", right.position, Palette.Role.A)
	_formula.put_number("along_n", _moved.velocity.dot(normal), Palette.Role.A)
	_formula.put_vector("v_right", right.velocity, Palette.Role.A)


# A difference such as 120 − 120.00000000000001 is 0.
func _without_rounding(difference: Vec2) -> Vec2:
	var x := 0.0 if _model.is_rounding(difference.x, _moved) else difference.x
	return Vec2.new(x, 0.0 if _model.is_rounding(difference.y, _moved) else difference.y)


func _hit_text(distance: float, is_hit: bool) -> String:
	return EasyBounceTexts.hit_text(distance, _moved.radius, is_hit)


# The only component that the easy program looks at: y for a floor, x for a wall.
func _on_axis(ball: Ball) -> float:
	return ball.position.x if _model.is_wall else ball.position.y
