class_name StabilityTable
extends ScrollContainer
## The table of stiff and extreme cases on the board, one row a case; those that are left out here
## are at its end. It scrolls to the case that was tried last; at the end to the first one that does
## not hold, or to the top.

const _ROW := preload("res://scenes/lessons/l12_error_and_time/stability_row.tscn")

var _shown := 0
# Whether the angles in the rows are in radians.
var _has_radians := false

@onready var _rows: VBoxContainer = %Rows


## Shows the cases of [param run] with their results.
func show_run(run: StabilityRun) -> void:
	if _rows.get_child_count() == 0:
		for case in run.cases + run.left_out:
			_rows.add_child(_ROW.instantiate())
		_show_all(run)
	elif _has_radians != Conventions.uses_radians():
		_show_all(run)
	_show_rows(run, mini(_shown, run.done_count()), maxi(_shown, run.done_count()))
	if run.done_count() > 0 and run.done_count() != _shown:
		var place := run.first_failure() if run.is_done() else run.done_count() - 1
		ensure_control_visible.call_deferred(row(place))
	_shown = run.done_count()


## The row of a case, by its place.
func row(place: int) -> StabilityRow:
	return _rows.get_child(place) as StabilityRow


func _show_all(run: StabilityRun) -> void:
	_has_radians = Conventions.uses_radians()
	_show_rows(run, 0, run.size())
	for place in run.left_out.size():
		row(run.size() + place).show_left_out(run.left_out[place])


func _show_rows(run: StabilityRun, from: int, to: int) -> void:
	for place in range(from, to):
		var result := run.results[place] if place < run.done_count() else null
		row(place).show_case(run.cases[place], result)
