class_name StabilityRow
extends HBoxContainer
## A row of the stability table: a mark, what is tried, what must hold, the figure that was found.

@onready var _mark: StabilityMark = %Mark
@onready var _title: Label = %Title
@onready var _criterion: Label = %Criterion
@onready var _figure: Label = %Figure


## Shows a case that is left out here: in grey.
func show_left_out(case: StabilityCase) -> void:
	_title.text = Conventions.in_unit(case.title)
	_criterion.text = case.criterion
	_figure.text = tr("takes too long here")
	_mark.outcome = StabilityMark.Outcome.LEFT_OUT
	for label in [_title, _figure] as Array[Label]:
		label.theme_type_variation = &"LabelQuiet"


## Shows a case, as it is tried here, with its result; null before it is tried.
func show_case(case: StabilityCase, result: StabilityResult) -> void:
	_title.text = Conventions.in_unit(case.title_in_brief())
	_criterion.text = case.criterion
	_figure.text = result.figure if result else ""
	if not result:
		_mark.outcome = StabilityMark.Outcome.WAITING
	elif result.passed:
		_mark.outcome = StabilityMark.Outcome.PASSED
	else:
		_mark.outcome = StabilityMark.Outcome.FAILED


## The outcome that the row shows.
func outcome() -> StabilityMark.Outcome:
	return _mark.outcome
