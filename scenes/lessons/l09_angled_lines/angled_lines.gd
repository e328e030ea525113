extends Lesson
## The lesson on angled lines, the assignment of the course: balls bounce among lines that can be
## drawn, moved and deleted, under gravity in any direction.

## Keys of this lesson, for the help line.
const ACTIONS := AngledLinesKeys.ACTIONS
# Half of what the board shows at least, in pixels of the course.
const _HALF_VIEW := Vector2i(290, 200)
const _SNAP_STEP := 10.0
const _FRAMES_BETWEEN := 6
const _BOUNCINESSES: Array[float] = [1.0, 0.8, 0.5, 0.0]

var _model := AngledLinesModel.new()
var _formula: AngledLinesFormula
var _panel: AngledLinesPanel
# A screen's frames since the formula was shown: while balls move, numbers change slowly enough to
# be read.
var _frames_unshown := 0
# What was refused last, until it has been told.
var _problem := ""

@onready var _drawing: AngledLinesDrawing = %Drawing
@onready var _lines: LineViews = %Lines
@onready var _velocity: DraggableVector = %Velocity
@onready var _gravity: GravityArrow = %Gravity
@onready var _pointer: BoardPointer = %Pointer
@onready var _player: AngledLinesPlayer = %Player
@onready var _status: Label = %Status


func start() -> void:
	snap_step = _SNAP_STEP
	var formula := services[&"formula"] as Formula
	_formula = AngledLinesFormula.new(formula)
	_panel = AngledLinesPanel.new(services)
	_drawing.measure_with(_player.meter)
	_player.play(_model, services[&"transport"] as Transport)
	_connect_player()
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
	var fresh := AngledLinesModel.new()
	fresh.method = _model.method
	fresh.mistake = _model.mistake
	fresh.set_up(_model.scene)
	return fresh.to_dictionary()


func _connect_player() -> void:
	_player.stepped.connect(_follow_step)
	_player.advanced.connect(_show_moment)
	_player.turned.connect(_show_moment)


func _connect_board() -> void:
	(%Keys as AngledLinesKeys).pressed.connect(_act)
	pointed.connect(func(at: Vec2, _button: MouseButton) -> void: _pointer.point(at, _model))
	released.connect(_pointer.release)
	_pointer.ball_taken.connect(_select)
	_pointer.ball_moved.connect(func(at: Vec2) -> void: _change_ball(at, _model.ball().velocity))
	_pointer.ball_released.connect(_finish)
	_pointer.line_drawn.connect(_lines.add_line)
	_lines.changed.connect(_take_lines)
	_velocity.moved.connect(_move_arrow)
	_gravity.turned.connect(_turn_gravity)
	for part: Object in [_lines, _velocity, _gravity]:
		part.connect(&"released", _finish)


func _connect_panel(formula: Formula) -> void:
	formula.number_entered.connect(_enter_number)
	formula.role_pointed.connect(_drawing.light)
	formula.refused.connect(noticed.emit)
	var options := services[&"options"] as LessonOptions
	options.switched.connect(func(_key: String, _on: bool) -> void: _toggle_trails())
	options.chosen.connect(_choose_method)
	options.preset_picked.connect(_pick)
	(services[&"question"] as Question).board_wanted.connect(_show_question)
	(services[&"mistakes"] as Mistakes).mistake_picked.connect(_switch_mistake)


# What the student does.


func _act(action: StringName) -> void:
	if AngledLinesKeys.is_gravity(action):
		_model.point_gravity(AngledLinesKeys.direction(action))
		_finish()
	elif AngledLinesKeys.preset(action) >= 0:
		_pick(str(AngledLinesKeys.preset(action)))
	match action:
		&"lab_step":
			_player.step(true)
		&"lab_step_back":
			_player.step(false)
		&"lab_next_bounciness":
			_take_next_bounciness()
		&"lab_toggle_trails":
			_toggle_trails()
		&"lab_clear_trails":
			_drawing.clear_trails(_model)
		&"lab_fetch_balls":
			_pick("fetch")
		&"lab_delete_line":
			_lines.delete_focused()


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
	_show_moment()


func _change_ball(position_wanted: Vec2, velocity: Vec2) -> void:
	_player.pause()
	_show_edit(_model.change_ball(position_wanted, velocity))


func _move_arrow(tail: Vec2, head: Vec2) -> void:
	var ball := _model.ball()
	if tail.distance_to(ball.position) > 0.0:
		_change_ball(tail, ball.velocity)
	else:
		_change_ball(ball.position, _drawing.velocity_of(tail, head))


func _turn_gravity(gravity: Vec2) -> void:
	_player.pause()
	_show_edit(_model.set_gravity(gravity))


func _take_next_bounciness() -> void:
	var place := _BOUNCINESSES.find(_model.world.surroundings.bounciness)
	_model.set_bounciness(_BOUNCINESSES[(place + 1) % _BOUNCINESSES.size()])
	_finish()


func _take_lines(lines: Array[LineSegment]) -> void:
	_player.pause()
	_show_edit(_model.set_lines(lines))


func _enter_number(name_in_line: String, value: float) -> void:
	_player.pause()
	_problem = AngledLinesEntry.enter(_model, name_in_line, value)
	_finish()


func _choose_method(_key: String, place: int) -> void:
	_model.set_method(place as SteppedWorld.Method)
	_finish()


func _switch_mistake(number: int) -> void:
	_model.set_mistake(number)
	_finish()


func _show_question() -> void:
	_model.take(_panel.world_of_question())
	_finish()


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


func _follow_step(is_forward: bool) -> void:
	_drawing.follow_step(_model, is_forward)


func _show_all() -> void:
	fit([Vec2.new(_HALF_VIEW.x, _HALF_VIEW.y)])
	_drawing.show_all(_model)
	_drawing.show_surroundings(_model)
	_panel.show_all(_model, _drawing.has_trails)
	_show_moment()


# While something is dragged: what was refused is told, and the old state stays.
func _show_edit(problem: String) -> void:
	_problem = problem
	noticed.emit(problem)
	_drawing.clear_trails(_model)
	_drawing.show_surroundings(_model)
	_show_moment()


func _show_moment() -> void:
	_drawing.show_balls(_model)
	_frames_unshown += 1
	if _player.is_playing():
		_drawing.hide_forecast()
		if _frames_unshown < _FRAMES_BETWEEN:
			return
		_formula.show_model(_model, _model.last_bounce)
	else:
		var forecast := _model.forecast(_model.world)
		_drawing.show_forecast(_model, forecast)
		_formula.show_model(_model, forecast.next_bounce)
	_frames_unshown = 0
	_show_status()


func _show_status() -> void:
	_status.text = AngledLinesTexts.status(_model, _player.meter.milliseconds)
