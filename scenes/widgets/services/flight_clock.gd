class_name FlightClock
extends RefCounted
## The time of a flight that a [Transport] plays: from 0 to its end, where it stops. Play begins it
## anew then. A long flight runs faster.

## A flight lasts at most so many seconds of the student's, unless a lesson says otherwise.
const LONGEST_SHOWN := 8.0
## So long an opening waits at the end of its flight, in seconds, before the next one.
const PAUSE := 0.8

## How many seconds of the student's a flight lasts at most.
var longest_shown := LONGEST_SHOWN

var _transport: Transport
var _end: Callable
var _show: Callable
var _time := 0.0


## Plays by [param transport] what ends after [code]end.call()[/code] seconds and is shown by
## [code]show.call(seconds)[/code].
func _init(transport: Transport, end: Callable, show: Callable) -> void:
	_transport = transport
	_end = end
	_show = show
	transport.advanced.connect(_advance)


## Goes to a moment, in seconds, and stays there.
func go_to(seconds: float) -> void:
	_transport.is_playing = false
	_put(seconds)


## Where an opening is after [param seconds]: it plays the flight again and again, and waits
## [param pause] seconds at its end.
func repeat(seconds: float, pause: float = PAUSE) -> void:
	var end: float = _end.call()
	_put(minf(fmod(seconds, end + pause), end))


func _advance(seconds: float) -> void:
	var end: float = _end.call()
	if _transport.is_playing and _time >= end:
		_time = 0.0
	_put(clampf(_time + seconds * maxf(1.0, end / longest_shown), 0.0, end))
	if _time == end:
		_transport.is_playing = false


func _put(seconds: float) -> void:
	_time = seconds
	_show.call(seconds)
