class_name AngledLinesPanel
extends RefCounted
## The panel of the lesson on angled lines: ways of stepping, situations, comparison, mistakes,
## question.

# Microseconds of a paused frame that the comparison may take.
const _SLICE := 4000

var _options: LessonOptions
var _readout: Readout
var _mistakes: Mistakes
var _question: Question
var _comparison := MethodComparison.new()
var _is_comparing := false
var _exercise: SteppingExercise
var _exercise_kind := SteppingExercise.Kind.EARLIEST
var _rng := RandomNumberGenerator.new()


## Fills the services that the frame has brought.
func _init(services: Dictionary[StringName, Control]) -> void:
	_options = services[&"options"] as LessonOptions
	_readout = services[&"readout"] as Readout
	_mistakes = services[&"mistakes"] as Mistakes
	_question = services[&"question"] as Question
	_options.add_choice("method", tr("How a frame is stepped"), AngledLinesTexts.methods())
	_options.add_switch("trails", tr("Trails"))
	_options.add_switch("engine", tr("Godot"))
	for i in AngledLinesScenes.TITLES.size():
		_options.add_preset(str(i), "%d %s" % [i, tr(AngledLinesScenes.TITLES[i])])
	_options.add_preset("fetch", tr("F Fetch"))
	for mistake in AngledLinesMistakes.all():
		_mistakes.add_mistake(mistake)
	_question.exercise_wanted.connect(ask)


## Shows what [param model] is set to, and begins to compare anew.
func show_all(model: AngledLinesModel, has_trails: bool) -> void:
	_options.show_choice("method", model.method)
	show_trails(has_trails)
	_mistakes.show_mistake(model.mistake)
	_comparison.begin(model.world)
	_is_comparing = true
	_show_comparison()


## Shows whether trails are drawn.
func show_trails(has_trails: bool) -> void:
	_options.show_switch("trails", has_trails)


## Shows whether Godot's own body flies along.
func show_engine(is_on: bool) -> void:
	_options.show_switch("engine", is_on)


## The situation that the question is about.
func world_of_question() -> SteppedWorld:
	return _exercise.world


## Goes on comparing the ways of stepping for a moment.
func compare() -> void:
	if _is_comparing:
		_is_comparing = _comparison.advance(_SLICE, AngledLinesModel.FRAME)
		_show_comparison()


## Asks the next question.
func ask() -> void:
	_exercise = SteppingExercise.fresh(_exercise_kind, _rng)
	_question.show_exercise(_exercise)
	_exercise_kind = (_exercise_kind + 1) % SteppingExercise.Kind.size() as SteppingExercise.Kind


func _show_comparison() -> void:
	_readout.show_headings(AngledLinesTexts.headings(_comparison.frames()))
	for method: int in SteppingMethods.Method.size():
		var way := method as SteppingMethods.Method
		_readout.show_texts(str(method), AngledLinesTexts.comparison(_comparison, way))
