class_name EventFlight
extends ShotFlight
## A ball's flight in the event world.

## How the world holds the segments: as its four walls, in a grid, or in a list that is searched
## whole.
enum Form { WALLS, GRID, SCAN }

var _form: Form
var _world: EventWorld


## A flight in a world of this form; [constant Form.WALLS] is for the box only.
func _init(form: Form, method_name: String, of_shot: Shot, at_rate: int) -> void:
	super(of_shot, at_rate)
	_form = form
	method = method_name


func _prepare() -> void:
	_world = EventWorld.new()
	_world.uses_grid = _form != Form.SCAN
	if _form == Form.WALLS:
		var low := Vec2.new(BallInBox.LEFT, BallInBox.TOP)
		keep_refusal(_world.set_walls(low, Vec2.new(BallInBox.RIGHT, BallInBox.BOTTOM)))
	else:
		keep_refusal(_world.set_segments(shot.segments()))
	keep_refusal(_world.set_balls([shot.ball]))


func _fly(count: int) -> void:
	var world := _world
	var places := world.places
	var begin := world.time
	var start := Time.get_ticks_usec()
	for i in count:
		world.moment = begin + (i + 1) * step_seconds
		_x = places[0]
		_y = places[1]
	_spent = Time.get_ticks_usec() - start
	# A world that has stopped on the way says so again.
	keep_refusal(world.advance_to(begin + count * step_seconds))
