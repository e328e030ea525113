extends Lesson
## The lesson on more dimensions: the same dot product with three and four components. The
## components at the start are those of the bars in the scene, the view is that of the picture.

## The opening turns the axes so fast, in radians a second.
const _TURN_SPEED := TAU / OpeningMotion.LONGEST
# Pixels between the card and the bars below it.
const _GAP := 8.0

var _model := MoreDimensionsModel.new()
var _formula: MoreDimensionsFormula
# The vector as it was when the drag of its head began; empty while there is none.
var _held: PackedFloat64Array = []

@onready var _readout: Readout = services.get(&"readout")
@onready var _picture: SpacePicture = %Picture
@onready var _bars: ComponentBars = %Bars
@onready var _place_of_bars: Control = %PlaceOfBars
@onready var _stairs: ProductStairs = %Stairs
@onready var _card: Control = %VerdictCard
@onready var _verdict: Label = %Verdict
@onready var _hint: Label = %Hint


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
	_formula = MoreDimensionsFormula.new(services[&"formula"] as Formula)
	var options := services[&"options"] as LessonOptions
	options.add_switch("has_four", tr("Four components"))
	options.offer_presets(MoreDimensionsModel.PRESETS)
	var kinds := ComponentExercise.Kind.size()
	(services[&"question"] as Question).offer(ComponentExercise.fresh, kinds)
	on_enter(_model.enter)
	on_pick(_model.take)
	about_to_show.connect(_fit)
	begin(_model, _show)
	open_with(_turn_slowly.bind(_model.view.yaw))


# What moves by itself: the axes turn once.
func _turn_slowly(seconds: float, first: float) -> void:
	_model.view.yaw = first + _TURN_SPEED * seconds


# What the student does.


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
	_arrange()
	_picture.fit_model(_model)
	_bars.fit_model(_model)


# Three axes fit into a picture; with four, the bars take its place, below the card.
func _arrange() -> void:
	_picture.visible = not _model.has_four
	var place: Control = _picture if _model.has_four else _place_of_bars
	for side: Side in [SIDE_LEFT, SIDE_TOP, SIDE_RIGHT, SIDE_BOTTOM]:
		_bars.set_anchor_and_offset(side, place.get_anchor(side), place.get_offset(side))
	if _model.has_four:
		_bars.offset_top += _card.get_combined_minimum_size().y + _GAP


func _show() -> void:
	ask_choice_before(
		MoreDimensionsTexts.Step.SIGN,
		MoreDimensionsTexts.question(),
		MoreDimensionsTexts.choices(),
		MoreDimensionsTexts.right_choice.bind(_model)
	)
	tell_steps(MoreDimensionsTexts.sentences(_model))
	_formula.show_model(_model, step)
	_picture.show_model(_model, step)
	_bars.show_model(_model)
	_stairs.visible = step >= MoreDimensionsTexts.Step.PRODUCTS
	_stairs.products = _model.products()
	_stairs.shows_sum = step >= MoreDimensionsTexts.Step.SUM
	_card.visible = step >= MoreDimensionsTexts.Step.SIGN
	_verdict.text = MoreDimensionsTexts.verdict(_model)
	_hint.text = MoreDimensionsTexts.hint(_model)
	_show_calls()


func _show_calls() -> void:
	_readout.visible = step >= MoreDimensionsTexts.Step.ANGLE and _model.has_angle()
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
