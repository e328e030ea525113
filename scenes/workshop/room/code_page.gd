class_name CodePage
extends WorkshopScreen
## Where the student writes his methods in the lab itself, as in a browser: a text for each
## exercise, and beside it what the judge says of it. All that is typed is kept at once.

# The same in every language.
const _CHECK_KEYS := "Ctrl+Enter"
# A screen that is less wide has what is said below what is written.
const _WIDE := 760.0
# What is said takes this part of a tall screen.
const _SHARE := 0.34
# What these say is about one line; of any other verdict the line is that of the method.
const _MEANING_A_LINE: Array[WorkshopVerdict.Kind] = [
	WorkshopVerdict.Kind.UNREADABLE,
	WorkshopVerdict.Kind.BROKEN,
	WorkshopVerdict.Kind.ENDLESS,
	WorkshopVerdict.Kind.MEMORY,
	WorkshopVerdict.Kind.REFUSED,
]
# How much of its color has what was said of an earlier text.
const _FAINT := 0.45
const _NOT_TOLD: PackedStringArray = ["_init", "_to_string"]

var _exercises: Array[WorkshopExercise] = []
var _exercise: WorkshopExercise
var _watcher: WorkshopPageWatcher

@onready var _choice: OptionButton = %Choice
@onready var _body: BoxContainer = %Body
@onready var _field: CodeField = %Field
@onready var _undo: Button = %Undo
@onready var _redo: Button = %Redo
@onready var _stub: Button = %Stub
@onready var _indents: Array[Button] = [%Indent, %Unindent]
@onready var _said: Control = %Said
@onready var _changed: Control = %Changed
@onready var _ball: Control = %Ball
@onready var _sign: Label = %Sign
@onready var _heading: Label = %Heading
@onready var _place: Label = %Place
@onready var _sentence: Label = %Sentence
@onready var _probe: Control = %Probe
@onready var _called: Label = %Called
@onready var _got: Label = %Got
@onready var _wanted: Label = %Wanted
@onready var _printed: Label = %Printed
@onready var _told: Array[Control] = [%Verdict, _sentence, _probe, _printed]
@onready var _names: Label = %Names
@onready var _done: Label = %Done


func _ready() -> void:
	super()
	_exercises = WorkshopKeptCode.exercises()
	_watcher = _page_watcher()
	_watcher.judged.connect(_show_report)
	(%Check as Button).pressed.connect(_check)
	(%Check as Button).tooltip_text = _CHECK_KEYS
	(%Previous as Button).pressed.connect(_go.bind(-1))
	(%Next as Button).pressed.connect(_go.bind(1))
	_choice.item_selected.connect(func(at: int) -> void: _open(_exercises[at]))
	_field.check_wanted.connect(_check)
	_field.text_changed.connect(_keep)
	_undo.pressed.connect(_field.undo)
	_redo.pressed.connect(_field.redo)
	_stub.pressed.connect(_go_back_to_stub)
	_indents[0].pressed.connect(_field.indent_lines)
	_indents[1].pressed.connect(_field.unindent_lines)
	resized.connect(_lay)
	_lay()
	for button in _indents:
		button.visible = DisplayServer.is_touchscreen_available()
	_open(WorkshopKeptCode.chosen())
	if _watcher.report:
		_watcher.say_again()
		_show_report(_watcher.report)
	WebPage.show_title(tr("Your own code"))


# Where the lab's watcher looks at files, as when this scene is run by F6, the page has its own.
func _page_watcher() -> WorkshopPageWatcher:
	var of_lab := WorkshopLabWatcher.of(get_tree()) as WorkshopPageWatcher
	if of_lab:
		return of_lab
	var own := WorkshopPageWatcher.new()
	add_child(own)
	return own


func _say_again() -> void:
	super()
	_exercises = WorkshopKeptCode.exercises()
	_open(WorkshopIndex.exercise(_exercise.number))
	_watcher.say_again()
	_show_report(_watcher.report)


func _lay() -> void:
	_body.vertical = size.x < _WIDE
	_said.custom_minimum_size = Vector2(0.0, size.y * _SHARE) if _body.vertical else Vector2.ZERO
	_said.size_flags_vertical = SIZE_FILL if _body.vertical else SIZE_EXPAND_FILL


func _open(exercise: WorkshopExercise) -> void:
	_exercise = exercise
	WorkshopKeptCode.choose(exercise)
	_field.begin(WorkshopKeptCode.text_of(exercise))
	_field.accessibility_name = tr("Your code for %s") % exercise.title
	_names.text = tr("MyVec2 has %s.") % ", ".join(_names_of_vector())
	_show_steps()
	if _watcher.report:
		_show_report(_watcher.report)


func _go(by: int) -> void:
	var at := wrapi(_exercises.find(_exercise) + by, 0, _exercises.size())
	_open(_exercises[at])


func _keep() -> void:
	WorkshopKeptCode.keep(_exercise, _field.text)
	_changed.show()
	for part in _told:
		part.modulate.a = _FAINT
	_show_steps()


func _check() -> void:
	_watcher.check_now()


func _go_back_to_stub() -> void:
	_field.replace_all(WorkshopKeptCode.stub_of(_exercise))
	_keep()
	_check()


func _show_steps() -> void:
	_undo.disabled = not _field.has_undo()
	_redo.disabled = not _field.has_redo()
	_stub.disabled = not WorkshopKeptCode.is_written(_exercise)


func _show_report(report: WorkshopReport) -> void:
	var right := 0
	_choice.clear()
	for exercise in _exercises:
		var is_right := report.is_right(exercise.number)
		right += int(is_right)
		var title := OwnCodeTexts.heading(exercise)
		_choice.add_item(("✓ " if is_right else "") + title)
	_choice.select(_exercises.find(_exercise))
	_done.text = tr("%d of %d right") % [right, _exercises.size()]
	_show_verdict(report.verdict(_exercise.number))


func _show_verdict(verdict: WorkshopVerdict) -> void:
	_changed.hide()
	for part in _told:
		part.modulate.a = 1.0
	_sign.text = OwnCodeTexts.sign_of(verdict)
	_ball.self_modulate = Palette.color(OwnCodeTexts.role_of(verdict))
	_heading.text = OwnCodeTexts.heading(_exercise)
	_sentence.text = verdict.sentence
	# There is no file here.
	if verdict.kind == WorkshopVerdict.Kind.OPEN:
		_sentence.text = tr("Write %s.") % verdict.method
	var line := verdict.line if verdict.kind in _MEANING_A_LINE else 0
	_field.mark(line)
	var parts: PackedStringArray = []
	if line > 0:
		parts.append(tr("line %d") % line)
	if verdict.mistake > 0:
		parts.append(tr("mistake %d") % verdict.mistake)
	_place.text = ", ".join(parts)
	_place.visible = _place.text != ""
	_show_probe(_exercise.task(verdict.method), verdict)
	_show_printed()


func _show_probe(task: WorkshopTask, verdict: WorkshopVerdict) -> void:
	_probe.visible = task != null and verdict.probe != "" and not verdict.wanted.is_empty()
	if _probe.visible:
		_called.text = "%s: %s" % [verdict.method, verdict.probe]
		_got.text = OwnCodeTexts.answer(task, verdict.got)
		_wanted.text = OwnCodeTexts.answer(task, verdict.wanted)


func _show_printed() -> void:
	var lines := WorkshopGuard.printed
	_printed.visible = not lines.is_empty()
	var told := tr("Printed: %s") % "\n".join(lines)
	if WorkshopGuard.print_count > lines.size():
		told += "\n" + tr("… and %d lines more.") % (WorkshopGuard.print_count - lines.size())
	_printed.text = told


# What the student may call, whatever he has written so far.
func _names_of_vector() -> PackedStringArray:
	var code := WorkshopCode.new(WorkshopFiles.starter("my_vec2.gd").to_utf8_buffer())
	var names: PackedStringArray = ["x", "y"]
	for function in code.functions():
		if not function in _NOT_TOLD and not _exercise.task(function):
			names.append(function)
	return names
