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
# Until the student points at a point, the closest one shows what it is.
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
	_options.add_choice("problem", tr("What is measured"), MeasuredTexts.titles(_model.problems))
	_options.add_choice("situation", tr("The situation"), [])
	_options.add_preset("measurements", tr("Error and run time"))
	_options.add_preset("stability", tr("Stability"))
	on_edit(_options.chosen, _choose)
	on_edit(_options.preset_picked, _open_page)
	on_move(_progress.begun, _model.begin)
	on_move(_progress.stopped, _model.stop)
	_plot.point_chosen.connect(_point)
	(services[&"question"] as Question).offer(SlopeExercise.fresh, SlopeExercise.Kind.size())
	_model.begin()
	begin(_model, _show)


func _engine_cases(problem_id: String) -> Array[MeasuredCase]:
	return EngineCases.of(problem_id, true, %Engine as Node)


## Here measuring is what goes on by itself.
func pause() -> void:
	_model.stop()


func show_state(stored: Dictionary) -> void:
	_has_pointed = false
	super(stored)


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


func _choose(key: String, place: int) -> void:
	_leave_page()
	_model.is_stability_open = false
	if key == "problem":
		_model.choose_problem(place)
	else:
		_model.situation_place = place
	_model.go_on()


func _open_page(page: String) -> void:
	_leave_page()
	_model.is_stability_open = page == "stability"
	_model.go_on()


func _leave_page() -> void:
	_model.stop()
	_has_pointed = false


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
	var problem := _model.problem()
	_plot.x_title = MeasuredTexts.of(problem.run_time_axis)
	_plot.y_title = MeasuredTexts.of(problem.error_axis)
	_plot.show_series(MeasuredTexts.all_of(_model.run().methods()), _model.run().are_baselines())
	_options.fill_choice("situation", MeasuredTexts.all_of(_model.situations()))
	_options.show_choice("problem", _model.problem_place)
	_options.show_choice("situation", _model.situation_place)
	_table.visible = _model.is_stability_open
	for part: Control in [_plot, services[&"formula"], services[&"readout"]]:
		part.visible = not _model.is_stability_open
	_show_progress()


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
	var frontier := ErrorAndTimeModel.frontier(measurements)
	var methods := run.methods()
	var points: Array[PlotPoint] = []
	for i in measurements.size():
		var measured := measurements[i]
		var words := ErrorAndTimeTexts.words(measured, i in frontier)
		var series := methods.find(measured.method)
		points.append(PlotPoint.new(measured.run_time_us, measured.error, series, words))
	_plot.show_points(points, frontier)
	if not _has_pointed:
		_plot.show_chosen(frontier[-1] if frontier else -1)
	_formula.show_order(measurements, _plot.chosen())
	_readout.show_point(measurements, frontier, _plot.chosen())
