extends Lesson
## The lesson on objects and values: two names for one Vec2 beside two copies of a Vector2.

const _STEP_COUNT := 4
## Where the two fields have their origins: the Vec2 on the left, the Vector2 on the right.
const _FIELD_OFFSET := 8.0
## So many additions make the sums of the last step.
const _COUNTS: Array[int] = [1000, 1_000_000]

var _model := ClassOrValueModel.new()
var _step := _STEP_COUNT - 2
var _has_sums := false
# The Vec2 before the drag that is going on.
var _before := Vec2.new()
var _rng := RandomNumberGenerator.new()
var _exercise_kind := SharingExercise.Kind.VEC2
var _left := Vec2.new(-_FIELD_OFFSET, 1.0)
var _right := Vec2.new(_FIELD_OFFSET, 1.0)

var _steps: Steps
var _formula: Formula
var _readout: Readout
var _options: LessonOptions
var _question: Question

@onready var _position: DraggableVector = %Position
@onready var _value: DraggableVector = %Value
@onready var _old: Arrow = %Old
@onready var _old_value: Arrow = %OldValue
@onready var _fields: FieldTitles = %Fields


func start() -> void:
	_model.remember()
	_model.move_to(4.0, -4.0)
	_bring_services()
	_define_formula()
	_position.moved.connect(_move.bind(_left))
	_value.moved.connect(_move.bind(_right))
	_position.released.connect(_finish)
	_value.released.connect(_finish)
	_options.add_switch("copies", tr("Use copy()"))
	_options.switched.connect(_switch)
	_options.add_preset("remember", tr("Remember now"))
	_options.preset_picked.connect(_remember)
	_ask()
	_question.exercise_wanted.connect(_ask)
	resized.connect(_show_all)
	_show_all()


func state() -> Dictionary:
	return _model.to_dictionary()


func show_state(stored: Dictionary) -> void:
	_model.from_dictionary(stored)
	_show_all()


func link_problem(linked: Dictionary) -> String:
	return ClassOrValueModel.problem_of(linked)


func _bring_services() -> void:
	_steps = services[&"steps"] as Steps
	_formula = services[&"formula"] as Formula
	_readout = services[&"readout"] as Readout
	_options = services[&"options"] as LessonOptions
	_question = services[&"question"] as Question
	_steps.step_changed.connect(_go_to_step)


func _define_formula() -> void:
	_formula.define_symbol("position", "position", Palette.Role.A)
	_formula.define_symbol("old", "old", Palette.Role.UNIT)
	_formula.define_symbol("value", "value", Palette.Role.B)
	_formula.define_symbol("old_value", "old_value", Palette.Role.UNIT)
	_formula.define_number("x", Palette.Role.A, tr("x of position"))
	_formula.define_number("y", Palette.Role.A, tr("y of position"))
	_formula.define_number("position_pair", Palette.Role.A)
	_formula.define_number("old_pair", Palette.Role.UNIT)
	_formula.define_number("value_pair", Palette.Role.B)
	_formula.define_number("old_value_pair", Palette.Role.UNIT)
	_formula.number_entered.connect(_enter_number)


# What the student does.


# A vector that is dragged by its tail comes along as a whole: its tail stays at the origin.
func _move(tail: Vec2, head: Vec2, origin: Vec2) -> void:
	var moved := head.minus(origin)
	if not tail.equals_approx(origin, 0.0):
		moved = tail.minus(origin).plus(_before)
	_model.move_to(moved.x, moved.y)
	_show_model()


func _enter_number(name_in_line: String, number: float) -> void:
	if name_in_line == "x":
		_model.move_to(number, _model.position.y)
	else:
		_model.move_to(_model.position.x, number)
	_finish()


func _switch(_key: String, on: bool) -> void:
	_model.copies = on
	_model.remember()
	_finish()


func _remember(_key: String) -> void:
	_model.remember()
	_finish()


func _ask() -> void:
	_question.show_exercise(SharingExercise.fresh(_exercise_kind, _rng))
	_exercise_kind = (_exercise_kind + 1) % SharingExercise.Kind.size() as SharingExercise.Kind


func _go_to_step(step: int) -> void:
	_step = step
	_show_all()


func _finish() -> void:
	_show_all()
	edited.emit()


# What the student sees.


func _show_all() -> void:
	_before = _model.position.copy()
	var reach := Vec2.new(absf(_model.position.x), absf(_model.position.y))
	board.fit([_right.plus(reach), _right.minus(reach)])
	_options.show_switch("copies", _model.copies)
	_steps.show_sentences(ClassOrValueTexts.sentences(_model.copies), _step)
	_show_model()


func _show_model() -> void:
	_position.lay(_left, _left.plus(_model.position))
	_value.lay(_right, _right.plus(Vec2.from_vector2(_model.value)))
	_old.lay(_left, _left.plus(_model.old))
	_old_value.lay(_right, _right.plus(Vec2.from_vector2(_model.old_value)))
	_old.visible = _step >= 1
	_old_value.visible = _step >= 1
	_fields.show_fields(_left, _right, ClassOrValueTexts.sharing(_model.is_shared(), _step))
	_formula.show_lines(ClassOrValueTexts.lines(_model.copies, _step))
	_formula.set_number("x", _model.position.x)
	_formula.set_number("y", _model.position.y)
	_formula.set_vector("position_pair", _model.position)
	_formula.set_vector("old_pair", _model.old)
	_formula.set_vector("value_pair", Vec2.from_vector2(_model.value))
	_formula.set_vector("old_value_pair", Vec2.from_vector2(_model.old_value))
	_readout.visible = _step >= _STEP_COUNT - 1
	if _readout.visible and not _has_sums:
		_show_sums()


# Two million additions take a moment: they wait until the step that shows them.
func _show_sums() -> void:
	_has_sums = true
	for count in _COUNTS:
		_show_sum("64 %d" % count, tr("Vec2, %s times"), count, TenthSum.with_64_bits)
		_show_sum("32 %d" % count, tr("Vector2, %s times"), count, TenthSum.with_32_bits)


func _show_sum(key: String, title: String, count: int, sum: Callable) -> void:
	var start_usec := Time.get_ticks_usec()
	var value: float = sum.call(count)
	var nanoseconds := (Time.get_ticks_usec() - start_usec) * 1000.0 / count
	var error := value - TenthSum.exact(count)
	_readout.show_result(key, title % NumberText.short(count), value, error, nanoseconds)
