extends Lesson
## The lesson on more dimensions: the same dot product with three, four and five components. The
## components at the start are those of the bars in the scene, the view is that of the picture.

## The opening turns the axes so fast, in radians a second.
const _TURN_SPEED := TAU / OpeningMotion.LONGEST

var _model := MoreDimensionsModel.new()
# The vector as it was when the drag of its head began; empty while there is none.
var _held: PackedFloat64Array = []

@onready var _readout: Readout = services.get(&"readout")
@onready var _picture: SpacePicture = %Picture
@onready var _bars: ComponentBars = %Bars
@onready var _stairs: ProductStairs = %Stairs
@onready var _card: Control = %VerdictCard
@onready var _verdict: Label = %Verdict
@onready var _hint: Label = %Hint
@onready var _uses: UsesTable = %Uses
@onready var _layout := MoreDimensionsLayout.new(board)


func start() -> void:
	_model.a = _bars.a.duplicate()
	_model.b = _bars.b.duplicate()
	_model.view.yaw = _picture.yaw
	_model.view.pitch = _picture.pitch
	on_drag(_picture.head_moved, _picture.head_released, _move_head)
	on_drag(_bars.component_moved, _bars.component_released, _model.set_component)
	_picture.head_released.connect(func() -> void: _held = [])
	# While the view turns, no number changes.
	_picture.turned.connect(_turn)
	show_in_panel(MoreDimensionsFormula.new(services[&"formula"] as Formula))
	add_switch("has_four", tr("Four components"))
	add_switch("has_five", tr("Five components"))
	offer_presets(MoreDimensionsModel.PRESETS)
	offer_questions(ComponentExercise)
	on_pick(_pick)
	about_to_show.connect(_fit)
	begin(_model, _show)
	# In the panel the last one comes first.
	for card: Control in [_hint, _stairs, _card, _uses]:
		var place := CardPlace.new(card, board, services[&"steps"])
		place.changed.connect(show_all)
		add_child(place)
	open_with(_turn_slowly.bind(_model.view.yaw))


# What moves by itself: the axes turn once.
func _turn_slowly(seconds: float, first: float) -> void:
	_model.view.yaw = first + _TURN_SPEED * seconds


# What the student does.


# Of the two switches one is on at most.
func _pick(changes: Dictionary) -> String:
	for names: PackedStringArray in [["has_four", "has_five"], ["has_five", "has_four"]]:
		if changes.get(names[0], false) and not changes.has(names[1]):
			return _model.take(changes.merged({names[1]: false}))
	return _model.take(changes)


# A head in space keeps to whole numbers: the eye cannot tell depth between them. Its way counts
# from where the drag began: from step to step, rounding would swallow small steps.
func _move_head(letter: String, point: Vec2) -> String:
	if _held.is_empty():
		_held = (_model.a if letter == "a" else _model.b).duplicate()
	var way := point.minus(_model.view.seen_at(_held[0], _held[1], _held[2]))
	var in_space := _model.view.step_in_space(way)
	var problems: PackedStringArray = []
	for i in 3:
		problems.append(_model.set_component(letter, i, roundf(_held[i] + in_space[i])))
	return StateCheck.first(problems)


func _turn(yaw: float, pitch: float) -> void:
	_model.view.turn(yaw, pitch)
	_picture.show_model(_model, step)


# What the student sees.


func _fit() -> void:
	_layout.arrange(_model.is_beyond_space())
	_model.view.is_y_up = Conventions.is_y_up()
	_picture.fit_model(_model)
	_bars.fit_model(_model)


func _show() -> void:
	ask_choice_before(
		MoreDimensionsTexts.Step.SIGN,
		MoreDimensionsTexts.question(),
		MoreDimensionsTexts.choices(),
		MoreDimensionsTexts.right_choice.bind(_model)
	)
	tell_steps(MoreDimensionsTexts.sentences(_model))
	_picture.show_model(_model, step)
	_bars.show_model(_model)
	_show_parts()
	_stairs.products = _model.products()
	_stairs.shows_sum = step >= MoreDimensionsTexts.Step.SUM
	_verdict.text = Conventions.in_unit(MoreDimensionsTexts.verdict(_model))
	_hint.text = MoreDimensionsTexts.hint(_model)
	_show_calls()
	var code := MoreDimensionsCode.new(_model, step)
	tell_code(code.lines, code.inputs)


# The table takes the place of everything else.
func _show_parts() -> void:
	_uses.show_uses()
	_uses.visible = step == MoreDimensionsTexts.Step.USES
	# On a small board it is in the panel.
	var is_covered := _uses.visible and _uses.get_parent() == board
	_picture.visible = not (is_covered or _model.is_beyond_space())
	_bars.visible = not is_covered
	_hint.visible = not is_covered
	_stairs.visible = step >= MoreDimensionsTexts.Step.PRODUCTS and not is_covered
	_card.visible = step >= MoreDimensionsTexts.Step.SIGN and not is_covered


func _show_calls() -> void:
	_readout.visible = step == MoreDimensionsTexts.Step.ANGLE and _model.has_angle()
	if not _readout.visible:
		return
	var one := _model.counted_a()
	var other := _model.counted_b()
	var exact_dot := ComponentLists.exact_dot(one, other)
	_show_call("dot", "a · b", ComponentLists.dot.bind(one, other), exact_dot)
	_show_call("cosine", "cos α", _model.cosine, _model.exact_cosine())


func _show_call(key: String, title: String, method: Callable, exact: DoubleDouble) -> void:
	var value: float = method.call()
	var nanoseconds := CallTimer.nanoseconds(method)
	_readout.show_result(key, title, value, exact.error_of(value), nanoseconds)
