@abstract class_name Lesson
extends Control
## A lesson: a controller between a model, the board that shows it, and the services in the panel.
##
## The lesson frame brings the services that the lesson's [LessonInfo] needs and then calls
## [method start]. There the lesson says what its state is ([method begin]) and how the student
## changes it: [method on_edit], [method on_drag], [method on_move]. A change that cannot be made
## changes nothing and returns a sentence, which is shown.

## The student has made a change that is complete: a drag has ended, a number was entered. The
## lesson frame keeps [method state] for undo.
signal edited
## What moved by itself has stopped, or the student is about to change something. The frame keeps
## [method state] for undo, too.
signal motion_ended
## The model is about to be shown afresh, on the board and in the panel: the time to fit a view and
## to measure.
signal about_to_show
## Another step is shown.
signal step_changed
## A sentence for the notice line: what was refused and why. "" clears the line.
signal noticed(message: String)

## y points down here, whatever is chosen for the whole lab: gravity and floors need a below.
@export var keeps_y_down := false

## The services that the lesson frame has brought, by the names in [member LessonInfo.needs].
var services: Dictionary[StringName, Control] = {}

## The step that is shown, counted from 0; 0 in a lesson without steps.
var step: int:
	get:
		return services[&"steps"].get(&"step") if services.has(&"steps") else 0

## How many steps there are; 1 in a lesson without steps.
var step_count: int:
	get:
		return services[&"steps"].get(&"count") if services.has(&"steps") else 1

## The steps, counted from 0, before which the student was asked.
var asked_before: PackedInt32Array:
	get:
		return services[&"steps"].get(&"asked_before") if services.has(&"steps") else []
	set(value):
		if services.has(&"steps"):
			services[&"steps"].set(&"asked_before", value)

var _kept_model: LessonModel
var _show_model: Callable
var _points_to_show: Callable
# What shows the model in the panel, after the lesson itself has shown it.
var _views: Array[Object] = []
# The services of which the model takes what is picked, unless on_pick() says otherwise.
var _offering: Array[Control] = []
var _has_own_pick := false
var _has_own_enter := false
# Returns the step at which a mistake is seen; see offer_mistakes().
var _step_of_mistake: Callable
# Null once the student has made a change or has let time run.
var _opening: OpeningMotion

## The board on which the lesson draws.
@onready var board: Board = %Board

## Called once, after the services are there and before the lesson is seen.
@abstract func start() -> void


# Run alone, as by F6 in the editor, the scene has no lesson frame: the main scene opens it in one.
func _enter_tree() -> void:
	if get_tree().current_scene == self:
		process_mode = PROCESS_MODE_DISABLED
		LessonRequest.ask(scene_file_path.get_file().get_basename())
		var main_scene: String = ProjectSettings.get_setting("application/run/main_scene")
		get_tree().change_scene_to_file.call_deferred(main_scene)


## Shows [param model] from now on, by [param show_model]. Undo, reset and links keep its state. The
## board is fitted to the points that [param points] returns, except during a drag. Where neither
## [method on_enter] nor [method on_pick] has said otherwise, the model takes what is typed in the
## formula and what is picked of what the lesson offers. An error if the lesson cannot show the
## model as it is now: then a value in the scene is wrong.
func begin(model: LessonModel, show_model: Callable, points: Callable = Callable()) -> void:
	var problem := _not_finite(model.link_state())
	if not problem:
		problem = model.problem_in(model.link_state())
	if problem:
		push_error(problem)
		return
	_kept_model = model
	_show_model = show_model
	_points_to_show = points
	_let_model_take()
	resized.connect(show_all)
	for service: Control in services.values():
		if service.has_signal(&"view_changed"):
			service.connect(&"view_changed", show_all)
		if service.has_signal(&"step_changed"):
			service.connect(&"step_changed", step_changed.emit.unbind(1))
		if service.has_signal(&"halted"):
			service.connect(&"halted", motion_ended.emit)
	show_all()


## From the first frame until the student does anything, [param move] is called in each frame with
## the seconds since then. It changes the model, from where it starts at 0 seconds, and gives no
## answer away; after [constant OpeningMotion.LONGEST], or when the student steps forward before any
## change, the lesson is at its start again. Comes after [method begin]. Where motion is reduced,
## nothing moves.
func open_with(move: Callable) -> void:
	if not OpeningMotion.is_allowed or Motion.is_reduced():
		return
	var show_moved := func(seconds: float) -> void:
		move.call(seconds)
		_show_everywhere()
	var first := state()
	_opening = OpeningMotion.new(show_moved, show_state.bind(first))
	add_child(_opening)
	if services.has(&"transport"):
		Signal(services[&"transport"], &"advanced").connect(stop_opening.unbind(1))
	if services.has(&"steps"):
		Signal(services[&"steps"], &"going_forward").connect(_go_back_to.bind(first))


## The same for what swings so many [param times] until [constant OpeningMotion.LONGEST]:
## [param move] is called with where the swing is, from 0 to 1, to -1 and to 0 again.
func open_with_swing(move: Callable, times: float = 4.0) -> void:
	open_with(func(seconds: float) -> void: move.call(OpeningMotion.swing(seconds, times)))


## Ends what [method open_with] moves, and leaves it where it is: the student has chosen this.
func stop_opening() -> void:
	if _opening:
		_opening.stop()
		_opening = null


## Whether nothing was done yet in a lesson that moves by itself at first.
func is_opening() -> bool:
	return _opening != null


## Shows a step, counted from 0, as a link names it. What is asked before it is asked when the
## student comes to it step by step.
func show_step(at: int) -> void:
	stop_opening()
	if services.has(&"steps"):
		services[&"steps"].call(&"go_to", at)


## Only for a lesson with steps. When the student goes forward to the step [param before], counted
## from 0, for the first time, [param prompt], translated, is asked instead, and the [Guess] of the
## scene, its unique name `%Guess`, appears where [param first] returns a [Vec2]. The next time
## forward shows the step, and how far the guess is from where [param truth] returns the true point.
## Where that returns null there is nothing to ask, and the step is shown at once.
func ask_before(before: int, prompt: String, truth: Callable, first: Callable) -> void:
	var guess := get_node(^"%Guess")
	var ask := Callable(guess, &"ask").bind(truth, first)
	var judge := Callable(guess, &"judge").bind(truth)
	services[&"steps"].call(&"ask_before", before, prompt, ask, judge, Callable(guess, &"hide"))


## The same with a button for each of the translated [param choices], each of which can follow
## `No,`. [param right] returns the place of the right one, below 0 where there is nothing to ask.
func ask_choice_before(
	before: int, prompt: String, choices: PackedStringArray, right: Callable
) -> void:
	services[&"steps"].call(&"ask_choice_before", before, prompt, choices, right)


## Whether the student is asked something just now: what answers it has to wait.
func is_asking() -> bool:
	return services.has(&"steps") and services[&"steps"].call(&"is_asking")


## Asks everything once more that was asked before a step.
func ask_again() -> void:
	if services.has(&"steps"):
		services[&"steps"].call(&"ask_again")


## When [param trigger] is emitted, [param change] changes the model; the change is complete.
func on_edit(trigger: Signal, change: Callable) -> void:
	trigger.connect(
		func(...arguments: Array) -> void:
			# What the opening has moved is no change of its own: undo leads to the start.
			if not _opening:
				motion_ended.emit()
			var problem: Variant = change.callv(arguments)
			noticed.emit("")
			finish_edit()
			if problem:
				noticed.emit(problem)
	)


## While [param moved] is emitted, [param change] changes the model, and what moved by itself is
## paused; the change is complete when [param released] is emitted.
func on_drag(moved: Signal, released: Signal, change: Callable) -> void:
	moved.connect(func(..._arguments: Array) -> void: pause())
	on_move(moved, change)
	released.connect(finish_edit)


## The same for [param handle], a [Handle], whose own signals tell of the drag.
func on_handle(handle: Control, change: Callable) -> void:
	on_drag(Signal(handle, &"moved"), Signal(handle, &"released"), change)


## When a number in the formula is typed over, [param change] gets its name and its new value; the
## change is complete. Only where that is not [method LessonModel.enter], and before [method begin].
func on_enter(change: Callable) -> void:
	_has_own_enter = true
	on_edit(Signal(services[&"formula"], &"number_entered"), change)


## When [param trigger] is emitted, as by what moves by itself, [param change] changes the model;
## nothing is kept for undo. For what the student moves there is [method on_drag].
func on_move(trigger: Signal, change: Callable) -> void:
	trigger.connect(
		func(...arguments: Array) -> void:
			_notice(change.callv(arguments))
			_end_answer()
			_show_everywhere()
	)


## When the student picks something in the panel - a preset, a switch, a mistake, the numbers of a
## question - [param change] gets what this changes in the state; the change is complete. If it
## can be made, [param reveal] gets the same, to go to the step at which it is seen. Only where that
## is not [method LessonModel.take] alone, and before [method begin].
func on_pick(change: Callable, reveal: Callable = Callable()) -> void:
	_has_own_pick = true
	for service: Control in services.values():
		if service.has_signal(&"picked"):
			_follow_picks(service, change, reveal)


## Adds a switch with the translated [param text] for [param key] in the model's state.
func add_switch(key: String, text: String) -> void:
	_offered(&"options").call(&"add_switch", key, text)


## Offers what is in the model's state in each of [param presets], by their titles, source text.
func offer_presets(presets: Dictionary[String, Dictionary]) -> void:
	_offered(&"options").call(&"offer_presets", presets)


## Offers [param mistakes], each a [MistakeInfo], of which the model's state has one as `mistake`.
## [param step_of] gets the number of a mistake that is switched on and the step that is shown, and
## returns the step to go to, so that the mistake is seen.
func offer_mistakes(mistakes: Array, step_of: Callable = Callable()) -> void:
	_offered(&"mistakes").call(&"add_all", mistakes)
	_step_of_mistake = step_of


## Offers the questions of [param exercises], a class of [Exercise] with an `enum Kind` and a static
## method `fresh`; see [method Question.offer], also for [param of_the_lecture].
func offer_questions(
	exercises: GDScript, of_the_lecture: Callable = Callable(), first_kind: int = 0
) -> void:
	_offered(&"question").call(&"offer_kinds", exercises, first_kind, of_the_lecture)


## From now on [param view] shows the model in the panel, after the lesson itself has shown it: its
## method `show_model` gets the model and the step. A view with a method `measure` gets the model
## there before a complete change is shown, but not during a drag, which measuring would slow down.
func show_in_panel(view: Object) -> void:
	_views.append(view)
	if view.has_method(&"measure"):
		about_to_show.connect(func() -> void: view.call(&"measure", _kept_model))


## While the empty board is clicked or dragged on with [param button], [param change] gets the point
## below the pointer; the change is complete when the button is released.
func on_point(button: MouseButton, change: Callable) -> void:
	board.pointed.connect(
		func(at: Vec2, pressed: MouseButton) -> void:
			if pressed == button:
				pause()
				_notice(change.call(at))
				_end_answer()
				_show_everywhere()
	)
	if not board.released.is_connected(finish_edit):
		board.released.connect(finish_edit)


## A change is complete: shows everything and has the lesson frame keep the state for undo.
func finish_edit() -> void:
	stop_opening()
	_end_answer()
	show_all()
	edited.emit()


## Fits the board and shows the model, here and where a service shows what is picked; with the
## [Conventions] that are chosen.
func show_all() -> void:
	propagate_call(&"turn_over", [Conventions.is_y_up() and not keeps_y_down])
	if _points_to_show:
		var points: Array[Vec2] = _points_to_show.call()
		board.fit(points)
	about_to_show.emit()
	for service: Control in services.values():
		if service.has_method(&"show_picked"):
			service.call(&"show_picked", _kept_model.to_dictionary())
	_show_everywhere()


## Tells these translated sentences, one for each step. Call it first in what shows the model: it
## sets [member step], which is 0 at the start.
func tell_steps(sentences: PackedStringArray) -> void:
	services[&"steps"].call(&"tell", sentences)


## Shows these lines of GDScript, which compute what the formula shows, and what comes out of them
## with the values of [param inputs]; see [method LessonCode.show_code].
func tell_code(lines: PackedStringArray, inputs: Dictionary[String, Variant]) -> void:
	services[&"code"].call(&"show_code", lines, inputs)


## Stops what moves by itself, where the lesson has a transport.
func pause() -> void:
	if services.has(&"transport"):
		services[&"transport"].set(&"is_playing", false)


## Lights up the arrows that have the colour of [param role], and no others.
func light(role: Palette.Role) -> void:
	board.propagate_call(&"light", [role])


## All that undo, reset and links have to know.
func state() -> Dictionary:
	return _kept_model.to_dictionary()


## Shows what [method state] returned; emits nothing.
func show_state(stored: Dictionary) -> void:
	pause()
	_end_answer()
	_kept_model.from_dictionary(stored)
	show_all()


## The state to which reset goes back, where [param first] is the one at the start; see
## [method LessonModel.reset_state].
func reset_state(first: Dictionary) -> Dictionary:
	return _kept_model.reset_state(first) if _kept_model else first


## What a link to the board holds; see [method LessonModel.link_state].
func link_state() -> Dictionary:
	return _kept_model.link_state() if _kept_model else state()


## The values that a link need not name; see [method LessonModel.link_base].
func link_base(first: Dictionary, wanted: Dictionary) -> Dictionary:
	return _kept_model.link_base(first, wanted) if _kept_model else first


## "" if the lesson can show [param linked], a link state with the right names and kinds; else one
## translated sentence with the value and what is allowed.
func link_problem(linked: Dictionary) -> String:
	return _kept_model.problem_in(linked) if _kept_model else ""


## Shows a link state that has no [method link_problem]; emits nothing but a notice.
func show_link(linked: Dictionary) -> void:
	show_state(_kept_model.state_of_link(linked) if _kept_model else linked)


# What is typed and picked where the lesson has not said what it changes.
func _let_model_take() -> void:
	if services.has(&"formula") and not _has_own_enter:
		on_enter(_kept_model.enter)
	if not _has_own_pick:
		for service: Control in _offering:
			_follow_picks(service, _kept_model.take, Callable())


# The service with this name, from which the student picks.
func _offered(service_name: StringName) -> Control:
	var service := services[service_name]
	if not service in _offering:
		_offering.append(service)
	return service


func _follow_picks(service: Control, change: Callable, reveal: Callable) -> void:
	var change_and_reveal := func(changes: Dictionary) -> Variant:
		var refusal: Variant = change.call(changes)
		if not refusal:
			_go_where_seen(changes)
			if reveal:
				reveal.call(changes)
		return refusal
	on_edit(Signal(service, &"picked"), change_and_reveal)


# A mistake that was switched on is seen at some steps only.
func _go_where_seen(changes: Dictionary) -> void:
	var mistake: int = changes.get("mistake", 0)
	if mistake != 0 and _step_of_mistake:
		var seen_at: int = _step_of_mistake.call(mistake, step)
		if seen_at != step:
			show_step(seen_at)


# The lesson sets the step; then the panel shows it, too.
func _show_everywhere() -> void:
	_show_model.call()
	for view in _views:
		view.call(&"show_model", _kept_model, step)


# The steps explain the lesson's own numbers, until the student has chosen others.
func _go_back_to(first: Dictionary) -> void:
	if _opening:
		stop_opening()
		show_state(first)


# What was said about a prediction is about the board as it was.
func _end_answer() -> void:
	if services.has(&"steps"):
		services[&"steps"].call(&"end_answer")


func _notice(problem: Variant) -> void:
	if problem is String:
		noticed.emit(problem)


# "" if every number of a state is finite; else which is not. For people who write lessons.
static func _not_finite(numbers: Dictionary) -> String:
	for key: String in numbers:
		if typeof(numbers[key]) in [TYPE_FLOAT, TYPE_PACKED_FLOAT64_ARRAY]:
			var text := var_to_str(numbers[key])
			if text.contains("nan") or text.contains("inf"):
				return "%s must be finite at the start, not %s." % [key, text]
	return ""
