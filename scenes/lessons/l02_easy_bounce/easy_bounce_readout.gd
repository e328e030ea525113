class_name EasyBounceReadout
## The table of the lesson on the easy bounce: what each step of the easy program gives for the
## ball, how far that is from right, and how long the call takes; below it the distance by the
## normal.


## Fills [param readout] for the ball [param moved] of [param model].
static func show_model(readout: Readout, model: EasyBounceModel, moved: Ball) -> void:
	var easy := model.easy_result(moved)
	var at := model.line_at(moved.position)
	var put_back := AxisBounce.put_on_floor.bind(easy.copy(), at)
	var flip := AxisBounce.flip_y.bind(easy.copy())
	if model.is_wall:
		put_back = AxisBounce.put_beside_wall.bind(easy.copy(), at)
		flip = AxisBounce.flip_x.bind(easy.copy())
	var straight := model.straight_distance(moved.position)
	_show(
		readout,
		[_translate("easy distance"), NumberText.short(straight)],
		model.distance_error(moved),
		model.straight_distance.bind(moved.position)
	)
	_show(
		readout,
		[_translate("easy place"), _pair(easy.position)],
		model.position_error(moved),
		put_back
	)
	_show(
		readout,
		[_translate("easy velocity"), _pair(easy.velocity)],
		model.velocity_error(moved),
		flip
	)
	_show_right(readout, model, moved)


static func _show_right(readout: Readout, model: EasyBounceModel, moved: Ball) -> void:
	var shortest := model.shortest_distance(moved.position)
	_show(
		readout,
		[_translate("by the normal"), NumberText.short(shortest)],
		model.exact_error(shortest, moved.position),
		LineDistance.signed_distance.bind(moved.position, model.line())
	)


static func _show(
	readout: Readout, title_and_value: PackedStringArray, error: float, way: Callable
) -> void:
	var time := NumberText.short(CallTimer.nanoseconds(way), 2)
	var texts := title_and_value.duplicate()
	texts.append(NumberText.short(absf(error), 3))
	texts.append(_translate("%s ns") % time)
	readout.show_texts(title_and_value[0], texts)


static func _pair(vector: Vec2) -> String:
	return NumberText.pair(vector.x, vector.y, 3)


static func _translate(text: String) -> String:
	return TranslationServer.translate(text)
