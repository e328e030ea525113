class_name StabilityRow
extends HBoxContainer
## A case of the stability table: sign, what is tried, what must hold, the figure.

@onready var _mark: StabilityMark = %Mark
@onready var _title: Label = %Title
@onready var _criterion: Label = %Criterion
@onready var _figure: Label = %Figure


## Shows a case and what became of it; null before it was tried.
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


## What the row shows as having become of its case.
func outcome() -> StabilityMark.Outcome:
	return _mark.outcome
