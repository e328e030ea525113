class_name EasyBounceReadout
extends RefCounted
## The table of the lesson on the easy bounce: what each step of the easy program gives for the
## ball, how far that is from right, and the run time of the call; and the distance by the normal.
## Each row comes with its step.

var _readout: Readout


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout


## Fills the rows up to [param step] of [EasyBounceTexts] for the ball [param moved] of
## [param model].
func show_model(model: EasyBounceModel, moved: Ball, step: int) -> void:
	_readout.visible = step >= EasyBounceTexts.Step.DETECT
	if not _readout.visible:
		return
	_show_distances(model, moved)
	var easy := model.easy_result(moved)
	if step >= EasyBounceTexts.Step.PUT_BACK:
		var error := model.position_error(moved)
		_show_vector(tr("easy place"), easy.position, error, _put_back(model, moved))
	if step >= EasyBounceTexts.Step.FLIP:
		var error := model.velocity_error(moved)
		_show_vector(tr("easy velocity"), easy.velocity, error, _flip(model, moved))
	_hide_rows_after(step)


# The headings and two distances, then one row a step.
func _hide_rows_after(step: int) -> void:
	_readout.show_rows(step + 2)


func _show_distances(model: EasyBounceModel, moved: Ball) -> void:
	var distance := model.straight_distance.bind(moved.position)
	_show_distance(tr("easy distance"), distance, model.distance_error(moved))
	var from_pivot := moved.position.minus(model.pivot)
	var by_normal := LineDistance.signed_distance.bind(from_pivot, model.line_at_origin())
	var shortest: float = by_normal.call()
	_show_distance(tr("by the normal"), by_normal, model.exact_error(shortest, moved.position))


# The calls of the easy program whose run time is measured; each changes a copy of the ball.
func _put_back(model: EasyBounceModel, moved: Ball) -> Callable:
	var at := model.line_at(moved.position)
	var ball := model.easy_result(moved)
	if model.is_wall:
		return AxisBounce.put_beside_wall.bind(ball, at)
	return AxisBounce.put_on_floor.bind(ball, at)


func _flip(model: EasyBounceModel, moved: Ball) -> Callable:
	var ball := model.easy_result(moved)
	return AxisBounce.flip_x.bind(ball) if model.is_wall else AxisBounce.flip_y.bind(ball)


func _show_distance(title: String, way: Callable, error: float) -> void:
	var distance: float = way.call()
	_show(title, NumberText.short(distance), error, way)


func _show_vector(title: String, vector: Vec2, error: float, way: Callable) -> void:
	_show(title, NumberText.pair(vector.x, vector.y, 3), error, way)


# The error as it is, not as a power of ten: here it is seen on the board.
func _show(title: String, value: String, error: float, way: Callable) -> void:
	var error_text := NumberText.short(absf(error), 3)
	var time := _readout.time_text(CallTimer.nanoseconds(way))
	_readout.show_texts(title, [title, value, error_text, time])
