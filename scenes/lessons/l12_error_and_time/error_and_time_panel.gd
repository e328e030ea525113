class_name ErrorAndTimePanel
extends RefCounted
## The panel of the lesson on error and run time: problem, progress, the order of the method pointed
## at, the ends of the frontier, questions.

var _progress: Progress
var _options: LessonOptions
var _formula: Formula
var _readout: Readout
var _question: Question
var _exercise_kind := SlopeExercise.Kind.ORDER
var _rng := RandomNumberGenerator.new()


## Fills the services that the frame has brought.
func _init(services: Dictionary[StringName, Control]) -> void:
	_progress = services[&"progress"] as Progress
	_options = services[&"options"] as LessonOptions
	_formula = services[&"formula"] as Formula
	_readout = services[&"readout"] as Readout
	_question = services[&"question"] as Question
	_question.exercise_wanted.connect(_ask)
	_readout.show_headings(ErrorAndTimeTexts.headings())
	_define_formula()
	_ask()


## Lists the problems of [param model].
func fill_problems(model: ErrorAndTimeModel) -> void:
	var titles: PackedStringArray = []
	for problem in model.problems:
		titles.append(MeasuredWords.title(problem.id))
	_options.add_choice("problem", tr("What is measured"), titles)
	_options.add_choice("situation", tr("The situation"), [])
	_options.add_preset("measurements", tr("Error and run time"))
	_options.add_preset("stability", tr("Stability"))


## Shows which problem and situation of [param model] are chosen.
func show_problem(model: ErrorAndTimeModel) -> void:
	var situations: PackedStringArray = []
	for situation in model.situations():
		situations.append(MeasuredWords.of(situation))
	_options.fill_choice("situation", situations)
	_options.show_choice("problem", model.problem_place)
	_options.show_choice("situation", model.situation_place)


## Shows only what belongs to the table of stability, or to the measurements.
func show_page(is_stability_open: bool) -> void:
	_formula.visible = not is_stability_open
	_readout.visible = not is_stability_open


## Shows how far the table of stability is.
func show_stability(run: StabilityRun) -> void:
	var words := ErrorAndTimeTexts.stability_progress(run)
	_progress.show_progress(run.is_going, run.share(), words)


## Shows how far the measuring is.
func show_run(run: MeasuringRun) -> void:
	_progress.show_progress(run.is_going, run.share(), ErrorAndTimeTexts.progress(run))


## Shows the measurement with the place [param place], -1 for none, beside the ends of the frontier.
func show_point(measurements: Array[Measurement], frontier: PackedInt32Array, place: int) -> void:
	var fastest := measurements[frontier[0]] if frontier else null
	var closest := measurements[frontier[-1]] if frontier else null
	var pointed := measurements[place] if place >= 0 and frontier else null
	_show_row(tr("fastest"), fastest, fastest)
	_show_row(tr("closest"), closest, fastest)
	_show_row(tr("pointed at"), pointed, fastest)
	var other := ErrorAndTimeModel.neighbour(measurements, place) if place >= 0 else -1
	if other >= 0:
		_show_order(measurements[place], measurements[other])
	else:
		_formula.show_lines(ErrorAndTimeTexts.formula_lines(false, false))


func _show_order(one: Measurement, other: Measurement) -> void:
	var order := ErrorAndTimeModel.order(one, other)
	_formula.show_lines(ErrorAndTimeTexts.formula_lines(true, is_finite(order)))
	_formula.set_text("e1_number", NumberText.short(one.error, 3))
	_formula.set_text("e2_number", NumberText.short(other.error, 3))
	_formula.set_text("t1_number", NumberText.short(one.run_time_us, 3))
	_formula.set_text("t2_number", NumberText.short(other.run_time_us, 3))
	_formula.set_text("p_number", NumberText.short(order, 3))


func _show_row(title: String, measurement: Measurement, fastest: Measurement) -> void:
	_readout.show_texts(title, ErrorAndTimeTexts.row(title, measurement, fastest))


func _define_formula() -> void:
	_formula.define_symbol("p", "p", Palette.Role.PROJECTION)
	_formula.define_symbol("e1", "e₁", Palette.Role.B)
	_formula.define_symbol("e2", "e₂", Palette.Role.B)
	_formula.define_symbol("t1", "t₁", Palette.Role.A)
	_formula.define_symbol("t2", "t₂", Palette.Role.A)
	for error: String in ["e1_number", "e2_number"]:
		_formula.define_number(error, Palette.Role.B)
	for time: String in ["t1_number", "t2_number"]:
		_formula.define_number(time, Palette.Role.A)
	_formula.define_number("p_number", Palette.Role.PROJECTION)


func _ask() -> void:
	_question.show_exercise(SlopeExercise.fresh(_exercise_kind, _rng))
	_exercise_kind = (_exercise_kind + 1) % SlopeExercise.Kind.size() as SlopeExercise.Kind
