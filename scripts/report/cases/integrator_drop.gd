class_name IntegratorDrop
extends DropCase
## The dropped ball by one of the usual ways to step a motion; a ball that is found in the floor is
## put back on it and its speed turned round, as in part 12 of the lecture.

## How speed and height are stepped.
enum Way { EXPLICIT_EULER, SEMI_IMPLICIT_EULER, VELOCITY_VERLET }

## How the ways are named in tables.
const METHODS: Dictionary[Way, String] = {
	Way.EXPLICIT_EULER: "explicit Euler",
	Way.SEMI_IMPLICIT_EULER: "semi-implicit Euler",
	Way.VELOCITY_VERLET: "velocity Verlet",
}

# Which share of a step's change of speed counts for the way in that same step: none, all, half.
const _SHARES: Dictionary[Way, float] = {
	Way.EXPLICIT_EULER: 0.0,
	Way.SEMI_IMPLICIT_EULER: 1.0,
	Way.VELOCITY_VERLET: 0.5,
}

var _share: float


## The ball stepped in this way.
func _init(way: Way, with_bounciness: float, at_rate: int) -> void:
	super(with_bounciness, at_rate)
	method = METHODS[way]
	_share = _SHARES[way]


func _prepare() -> void:
	_height = DroppedBall.HEIGHT
	_speed = 0.0


# Speed is counted upwards.
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
