class_name SteppedFlight
extends ShotFlight
## A ball's flight in one of the lecture's ways of stepping.

## The names of the ways in tables.
const METHODS: Dictionary[SteppingMethods.Method, String] = {
	SteppingMethods.Method.POSITION_RESET: "position reset",
	SteppingMethods.Method.POINT_OF_IMPACT: "impact, rest dropped",
	SteppingMethods.Method.WHOLE_FRAME: "impact, rest used",
}

const _PARTS := 5

var _way: SteppingMethods.Method
var _world: SteppedWorld


## A flight stepped in this way.
func _init(way: SteppingMethods.Method, of_shot: Shot, at_rate: int) -> void:
	super(of_shot, at_rate)
	_way = way
	method = METHODS[way]
	error = Measurement.NO_ANSWER
	note = "not flown to the end yet"


## See [method MeasuredCase.run_once]. Stepping is slow, so a run is a fifth of the flight: the
## world is kept, and five runs make one flight.
func run_once() -> void:
	if runs() % _PARTS == 0:
		_set_up()
	if not refusal:
		_fly(floori(float(steps) / _PARTS))
	keep_run(_spent * _PARTS / seconds)
	if runs() == _PARTS and not refusal:
		note = ""
		_find_error()


func _prepare() -> void:
	_world = SteppedWorld.new(SteppingMethods.mover_of(_way))
	keep_refusal(_world.surroundings.set_segments(shot.segments()))
	keep_refusal(_world.set_balls([shot.ball]))


func _fly(count: int) -> void:
	var world := _world
	var start := Time.get_ticks_usec()
	for i in count:
		var refused := world.step(step_seconds)
		if refused:
			keep_refusal(refused)
			break
		var place := world.balls[0].position
		_x = place.x
		_y = place.y
	_spent = Time.get_ticks_usec() - start
