class_name OneCallFlight
extends EventFlight
## A ball's flight in the event world in one call for the whole time, which is what an event world
## is made for. The ball is not read on the way.

## The name of the setting in tables.
const TUNING := "one call"


## This flight, read only at its end.
func _init(method_name: String, of_shot: Shot) -> void:
	super(EventFlight.Form.WALLS, method_name, of_shot, 60)
	tuning = TUNING


func _fly(count: int) -> void:
	var world := _world
	var start := Time.get_ticks_usec()
	var refused := world.advance(count * step_seconds)
	_x = world.position_x(0)
	_y = world.position_y(0)
	_spent = Time.get_ticks_usec() - start
	keep_refusal(refused)
