extends Lesson
## The lesson on angled lines, the assignment of the course: balls bounce among lines that can be
## drawn, moved and deleted, under gravity in any direction.

## Keys of this lesson, for the help line.
const ACTIONS := AngledLinesKeys.ACTIONS
# Half of what the board shows at least, in pixels of the course.
const _HALF_VIEW := Vector2i(290, 200)
const _SNAP_STEP := 10.0
# The timeline at the foot of the board needs room below the lines.
const _HALF_VIEW_WITH_TIMELINE := Vector2i(290, 245)

var _model := AngledLinesModel.new()
var _formula: AngledLinesFormula
var _panel: AngledLinesPanel
# What was refused last, until it has been told.
var _problem := ""

@onready var _drawing: AngledLinesDrawing = %Drawing
@onready var _lines: LineViews = %Lines
@onready var _velocity: DraggableVector = %Velocity
@onready var _gravity: GravityArrow = %Gravity
@onready var _pointer: BoardPointer = %Pointer
@onready var _player: AngledLinesPlayer = %Player
@onready var _engine: EngineLane = %Engine
@onready var _timeline: TimelineCard = %TimelineCard
@onready var _status: Label = %Status


func start() -> void:
	for part: CanvasItem in [_lines, _gravity]:
		(%Grid as Grid).take(part)
	board.snap_step = _SNAP_STEP
	var formula := services[&"formula"] as Formula
	_formula = AngledLinesFormula.new(formula)
	_panel = AngledLinesPanel.new(services)
	_drawing.measure_with(_player.meter)
	_player.play(_model, services[&"transport"] as Transport)
	_player.stepped.connect(func(is_on: bool) -> void: _drawing.follow_step(_model, is_on))
	_player.advanced.connect(_show_moment)
	_player.turned.connect(_show_moment)
	_player.refused.connect(noticed.emit)
	_connect_board()
	_connect_panel(formula)
	_panel.ask()
	resized.connect(_show_all)
	_show_all()


func state() -> Dictionary:
	return _model.to_dictionary()


func show_state(stored: Dictionary) -> void:
	_player.pause()
	_model.from_dictionary(stored)
	_show_all()


## Reset goes back to the start of the situation that was picked last.
func reset_state(_first: Dictionary) -> Dictionary:
	return _model.start_again().to_dictionary()


func link_state() -> Dictionary:
	return AngledLinesLink.state_of(_model)


func link_base(first: Dictionary, wanted: Dictionary) -> Dictionary:
	return AngledLinesLink.base(first, wanted)


func link_problem(linked: Dictionary) -> String:
	return AngledLinesLink.problem_of(linked)


func show_link(linked: Dictionary) -> void:
	show_state(AngledLinesLink.to_dictionary(linked))


func _connect_board() -> void:
	_connect_keys(%Keys as AngledLinesKeys)
	board.pointed.connect(func(at: Vec2, _button: MouseButton) -> void: _pointer.point(at, _model))
	board.released.connect(_pointer.release)
	_pointer.ball_taken.connect(_select)
	_pointer.ball_moved.connect(func(at: Vec2) -> void: _change_ball(at, _model.ball().velocity))
	_pointer.ball_released.connect(_finish)
	_pointer.line_drawn.connect(_lines.add_line)
	_lines.changed.connect(
		func(lines: Array[LineSegment]) -> void: _show_edit(_model.set_lines(lines))
	)
	_velocity.moved.connect(_move_arrow)
	_gravity.turned.connect(func(pull: Vec2) -> void: _show_edit(_model.set_gravity(pull)))
	_timeline.moved.connect(_follow_jump)
	for part: Object in [_lines, _velocity, _gravity]:
		part.connect(&"released", _finish)


func _connect_keys(keys: AngledLinesKeys) -> void:
	keys.gravity_pointed.connect(_point_gravity)
	keys.preset_picked.connect(_pick)
	keys.step_wanted.connect(_player.step)
	keys.impact_wanted.connect(_timeline.go_to_impact)
	keys.pressed.connect(_act)


func _connect_panel(formula: Formula) -> void:
	formula.number_entered.connect(_enter_number)
	var options := services[&"options"] as LessonOptions
	options.switched.connect(_switch)
	options.chosen.connect(_choose_method)
	options.preset_picked.connect(_pick)
	(services[&"question"] as Question).board_wanted.connect(_show_question.unbind(1))
	(services[&"mistakes"] as Mistakes).mistake_picked.connect(_switch_mistake)


# What the student does.


func _act(action: StringName) -> void:
	match action:
		&"lab_next_bounciness":
			AngledLinesEntry.take_next_bounciness(_model)
			_finish()
		&"lab_toggle_trails":
			_toggle_trails()
		&"lab_clear_trails":
			_drawing.clear_trails(_model)
		&"lab_delete_line":
			_lines.delete_focused()


func _point_gravity(direction: Vec2) -> void:
	_problem = _model.point_gravity(direction)
	_finish()


func _pick(preset: String) -> void:
	if preset == "fetch":
		_model.fetch_balls()
		_drawing.clear_trails(_model)
		_show_moment()
	else:
		_model.set_up(preset.to_int())
		_finish()


func _select(index: int) -> void:
	_player.pause()
	_model.selected = index
	_engine.begin_anew(_model)
	_show_moment()


func _change_ball(position_wanted: Vec2, velocity: Vec2) -> void:
	_show_edit(_model.change_ball(position_wanted, velocity))


func _move_arrow(tail: Vec2, head: Vec2) -> void:
	var ball := _model.ball()
	if tail.distance_to(ball.position) > 0.0:
		_change_ball(tail, ball.velocity)
	else:
		_change_ball(ball.position, _drawing.velocity_of(tail, head))


func _enter_number(name_in_line: String, value: float) -> void:
	_player.pause()
	_problem = AngledLinesEntry.enter(_model, name_in_line, value)
	_finish()


func _choose_method(_key: String, place: int) -> void:
	_model.set_method(place as SteppingMethods.Method)
	_finish()


func _switch_mistake(number: int) -> void:
	_model.set_mistake(number)
	_finish()


func _show_question() -> void:
	_model.take(_panel.world_of_question())
	_finish()


func _switch(key: String, on: bool) -> void:
	if key == "trails":
		_toggle_trails()
	elif on:
		_engine.begin(_model)
	else:
		_engine.switch_off()


func _follow_jump(problem: String) -> void:
	_player.pause()
	noticed.emit(problem)
	_drawing.clear_trails(_model)
	_show_moment()


func _toggle_trails() -> void:
	_drawing.has_trails = not _drawing.has_trails
	_panel.show_trails(_drawing.has_trails)


func _finish() -> void:
	_show_all()
	edited.emit()
	# After the edit is stored: that takes older notices away.
	noticed.emit(_problem)
	_problem = ""


# What the student sees.


func _process(_delta: float) -> void:
	if not _player.is_playing():
		_panel.compare()
	if _player.meter.end_frame():
		_show_status()


func _show_all() -> void:
	var half_view := _HALF_VIEW_WITH_TIMELINE if _model.timeline else _HALF_VIEW
	board.fit([Vec2.new(half_view.x, half_view.y)])
	_engine.begin_anew(_model)
	_drawing.show_all(_model)
	_drawing.show_surroundings(_model)
	_panel.show_all(_model, _drawing.has_trails)
	_panel.show_engine(_engine.is_on())
	_show_moment()


# While something is dragged: what was refused is told, and the old state stays.
func _show_edit(problem: String) -> void:
	_player.pause()
	_problem = problem
	noticed.emit(problem)
	_engine.begin_anew(_model)
	_drawing.clear_trails(_model)
	_drawing.show_surroundings(_model)
	_show_moment()


func _show_moment() -> void:
	_drawing.show_balls(_model)
	_timeline.show_model(_model)
	_engine.show_moment(_model)
	if _player.is_playing():
		_drawing.hide_forecast()
		if not _formula.follow_model(_model):
			return
	else:
		var forecast := _model.forecast(_model.world)
		_drawing.show_forecast(_model, forecast)
		_formula.show_model(_model, forecast.next_bounce)
	_show_status()


func _show_status() -> void:
	_status.text = AngledLinesTexts.status(_model, _player.meter.milliseconds)
