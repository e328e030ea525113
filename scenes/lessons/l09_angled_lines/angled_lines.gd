extends Lesson
## The lesson on angled lines, the assignment of the course: balls bounce among lines that can be
## drawn, moved and deleted, under gravity in any direction. Lines, balls and gravity at the start
## are in the scene.

## Keys of this lesson, for the help line.
const ACTIONS := AngledLinesKeys.ACTIONS

## The bounciness C at the start: the share of the speed along the normal that a bounce keeps.
@export_range(0.0, 1.0, 0.01) var bounciness := 1.0

var _model: AngledLinesModel
var _formula: AngledLinesFormula
var _readout: AngledLinesReadout
var _options: AngledLinesOptions

@onready var _drawing: AngledLinesDrawing = %Drawing
@onready var _player: AngledLinesPlayer = %Player
@onready var _engine: EngineLane = %Engine
@onready var _timeline: TimelineCard = %TimelineCard


func start() -> void:
	_model = AngledLinesModel.new(_drawing.world_at_start(bounciness))
	_connect_board(%Lines as LineViews, %Gravity as GravityArrow, %Pointer as BoardPointer)
	_connect_keys(%Keys as AngledLinesKeys)
	_fill_panel(services[&"options"] as LessonOptions, services[&"question"] as Question)
	_connect_player()
	about_to_show.connect(_settle)
	begin(_model, _show, func() -> Array[Vec2]: return _drawing.outline(_model))
	_ask_questions()
	open_with(_player.fly_to)


func _connect_board(lines: LineViews, gravity: GravityArrow, pointer: BoardPointer) -> void:
	on_drag(lines.changed, lines.released, _model.set_lines)
	on_drag(gravity.turned, gravity.released, _model.set_gravity)
	on_drag(_drawing.ball_changed, _drawing.ball_released, _model.change_ball)
	on_drag(pointer.ball_moved, pointer.ball_released, _model.move_ball)
	pointer.follow(_model)
	pointer.ball_taken.connect(_select)
	pointer.line_drawn.connect(lines.add_line)
	_timeline.moved.connect(_follow_jump)


func _connect_keys(keys: AngledLinesKeys) -> void:
	on_edit(keys.gravity_pointed, _model.point_gravity)
	on_edit(keys.bounciness_wanted, _model.take_next_bounciness)
	on_edit(keys.preset_picked, _model.set_up)
	on_edit(keys.fetch_wanted, _model.fetch_balls)
	keys.impact_wanted.connect(_timeline.go_to_impact)
	(%Fetch as Button).pressed.connect(keys.act.bind(&"lab_fetch_balls"))
	keys.line_deleted.connect((%Lines as LineViews).delete_focused)
	keys.trails_switched.connect(func() -> void: _show_trails(not _drawing.has_trails))
	keys.trails_cleared.connect(func() -> void: _drawing.begin_trails(_model))


func _connect_player() -> void:
	_player.play(_model, services[&"transport"] as Transport)
	_player.changed.connect(_show_moment)
	_player.refused.connect(noticed.emit)
	_player.measured.connect(_show_status)
	_player.rested.connect(_readout.advance)
	_drawing.follow(_player, _model)


func _ask_questions() -> void:
	ask_before(1, AngledLinesTexts.touch_prompt(), _model.next_touch, _first_guess)
	var right := AngledLinesTexts.right_way.bind(_model)
	ask_choice_before(2, AngledLinesTexts.energy_prompt(), AngledLinesTexts.ways(), right)


func _fill_panel(options: LessonOptions, question: Question) -> void:
	_options = AngledLinesOptions.new(options)
	on_edit(options.chosen, AngledLinesOptions.choose.bind(_model))
	options.switched.connect(_switch)
	_formula = AngledLinesFormula.new(services[&"formula"] as Formula)
	on_enter(_enter_number)
	_readout = AngledLinesReadout.new(services[&"readout"] as Readout)
	var mistakes := services[&"mistakes"] as Mistakes
	mistakes.add_all(AngledLinesMistakes.all())
	on_edit(mistakes.mistake_picked, _model.set_mistake)
	question.offer(SteppingExercise.fresh, SteppingExercise.Kind.size())
	on_edit(question.board_wanted, func(of: SteppingExercise) -> void: _model.put_up(of.world))


# What the student does.


# In the middle of the board. The ball stands still while its way is guessed.
func _first_guess() -> Vec2:
	pause()
	return Vec2.new()


func _select(index: int) -> void:
	pause()
	_model.selected = index
	_engine.begin_anew(_model)
	_show_moment()


func _follow_jump(problem: String) -> void:
	pause()
	noticed.emit(problem)
	_drawing.begin_trails(_model)
	_show_moment()
	motion_ended.emit()


func _switch(key: String, on: bool) -> void:
	if key == "trails":
		_show_trails(on)
	else:
		noticed.emit(_engine.switch(on, _model))
		_show_trails(_drawing.has_trails)


func _enter_number(name_in_line: String, value: float) -> String:
	pause()
	return AngledLinesFormula.enter(_model, name_in_line, value)


# What the student sees.


# After a complete change the arrow of the velocity is scaled, and the comparison begins anew.
func _settle() -> void:
	_drawing.scale_arrow(_model)
	_readout.begin(_model.world)


func _show() -> void:
	_options.show_model(_model, _drawing.has_trails, _engine.is_on())
	services[&"readout"].visible = step >= 2 and not _model.has_endless_lines
	_engine.begin_anew(_model)
	_drawing.show_model(_model)
	_show_moment()


func _show_trails(on: bool) -> void:
	_drawing.has_trails = on
	_options.show_model(_model, on, _engine.is_on())


# What changes from frame to frame. What is to come is worked out only while time stands still.
func _show_moment() -> void:
	var forecast: BallForecast
	if step >= 1 and not _player.is_playing():
		forecast = _model.forecast(_model.world)
	_drawing.show_moment(_model, forecast)
	_timeline.show_model(_model)
	_engine.show_moment(_model)
	tell_steps(AngledLinesTexts.steps(_model, forecast))
	var bounce := forecast.next_bounce if forecast else _model.last_bounce
	if _formula.show_moment(_model, bounce if step == 1 else null, _player.is_playing()):
		_show_status()
		var code := AngledLinesCode.new(_model, bounce if step == 1 else null)
		tell_code(code.lines, code.inputs)


func _show_status() -> void:
	(%Status as Label).text = AngledLinesTexts.status(_model, _player.meter.milliseconds)
	(%Fetch as Button).visible = _model.world.lost_count() > 0
