extends Lesson
## The lesson on objects and values: two names for one Vec2 beside two copies of a Vector2.
##
## The arrows Position and Value of the scene begin at the origins of the two fields. The head of
## Position is the first place of both.

## The opening moves both this far sideways, in units.
const _SWAY := 1.5
## How many times 0.1 is added for each row of the readout.
const _COUNTS: Array[int] = [1000, 1_000_000]
## So many digits show that the sums differ.
const _DIGITS_OF_SUM := 8

## Where the change moves both at the start, in units.
@export var changed_place := Vector2(4.0, -4.0)

var _model := ClassOrValueModel.new()
# The Vec2 before the drag that is going on; null between drags.
var _before: Vec2
var _has_sums := false

@onready var _readout: Readout = services.get(&"readout")
@onready var _position: DraggableVector = %Position
@onready var _value: DraggableVector = %Value
@onready var _old: Arrow = %Old
@onready var _old_value: Arrow = %OldValue
@onready var _fields: FieldTitles = %Fields
@onready var _left := _position.tail_point()
@onready var _right := _value.tail_point()
# How far they are apart in the scene.
@onready var _apart := _right.x - _left.x


func start() -> void:
	var first := _position.head_point().minus(_left)
	_model.remember_and_move(first, Vec2.from_vector2(changed_place))
	_let_drag(_position)
	_let_drag(_value)
	show_in_panel(ClassOrValueFormula.new(services[&"formula"] as Formula))
	on_enter(_enter)
	add_switch("copies", tr("Use copy()"))
	var options := services[&"options"] as LessonOptions
	options.add_preset("remember", tr("Start again from here"))
	_readout.is_the_point = true
	_readout.show_headings([tr("0.1 added up"), tr("sum"), tr("error"), tr("per addition")])
	on_edit(options.preset_picked, _model.remember.unbind(1))
	offer_questions(SharingExercise)
	begin(_model, _show, _reach)
	open_with_swing(_sway.bind(_model.first_place(), _model.position.copy()))


func _let_drag(vector: DraggableVector) -> void:
	on_drag(vector.moved, vector.released, _move.bind(vector))
	vector.released.connect(func() -> void: _before = null)


# What moves by itself: Vec2 and Vector2, in step. Eighths are the same in 32 bits and in 64.
func _sway(share: float, first: Vec2, second: Vec2) -> void:
	var x := snappedf(_SWAY * share, 0.125)
	var by := Vec2.new(x, 0.0)
	_model.remember_and_move(first.plus(by), second.plus(by))


# What the student does.


# A vector that is dragged by its tail or as a whole moves its head: the tail stays at the origin.
func _move(tail: Vec2, head: Vec2, vector: DraggableVector) -> void:
	var origin := _left if vector == _position else _right
	if not _before:
		_before = _shown_place()
	var moved := head.minus(origin)
	if not tail.equals_approx(origin, 0.0):
		moved = _before.plus(tail.minus(origin))
	if _is_changed():
		_model.move_to(moved.x, moved.y)
	else:
		_model.remember_and_move(moved, moved)


func _enter(name_in_line: String, number: float) -> String:
	if _is_changed():
		return _model.enter(name_in_line, number)
	var first := _model.first_place()
	_model.move_to(first.x, first.y)
	var problem := _model.enter(name_in_line, number)
	if not problem:
		_model.remember()
	return problem


# Before that step both names are still where they began.
func _is_changed() -> bool:
	return step >= ClassOrValueTexts.Step.CHANGE


func _shown_place() -> Vec2:
	return _model.position.copy() if _is_changed() else _model.first_place()


# What the student sees.


# As much of the plane on both sides of each origin as position needs on one. Where that is much,
# the origins are farther apart, by round numbers: no arrow reaches into the other field.
func _reach() -> Array[Vec2]:
	var first := _model.first_place()
	var reach := Vec2.new(
		maxf(absf(_model.position.x), absf(first.x)), maxf(absf(_model.position.y), absf(first.y))
	)
	var unit := 10.0 ** floorf(log(maxf(reach.x, 1.0)) / log(10.0))
	_right.x = maxf(_apart / 2.0, 2.0 * unit * ceilf((reach.x / unit + 1.0) / 2.0))
	_left.x = -_right.x
	return [_right.plus(reach), _right.minus(reach)]


func _show() -> void:
	ask_choice_before(
		ClassOrValueTexts.Step.CHANGE,
		ClassOrValueTexts.question(),
		ClassOrValueTexts.choices(),
		func() -> int: return 1 if _model.copies else 0
	)
	tell_steps(ClassOrValueTexts.sentences(_model.copies))
	# Copies are the cure: they come with the harm.
	services[&"options"].visible = _is_changed()
	_show_arrows()
	_fields.show_fields(_left, _right, ClassOrValueTexts.sharing(_model.is_shared(), step))
	ClassOrValueTexts.fill(%Boxes as NameBoxes, _model, step)
	_show_sums()


func _show_arrows() -> void:
	var place := _shown_place()
	var old := _model.old if _is_changed() else place
	_position.lay(_left, _left.plus(place))
	_value.lay(_right, _right.plus(Vec2.from_vector2(place.to_vector2())))
	_old.lay(_left, _left.plus(old))
	_old_value.lay(_right, _right.plus(Vec2.from_vector2(_model.old_value)))
	_old.visible = step >= ClassOrValueTexts.Step.SECOND_NAME
	_old_value.visible = _old.visible


# Two million additions take a moment: they wait until the step that shows them.
func _show_sums() -> void:
	_readout.visible = step >= ClassOrValueTexts.Step.SUMS
	if _has_sums or not _readout.visible:
		return
	_has_sums = true
	for count in _COUNTS:
		_show_sum("64 %d" % count, tr("Vec2, %s times"), count, TenthSum.with_64_bits)
		_show_sum("32 %d" % count, tr("Vector2, %s times"), count, TenthSum.with_32_bits)


func _show_sum(key: String, title: String, count: int, sum: Callable) -> void:
	var start_usec := Time.get_ticks_usec()
	var value: float = sum.call(count)
	var nanoseconds := (Time.get_ticks_usec() - start_usec) * 1000.0 / count
	var error := value - TenthSum.exact(count)
	var texts: PackedStringArray = [
		title % NumberText.short(count),
		NumberText.short(value, _DIGITS_OF_SUM),
		NumberText.size(error),
		_readout.time_text(nanoseconds)
	]
	_readout.show_texts(key, texts)
