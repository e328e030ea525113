extends Lesson
## The lesson on error and run time: the methods of the course and the engine's own are measured
## while the student looks on.

# Microseconds of a frame that measuring may take; a single run may take longer.
const _SLICE := 8000

## The problem that is measured at the start.
@export_enum(
	"scalar_projection",
	"ball_in_box",
	"angled_lines",
	"many_segments",
	"dropped_ball",
	"many_balls",
	"digits_of_pi"
)
var first_problem := "ball_in_box"

var _model: ErrorAndTimeModel
var _formula: ErrorAndTimeFormula
var _readout: ErrorAndTimeReadout
# Until the student points at a point, the closest one shows what it is; where the order is shown,
# one that has an order.
var _has_pointed := false

@onready var _plot: LogPlot = %Plot
@onready var _table: StabilityTable = %Table
@onready var _progress: Progress = services.get(&"progress")
@onready var _options: LessonOptions = services.get(&"options")


func start() -> void:
	_model = ErrorAndTimeModel.new(_engine_cases)
	if _model.place_of(first_problem) < 0:
		push_error("There is no problem “%s”." % first_problem)
		return
	_model.choose_problem(_model.place_of(first_problem))
	_formula = ErrorAndTimeFormula.new(services[&"formula"] as Formula)
	_readout = ErrorAndTimeReadout.new(services[&"readout"] as Readout)
	var titles := MeasuredTexts.titles(_model.problems)
	titles.append(tr("Stiff and extreme cases"))
	_options.add_choice("problem", tr("What is measured"), titles, true)
	_options.add_choice("situation", tr("The situation"), [], true)
	on_edit(_options.chosen, _choose)
	on_move(_progress.begun, _model.begin)
	on_move(_progress.stopped, _model.stop)
	_plot.point_chosen.connect(_point)
	add_child(CardPlace.new(_plot.legend, board, services[&"steps"]))
	offer_questions(SlopeExercise)
	_model.begin()
	begin(_model, _show)
	ask_choice_before(
		1, ErrorAndTimeTexts.closest_prompt(), ErrorAndTimeTexts.ranks(), _model.rank_of_closest
	)
	var quarter := func() -> int: return 1
	ask_choice_before(2, ErrorAndTimeTexts.order_prompt(), ErrorAndTimeTexts.remainders(), quarter)


func _engine_cases(problem_id: String) -> Array[MeasuredCase]:
	return EngineCases.of(problem_id, true, %Engine as Node)


## Here measuring is what goes on by itself.
func pause() -> void:
	_model.stop()


func show_state(stored: Dictionary) -> void:
	_has_pointed = false
	super(stored)
	_model.go_on()


## Reset measures anew.
func reset_state(first: Dictionary) -> Dictionary:
	_model.forget()
	return first


## A link measures at once.
func show_link(linked: Dictionary) -> void:
	super(linked)
	_model.begin()
	_show_progress()


# What the student does.


# Behind the problems in their list are the stiff and extreme cases.
func _choose(key: String, place: int) -> void:
	_model.stop()
	_has_pointed = false
	if key == "situation":
		_model.situation_place = place
	else:
		_model.is_stability_open = place == _model.problems.size()
		if not _model.is_stability_open:
			_model.choose_problem(place)
	_model.go_on()


func _point(_index: int) -> void:
	_has_pointed = true
	_show_run()


# A slice a frame: in between the window is drawn and takes input.
func _process(_delta: float) -> void:
	if _model.open_run().is_going:
		_model.open_run().advance(_SLICE)
		_show_progress()


# What the student sees.


func _show() -> void:
	tell_steps(ErrorAndTimeTexts.steps())
	var problem := _model.problem()
	_plot.x_title = MeasuredTexts.of(problem.run_time_axis)
	_plot.y_title = MeasuredTexts.of(problem.error_axis)
	_plot.show_series(MeasuredTexts.all_of(_model.run().methods()), _model.run().are_baselines())
	_show_choices()
	var is_plotted := not _model.is_stability_open
	_table.visible = not is_plotted
	_plot.visible = is_plotted
	services[&"steps"].visible = is_plotted
	services[&"readout"].visible = is_plotted and step >= 1
	services[&"formula"].visible = is_plotted and step >= 2
	_show_progress()


func _show_choices() -> void:
	if _model.is_stability_open:
		_options.fill_choice("situation", [tr("in the event world")])
		_options.show_choice("problem", _model.problems.size())
		return
	_options.fill_choice("situation", MeasuredTexts.all_of(_model.situations()))
	_options.show_choice("problem", _model.problem_place)
	_options.show_choice("situation", _model.situation_place)


func _show_progress() -> void:
	var run := _model.open_run()
	_progress.show_progress(run.is_going, run.share(), ErrorAndTimeTexts.progress(_model))
	if _model.is_stability_open:
		_table.show_run(_model.stability)
	else:
		_show_run()


func _show_run() -> void:
	var run := _model.run()
	var measurements := run.measurements()
	var frontier := ErrorAndTimeModel.frontier(measurements) if step >= 1 else PackedInt32Array()
	var methods := run.methods()
	var points: Array[PlotPoint] = []
	for i in measurements.size():
		var measured := measurements[i]
		var words := ErrorAndTimeTexts.words(measured, i in frontier)
		var series := methods.find(measured.method)
		points.append(PlotPoint.new(measured.run_time_us, measured.error, series, words))
	_plot.show_points(points, frontier)
	if not _has_pointed:
		var place := ErrorAndTimeModel.place_with_order(measurements) if step >= 2 else -1
		_plot.show_chosen(place if place >= 0 or not frontier else frontier[-1])
	_formula.show_order(measurements, _plot.chosen())
	_readout.show_point(measurements, frontier, _plot.chosen())
