extends Lesson
## The lesson on error and run time: the methods of the course and the engine's own are measured
## while one looks on.

# Microseconds of a frame that measuring may take; a single run may take more.
const _SLICE := 8000

var _model: ErrorAndTimeModel
var _panel: ErrorAndTimePanel
var _measurements: Array[Measurement] = []
# Until the student points at something, the closest point tells what it is.
var _has_pointed := false

@onready var _plot: LogPlot = %Plot
@onready var _table: StabilityTable = %Table


func start() -> void:
	_model = ErrorAndTimeModel.new(_engine_cases)
	_panel = ErrorAndTimePanel.new(services)
	_panel.fill_problems(_model)
	var progress := services[&"progress"] as Progress
	progress.begun.connect(_begin)
	progress.stopped.connect(_stop)
	var options := services[&"options"] as LessonOptions
	options.chosen.connect(_choose)
	options.preset_picked.connect(_turn_to)
	_plot.point_chosen.connect(_show_point)
	_show_all()
	_begin()


func state() -> Dictionary:
	return _model.to_dictionary()


func show_state(stored: Dictionary) -> void:
	_stop()
	_model.from_dictionary(stored)
	_show_all()


## Reset measures anew.
func reset_state(first: Dictionary) -> Dictionary:
	_model.forget()
	return first


func link_problem(linked: Dictionary) -> String:
	return _model.problem_of(linked)


func show_link(linked: Dictionary) -> void:
	show_state(linked)
	_begin()


func _engine_cases(problem_id: String) -> Array[MeasuredCase]:
	return EngineCases.of(problem_id, true, %Engine as Node)


# What the student does.


func _choose(key: String, place: int) -> void:
	_stop()
	_model.is_stability_open = false
	if key == "problem":
		_model.choose_problem(place)
	else:
		_model.situation_place = place
	_finish()


func _turn_to(page: String) -> void:
	_stop()
	_model.is_stability_open = page == "stability"
	_finish()


# What is not finished goes on by itself.
func _finish() -> void:
	_show_all()
	edited.emit()
	if not _model.open_run().is_done():
		_begin()


func _begin() -> void:
	_model.begin()
	_show_progress()


func _stop() -> void:
	_model.open_run().is_going = false
	_show_progress()


# A slice a frame: in between the window draws and listens.
func _process(_delta: float) -> void:
	if _model.open_run().is_going:
		_model.open_run().advance(_SLICE)
		_show_progress()


# What the student sees.


func _show_all() -> void:
	var run := _model.run()
	var names: PackedStringArray = []
	for method in run.methods():
		names.append(MeasuredWords.of(method))
	var problem := _model.problem()
	_plot.name_axes(MeasuredWords.of(problem.run_time_axis), MeasuredWords.of(problem.error_axis))
	_plot.show_series(names, run.are_baselines())
	_has_pointed = false
	_panel.show_problem(_model)
	_panel.show_page(_model.is_stability_open)
	_plot.visible = not _model.is_stability_open
	_table.visible = _model.is_stability_open
	_show_run()
	_show_progress()


func _show_progress() -> void:
	if _model.is_stability_open:
		_table.show_run(_model.stability)
		_panel.show_stability(_model.stability)
	else:
		_show_run()


func _show_run() -> void:
	var run := _model.run()
	_measurements = run.measurements()
	var frontier := ErrorAndTimeModel.frontier(_measurements)
	var methods := run.methods()
	var points: Array[PlotPoint] = []
	for i in _measurements.size():
		var measured := _measurements[i]
		var words := ErrorAndTimeTexts.words(measured, i in frontier)
		var series := methods.find(measured.method)
		points.append(PlotPoint.new(measured.run_time_us, measured.error, series, words))
	_plot.show_points(points, frontier)
	if not _has_pointed:
		_plot.show_chosen(frontier[-1] if frontier else -1)
	_panel.show_run(run)
	_panel.show_point(_measurements, frontier, _plot.chosen())


func _show_point(_index: int) -> void:
	_has_pointed = true
	var frontier := ErrorAndTimeModel.frontier(_measurements)
	_panel.show_point(_measurements, frontier, _plot.chosen())
