class_name SpringDrop
extends DropCase
## The dropped ball on a floor that pushes it out like a spring, harder the deeper it is: the
## penalty method, stepped by semi-implicit Euler.
##
## The damping is chosen so that a bounce of the exact spring leaves the fraction C of the speed:
## the damping ratio is -ln C / sqrt(pi^2 + ln^2 C), and 1 for C = 0. This is the plain damped
## spring, which also brakes a ball that leaves the floor. A step of semi-implicit Euler is stable
## only while stiffness * step^2 < 4.

## The acceleration per pixel of depth, in 1/s^2.
var stiffness: float

var _damping: float


## A floor of this stiffness.
func _init(with_stiffness: float, with_bounciness: float, at_rate: int) -> void:
	super(with_bounciness, at_rate)
	method = "penalty spring, %d Hz" % at_rate
	stiffness = with_stiffness
	tuning = exponent_text(stiffness) + " 1/s^2"
	_damping = 2.0 * damping_share(bounciness) * sqrt(stiffness)


## The damping ratio (1 is critical damping) with which a bounce leaves this fraction of the speed.
static func damping_share(of_bounciness: float) -> float:
	if of_bounciness == 0.0:
		return 1.0
	var logarithm := log(of_bounciness)
	return -logarithm / sqrt(PI * PI + logarithm * logarithm)


## A power of ten, such as 1e6.
static func exponent_text(value: float) -> String:
	return "1e%d" % roundi(log(value) / log(10.0))


func _prepare() -> void:
	_height = DroppedBall.HEIGHT
	_speed = 0.0


func _fly(count: int) -> void:
	var height := _height
	var speed := _speed
	var start := Time.get_ticks_usec()
	for i in count:
		var acceleration := -DroppedBall.GRAVITY
		if height < 0.0:
			acceleration -= stiffness * height + _damping * speed
		speed += acceleration * step_seconds
		height += speed * step_seconds
		_height = height
		_speed = speed
	_spent = Time.get_ticks_usec() - start
