class_name FramewiseAim
extends RefCounted
## Looks for a shot frame by frame: at the end of each frame, could the bullet be where the target
## is then? The first frame in which it could decides. So the aim is off by up to a frame of flight.

# Seconds.
const _LONGEST := 10.0


## The shot for [param question], with [param rate] frames a second.
static func first(question: AimQuestion, rate: int) -> Aim:
	var way := question.target.position.minus(question.shooter)
	for frame in range(1, roundi(_LONGEST * rate) + 1):
		var time := float(frame) / rate
		var moved := question.target.velocity.scaled(time)
		moved.subtract(question.gravity.scaled(0.5 * time * time))
		moved.add(way)
		if moved.length() <= question.speed * time:
			return Aim.at(time, moved, question.target.position_after(time))
	return Aim.miss(Aim.Outcome.OUT_OF_REACH)
