class_name NewtonBallsReadout
extends RefCounted
## Shows in the readout both velocities after the bounce, how far each is off the exact one, and how
## long the call takes.

var _readout: Readout
var _nanoseconds := 0.0


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout


## Measures the run time of a bounce.
func measure(meeting: BallMeeting) -> void:
	if meeting:
		_nanoseconds = CallTimer.nanoseconds(meeting.velocities_after)


## Shows both velocities, from the step that computes them on.
func show_model(meeting: BallMeeting, step: int) -> void:
	_readout.visible = meeting != null and step >= NewtonBallsModel.Step.AFTER
	if not _readout.visible:
		return
	var after := meeting.velocities_after()
	_show("one", "v₁′", after[0], meeting.one, meeting.two, meeting)
	_show("two", "v₂′", after[1], meeting.two, meeting.one, meeting)


func _show(
	key: String, title: String, velocity: Vec2, ball: Ball, other: Ball, meeting: BallMeeting
) -> void:
	var error := ExactBallBounce.error_of(velocity, ball, other, meeting.normal, meeting.bounciness)
	_readout.show_vector(key, title, velocity, error, _nanoseconds)
