extends LabTest
## A flight that is played from 0 to its end.

var _transport: Transport
var _clock: FlightClock
var _seen := -1.0
var _end := 2.0


func before_each() -> void:
	var scene := load("res://scenes/widgets/services/transport.tscn") as PackedScene
	_transport = scene.instantiate() as Transport
	add_child_autofree(_transport)
	_end = 2.0
	_clock = FlightClock.new(_transport, func() -> float: return _end, _see)


func test_it_stops_at_its_end_and_play_begins_anew() -> void:
	_transport.is_playing = true
	_transport.advanced.emit(1.5)
	assert_eq(_seen, 1.5)
	_transport.advanced.emit(1.5)
	assert_eq(_seen, 2.0)
	assert_false(_transport.is_playing)
	_transport.is_playing = true
	_transport.advanced.emit(0.25)
	assert_eq(_seen, 0.25)


func test_a_step_back_leads_to_the_start_at_most() -> void:
	_transport.advanced.emit(0.5)
	_transport.advanced.emit(-0.2)
	assert_almost_eq(_seen, 0.3, 1e-15)
	_transport.advanced.emit(-1.0)
	assert_eq(_seen, 0.0)


func test_a_long_flight_runs_faster() -> void:
	_end = 80.0
	_transport.advanced.emit(1.0)
	assert_eq(_seen, 10.0)


func test_going_to_a_moment_pauses() -> void:
	_transport.is_playing = true
	_clock.go_to(1.25)
	assert_false(_transport.is_playing)
	assert_eq(_seen, 1.25)
	_transport.advanced.emit(0.25)
	assert_eq(_seen, 1.5)


func test_an_opening_repeats_it_with_a_pause() -> void:
	_clock.repeat(1.0, 0.5)
	assert_eq(_seen, 1.0)
	_clock.repeat(2.25, 0.5)
	assert_eq(_seen, 2.0)
	_clock.repeat(3.0, 0.5)
	assert_eq(_seen, 0.5)


func _see(seconds: float) -> void:
	_seen = seconds
