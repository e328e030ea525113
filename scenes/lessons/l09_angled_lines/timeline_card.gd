class_name TimelineCard
extends PanelContainer
## The timeline of the event world on the board, with buttons for the previous and the next impact.
## It is visible only while event worlds move the balls.

## The student has gone to another moment; [param problem] is "", or says why it was not reached.
signal moved(problem: String)

var _model: AngledLinesModel

@onready var _bar: TimelineBar = %Bar


func _ready() -> void:
	_bar.moment_wanted.connect(_go_to)
	(%Previous as Button).pressed.connect(go_to_impact.bind(-1))
	(%Next as Button).pressed.connect(go_to_impact.bind(1))


## Shows the timeline of [param model]; nothing where there is none.
func show_model(model: AngledLinesModel) -> void:
	_model = model
	visible = model.timeline != null
	if visible:
		_bar.show_timeline(model.timeline, model.selected)


## Goes to the next impact of the selected ball (1) or to the one before (-1). Stays where no impact
## is known or where there is no timeline.
func go_to_impact(direction: int) -> void:
	if visible:
		var moment := _model.timeline.impact_time(_model.selected, direction)
		if moment >= 0.0:
			_go_to(moment)


func _go_to(seconds: float) -> void:
	moved.emit(_model.go_to(seconds))
