class_name IntegratorDrop
extends DropCase
## The dropped ball by one of the usual integrators. A ball that is below the floor after a step is
## put back on it and its speed is reversed, as in part 12 of the lecture.

## The integrators.
enum Way { EXPLICIT_EULER, SEMI_IMPLICIT_EULER, VELOCITY_VERLET }

## The names of the integrators in tables.
const METHODS: Dictionary[Way, String] = {
	Way.EXPLICIT_EULER: "explicit Euler",
	Way.SEMI_IMPLICIT_EULER: "semi-implicit Euler",
	Way.VELOCITY_VERLET: "velocity Verlet",
}

# The fraction of a step's change of speed that counts for the motion of the same step.
const _SHARES: Dictionary[Way, float] = {
	Way.EXPLICIT_EULER: 0.0,
	Way.SEMI_IMPLICIT_EULER: 1.0,
	Way.VELOCITY_VERLET: 0.5,
}

var _share: float


## The ball moved by this integrator.
func _init(way: Way, with_bounciness: float, at_rate: int) -> void:
	super(with_bounciness, at_rate)
	method = METHODS[way]
	_share = _SHARES[way]


func _prepare() -> void:
	_height = DroppedBall.HEIGHT
	_speed = 0.0


# Upward speed is positive.
func _fly(count: int) -> void:
	var height := _height
	var speed := _speed
	var change := -DroppedBall.GRAVITY * step_seconds
	var start := Time.get_ticks_usec()
	for i in count:
		height += (speed + _share * change) * step_seconds
		speed += change
		if height < 0.0:
			height = 0.0
			if speed < 0.0:
				speed = -bounciness * speed
		_height = height
		_speed = speed
	_spent = Time.get_ticks_usec() - start
