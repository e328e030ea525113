class_name CollisionFrictionReadout
extends RefCounted
## Shows in the readout velocity and spin after the contact - of two balls those of the one that was
## at rest -, how far each is off the exact one, and how long the call takes; at the last step also
## where the event world has that ball, and how far this is from the formula.

var _readout: Readout
var _nanoseconds := 0.0


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout


## Measures the run time of a bounce.
func measure(contact: FrictionContact) -> void:
	_nanoseconds = CallTimer.nanoseconds(contact.after)


## Shows the numbers of [param contact], from the step that computes them on.
func show_model(contact: FrictionContact, flight: ContactFlight, step: int) -> void:
	var is_flight := step == CollisionFrictionModel.Step.FLY
	_readout.visible = step >= CollisionFrictionModel.Step.AFTER
	_readout.is_the_point = is_flight
	if not _readout.visible:
		return
	var exact := ExactFrictionBounce.new(
		contact.ball, contact.along, contact.bounciness, contact.friction
	)
	var ball := contact.after()[flight.compared_ball()]
	if contact.other:
		var off := exact.error_of_other(ball.velocity)
		_readout.show_vector("velocity", "v₂′", ball.velocity, off, _nanoseconds)
		_readout.show_result(
			"spin", "ω₂′", ball.spin, exact.error_of_other_spin(ball.spin), _nanoseconds
		)
	else:
		var off := exact.error_of(ball.velocity)
		_readout.show_vector("velocity", "v′", ball.velocity, off, _nanoseconds)
		_readout.show_result("spin", "ω′", ball.spin, exact.error_of_spin(ball.spin), _nanoseconds)
	if is_flight:
		_show_place(flight)
	_readout.show_rows(4 if is_flight else 3)


func _show_place(flight: ContactFlight) -> void:
	var place := flight.compared_place()
	var texts: PackedStringArray = [
		tr("P, flown"), NumberText.pair(place.x, place.y), NumberText.size(flight.miss()), ""
	]
	_readout.show_texts("place", texts)
