class_name RotationRoom
extends WorkshopScreen
## The board of exercise 0: a vector that is rotated about the origin or about a point, by the lab
## and, dashed, by the student's own method.

const _EXERCISE := 0

var _vector := Vec2.new()
var _point := Vec2.new()
var _degrees := 90.0
var _watcher: WorkshopWatcher
var _question := -1

@onready var _board: Board = %Board
@onready var _v: DraggableVector = %V
@onready var _handle: Handle = %Point
@onready var _point_name: Arrow = %PointName
@onready var _arc: AngleArc = %Arc
@onready var _right: Arrow = %Right
@onready var _own: Arrow = %Own
@onready var _angle_name: Label = %AngleName
@onready var _angle: NumberField = %Angle
@onready var _is_around: CheckButton = %Around
@onready var _said: Label = %Said
@onready var _verdict: Label = %Verdict


func _ready() -> void:
	super()
	_vector = _v.head_point()
	_point = _handle.at()
	_v.moved.connect(_move_vector)
	_handle.moved.connect(_move_point)
	_v.released.connect(_fit)
	_handle.released.connect(_fit)
	_angle.number_entered.connect(_turn_by)
	_angle.refused.connect(func(sentence: String) -> void: _said.text = sentence)
	_is_around.toggled.connect(_show_all.unbind(1))
	_board.resized.connect(_fit)
	Conventions.changed().connect(_turn_over)
	_watcher = WorkshopLabWatcher.of(get_tree())
	_watcher.judged.connect(_show_all.unbind(1))
	_watcher.began.connect(_show_all)
	_watcher.answered.connect(_take_answer)
	_turn_over()


func _unhandled_input(event: InputEvent) -> void:
	super(event)
	ViewOptions.choose_convention(event)


func _say_again() -> void:
	super()
	_show_all()


func _turn_over() -> void:
	_board.turn_over(Conventions.is_y_up())
	_show_all()
	_fit()


func _move_vector(tail: Vec2, head: Vec2) -> void:
	_vector = head.minus(tail)
	_show_all()


func _move_point(to: Vec2) -> void:
	_point = to
	_show_all()


func _turn_by(angle: float) -> void:
	_degrees = Conventions.typed(angle)
	_show_all()
	_fit()


func _fit() -> void:
	var points: Array[Vec2] = [_vector, _point, _answer()]
	if _own.visible:
		points.append(Vec2.from_vector2(_own.head))
	_board.fit(points)


func _show_all() -> void:
	var center := _center()
	_v.lay(Vec2.new(), _vector)
	_handle.place(_point)
	_point_name.lay(_point, _point)
	_handle.visible = _is_around.button_pressed
	_point_name.visible = _is_around.button_pressed
	_right.lay(Vec2.new(), _answer())
	_arc.measure(center, _vector.minus(center), _answer().minus(center))
	var unit := tr("Angle in radians") if Conventions.uses_radians() else tr("Angle in degrees")
	_angle_name.text = unit
	_angle.accessibility_name = unit
	_angle.show_number(Conventions.shown(_degrees), NumberText.short(Conventions.shown(_degrees)))
	_own.hide()
	_said.text = tr("The lab: %s") % _pair(_answer())
	_show_verdict()
	_ask()


# What it is rotated about.
func _center() -> Vec2:
	return _point if _is_around.button_pressed else Vec2.new()


func _answer() -> Vec2:
	var answer := _vector.copy()
	answer.rotate_around_radians(_center(), Vec2.deg_to_rad(_degrees))
	return answer


func _report_verdict() -> WorkshopVerdict:
	var is_known := _watcher.report and _watcher.report.is_complete
	return _watcher.report.verdict(_EXERCISE) if is_known else null


func _show_verdict() -> void:
	var verdict := _report_verdict()
	_verdict.text = verdict.sentence if verdict else tr("Looking at your code")


func _ask() -> void:
	var angle := Vec2.deg_to_rad(_degrees)
	_question = -1
	if _is_around.button_pressed:
		_ask_method("rotate_around", [_vector.x, _vector.y, _point.x, _point.y, angle])
	else:
		_ask_method("rotate", [_vector.x, _vector.y, angle])


func _ask_method(method: String, numbers: PackedFloat64Array) -> void:
	if _report_verdict() and _watcher.report.can_ask(method):
		_question = _watcher.ask(method, numbers)


func _take_answer(question: int, numbers: PackedFloat64Array) -> void:
	if question != _question:
		return
	if numbers.size() != 2:
		_said.text = tr("The lab: %s   yours: no answer") % _pair(_answer())
		return
	var own := Vec2.new(numbers[0], numbers[1])
	var answer := _answer()
	var is_right := WorkshopProbe.new("", []).agrees(numbers, [answer.x, answer.y])
	_own.visible = own.is_finite()
	_own.lay(Vec2.new(), own)
	# What is dragged stays below the pointer.
	if not Input.is_mouse_button_pressed(MOUSE_BUTTON_LEFT):
		_fit()
	var told := tr("The lab: %s   yours: %s") % [_pair(answer), _pair(own)]
	_said.text = "%s  %s" % [told, "✓" if is_right else "✗"]


static func _pair(vector: Vec2) -> String:
	return NumberText.pair(vector.x, vector.y)
