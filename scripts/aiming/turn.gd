class_name Turn
extends RefCounted
## Directions as angles, in radians, clockwise on screen: to look at a target, and to turn to it the
## short way.


## The angle at which [param from] looks at [param to]; 0 where both are in one place.
static func toward(from: Vec2, to: Vec2) -> float:
	return to.minus(from).angle_radians()


## The angle of something that is mounted on what has turned by [param mount], such as a barrel on a
## hull, so that it points along [param angle]: in (-PI, PI].
static func on_mount(angle: float, mount: float) -> float:
	return shortest(mount, angle)


## By how much to turn from one angle to the other the short way: in (-PI, PI]. Without this, a
## barrel at 170 degrees turns through 340 degrees to reach -170.
static func shortest(from: float, to: float) -> float:
	var turn := fposmod(to - from, TAU)
	return turn - TAU if turn > PI else turn


## The angle [param from], turned toward [param to] the short way by at most [param step].
static func stepped(from: float, to: float, step: float) -> float:
	return from + clampf(shortest(from, to), -step, step)


## The angle [param from] after [param seconds] of easing toward [param to] the short way: in
## [param half_life] seconds half of the rest is done, whatever the frame rate.
static func eased(from: float, to: float, half_life: float, seconds: float) -> float:
	return to - shortest(from, to) * 0.5 ** (seconds / half_life)
