class_name EasyBounceFormula
extends RefCounted
## The formula of the lesson on the easy bounce: its lines, and what each name in them is.
##
## The numbers of either program have the color of its ball.

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of [param step] with the numbers of [param model] for its ball [param moved].
func show_model(model: EasyBounceModel, moved: Ball, step: int) -> void:
	_put_ball(model, moved)
	_put_easy(model, moved)
	_put_right(model, moved)
	var wanted: Array[int] = [step]
	if step == EasyBounceTexts.Step.BOUNCE:
		wanted = [
			EasyBounceTexts.Step.DETECT, EasyBounceTexts.Step.PUT_BACK, EasyBounceTexts.Step.FLIP
		]
	var lines: PackedStringArray = [
		"{p} = ( {px} , {py} )     {v} = ( {vx} , {vy} )",
		"r = {r}     " + tr("tilt") + " = {tilt}°     " + tr("frame") + " {frame}",
	]
	for one in wanted:
		lines.append_array(_easy_lines(model, moved, one))
		if step != EasyBounceTexts.Step.BOUNCE and model.tilt_degrees != 0.0:
			lines.append_array(_right_lines(one))
	_formula.show_lines(lines)


func _easy_lines(model: EasyBounceModel, moved: Ball, step: int) -> PackedStringArray:
	var line_name := tr("wall") if model.is_wall else tr("floor")
	var axis := "x" if model.is_wall else "y"
	match step:
		EasyBounceTexts.Step.DETECT:
			var easy_distance := "{easy} %s − %s = {line_at} − {p_axis} = {straight} {easy_hit}"
			return [easy_distance % [line_name, axis]]
		EasyBounceTexts.Step.PUT_BACK when model.easy_detects(moved):
			return ["{easy} %s = %s − r = {line_at} − {radius} = {back}" % [axis, line_name]]
		EasyBounceTexts.Step.PUT_BACK:
			return ["{easy} " + tr("no hit: it stays where it is")]
		EasyBounceTexts.Step.FLIP:
			return ["{easy} v = {v_easy}"]
	return []


func _right_lines(step: int) -> PackedStringArray:
	match step:
		EasyBounceTexts.Step.DETECT:
			return ["{right} (P − L) · {n} = {shortest} {right_hit}"]
		EasyBounceTexts.Step.PUT_BACK:
			return ["{right} P + {depth} {n} = {p_right}"]
		EasyBounceTexts.Step.FLIP:
			return ["{right} v − 2 (v · {n}) {n} = {v_right}"]
	return []


func _put_ball(model: EasyBounceModel, moved: Ball) -> void:
	var place := moved.position
	var velocity := moved.velocity
	_formula.put_symbol("p", "P", Palette.Role.INK)
	_formula.put_symbol("v", "v", Palette.Role.PROJECTION)
	_formula.put_number("px", place.x, Palette.Role.INK, tr("x of the ball"))
	_formula.put_number("py", place.y, Palette.Role.INK, tr("y of the ball"))
	_formula.put_number("vx", velocity.x, Palette.Role.PROJECTION, tr("x of v"))
	_formula.put_number("vy", velocity.y, Palette.Role.PROJECTION, tr("y of v"))
	_formula.put_number("r", moved.radius, Palette.Role.INK, tr("Radius of the ball"))
	_formula.put_number(
		"tilt", model.tilt_degrees, Palette.Role.INK, tr("Tilt of the line in degrees")
	)
	_formula.put_number("frame", model.frame(), Palette.Role.INK)


func _put_easy(model: EasyBounceModel, moved: Ball) -> void:
	var easy := model.easy_result(moved)
	var hit := EasyBounceTexts.hit_text(model.easy_detects(moved))
	_formula.put_symbol("easy", tr("easy:"), Palette.Role.B)
	_formula.put_number("line_at", model.line_at(moved.position), Palette.Role.INK)
	_formula.put_number("p_axis", _on_axis(moved, model), Palette.Role.INK)
	_formula.put_number("radius", moved.radius, Palette.Role.INK)
	_formula.put_number("straight", model.straight_distance(moved.position), Palette.Role.B)
	_formula.put_text("easy_hit", hit, Palette.Role.B)
	_formula.put_number("back", _on_axis(easy, model), Palette.Role.B)
	_formula.put_vector("v_easy", easy.velocity, Palette.Role.B)


func _put_right(model: EasyBounceModel, moved: Ball) -> void:
	var right := model.right_result(moved)
	var gap := LineDistance.gap(moved, model.line())
	var hit := EasyBounceTexts.hit_text(LineDistance.is_overlapping(moved, model.line()))
	_formula.put_symbol("right", tr("right:"), Palette.Role.A)
	_formula.put_symbol("n", "n̂", Palette.Role.UNIT)
	_formula.put_number("shortest", model.shortest_distance(moved.position), Palette.Role.A)
	_formula.put_text("right_hit", hit, Palette.Role.A)
	_formula.put_vector("p_right", right.position, Palette.Role.A)
	_formula.put_number("depth", maxf(-gap, 0.0), Palette.Role.A)
	_formula.put_vector("v_right", right.velocity, Palette.Role.A)


# The only component that the easy program looks at: y for a floor, x for a wall.
func _on_axis(ball: Ball, model: EasyBounceModel) -> float:
	return ball.position.x if model.is_wall else ball.position.y
