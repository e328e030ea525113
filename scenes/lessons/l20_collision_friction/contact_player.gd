class_name ContactPlayer
extends RefCounted
## What is played in the lesson on friction at a bounce: the contact of a state with its flight,
## from the start or at the moment that is shown.

## The contact.
var contact: FrictionContact
## The flight through it: at the first step as if there were no friction.
var flight: ContactFlight

var _show: Callable
var _clock: FlightClock
var _step := 0
var _seconds := 0.0


## Plays by [param transport]. [param show] shows a moment: it gets the contact, its flight and the
## seconds since the start.
func _init(transport: Transport, show: Callable) -> void:
	_show = show
	_clock = FlightClock.new(transport, _end, _go_to)


## Takes contact and flight of [param model] as it is now, for [param step].
func prepare(model: CollisionFrictionModel, step: int) -> void:
	_step = step
	contact = model.contact()
	flight = model.flight(contact, step != CollisionFrictionModel.Step.MEET)


## Goes back to the start, and stands still.
func rewind() -> void:
	_clock.go_to(0.0)


## Plays the flight again and again, where [param seconds] have passed since the beginning.
func repeat(seconds: float) -> void:
	_clock.repeat(seconds)


## Shows the balls at the moment that was shown last.
func show_balls() -> void:
	_show.call(contact, flight, _seconds)


func _go_to(seconds: float) -> void:
	_seconds = seconds
	show_balls()


func _end() -> float:
	return end_of(flight, _step)


## When [param of_flight] ends that is played at [param step], in seconds: while it is asked what
## the contact does, at the contact.
static func end_of(of_flight: ContactFlight, step: int) -> float:
	match step:
		CollisionFrictionModel.Step.SLIP, CollisionFrictionModel.Step.PUSH:
			return of_flight.contact_time
		CollisionFrictionModel.Step.CONE:
			return of_flight.contact_time
		CollisionFrictionModel.Step.FLY:
			return of_flight.end
	return of_flight.contact_time + ContactFlight.LONGEST_SIDE
