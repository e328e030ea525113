class_name StabilityRow
extends HBoxContainer
## A row of the stability table: a mark, what is tried, what must hold, the figure that was found.

@onready var _mark: StabilityMark = %Mark
@onready var _title: Label = %Title
@onready var _criterion: Label = %Criterion
@onready var _figure: Label = %Figure


## Shows a case with its result; null before it is tried.
func show_case(case: StabilityCase, result: StabilityResult) -> void:
	_title.text = case.title
	if case.quick_form:
		_title.text += tr(" (here: %s)") % case.quick_form
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
