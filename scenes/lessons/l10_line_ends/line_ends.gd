extends Lesson
## The lesson on line ends: the same shot at five kinds of line, and the touch on a round cap by a
## quadratic. The shot and the line at the start are in the scene of a field.

## One frame lasts this many seconds when it is played.
const _SECONDS_PER_FRAME := 2.0

var _model := LineEndsModel.new()

@onready var _drawing: LineEndsDrawing = %Drawing
@onready var _transport: Transport = services.get(&"transport")


func start() -> void:
	_drawing.put_start(_model)
	on_drag(_drawing.shot_moved, _drawing.shot_released, _model.set_shot)
	on_drag(_drawing.line_moved, _drawing.line_released, _model.set_line)
	_transport.advanced.connect(_advance)
	_fill_panel()
	about_to_show.connect(func() -> void: _drawing.fit(_model))
	begin(_model, _show)
	open_with(_fly)


func _fill_panel() -> void:
	show_in_panel(LineEndsFormula.new(services[&"formula"] as Formula))
	show_in_panel(LineEndsReadout.new(services[&"readout"] as Readout))
	var options := services[&"options"] as LessonOptions
	options.add_presets(LineEndsPresets.SHOTS.keys())
	on_edit(options.preset_picked, _set_up)
	var mistakes := services[&"mistakes"] as Mistakes
	mistakes.add_all(LineEndsMistakeTexts.infos())
	on_edit(mistakes.mistake_picked, _switch_mistake)
	var question := services[&"question"] as Question
	question.offer(CapExercise.fresh, CapExercise.Kind.size())
	on_edit(question.board_wanted, _show_exercise)


# What moves by itself: the ball flies the frame, waits, and flies it again.
func _fly(seconds: float) -> void:
	var wait := 1.0
	var since := fmod(seconds + _SECONDS_PER_FRAME, _SECONDS_PER_FRAME + wait)
	_model.fraction = minf(since / _SECONDS_PER_FRAME, 1.0)


# What the student does.


func _set_up(preset: String) -> void:
	LineEndsPresets.lay(_model, preset)


# A mistake that is not to be seen at this shot brings its own shot.
func _switch_mistake(number: int) -> void:
	_model.mistake = number
	if number != 0 and not LineEndsMistakes.is_seen(number, _model):
		LineEndsPresets.lay(_model, LineEndsMistakeTexts.telling_preset(number))


func _show_exercise(exercise: CapExercise) -> void:
	exercise.lay(_model)


# The frame is played from its start to its end and then stops. Only the drawing changes.
func _advance(seconds: float) -> void:
	_model.fraction = _transport.flown(_model.fraction, seconds / _SECONDS_PER_FRAME, 1.0)
	_drawing.show_model(_model, step)


# What the student sees.


func _show() -> void:
	ask_choice_before(
		LineEndsTexts.Step.CAP,
		LineEndsTexts.question_on_end(),
		LineEndsTexts.choices_on_end(),
		_right_choice_on_end
	)
	ask_choice_before(
		LineEndsTexts.Step.BOUNCE,
		LineEndsTexts.question_on_normal(),
		LineEndsTexts.choices_on_normal(),
		func() -> int: return 0 if _model.bounces_on_the_end() else -1
	)
	tell_steps(LineEndsTexts.sentences(_model))
	_drawing.show_model(_model, step)
	var code := LineEndsCode.new(_model, step)
	tell_code(code.lines, code.inputs)


# Where the ball bounces on the line, or does not come past an end, there is nothing to ask.
func _right_choice_on_end() -> int:
	if _model.bounces_on_the_end():
		return 0
	var result := _model.result_in(LineEndsModel.Field.ROUND_CAPS)
	return 1 if result == LineEndsModel.Result.PASSES_BESIDE else -1
