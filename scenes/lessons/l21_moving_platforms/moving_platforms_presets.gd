class_name MovingPlatformsPresets
extends RefCounted
## The numbers with which each kind of moving surface starts, and others worth a look.

# The paddle stands upright when it meets the ball: it has turned by this angle then, in radians,
# from its place at the start, which lies (-120, 90) from the pivot.
const _TURNED := acos(-0.6)
const _PADDLE_TURN := 2.0
const _PADDLE_TIME := _TURNED / _PADDLE_TURN

const _WALL: Dictionary[String, Variant] = {
	kind = 0,
	ball = [200, -100],
	velocity = [-200, 100],
	surface = [-120, -120, -120, 120],
	surface_velocity = [100, 0],
	bounciness = 1.0
}
const _BELT: Dictionary[String, Variant] = {
	kind = 1,
	ball = [-120, 20],
	surface = [-200, 40, 200, 40],
	speed = 0.0,
	surface_speed = 90.0,
	friction = 0.05
}
const _PLATFORM: Dictionary[String, Variant] = {
	kind = 2, surface_speed = 90.0, way = 180.0, friction = 0.2
}
const _PADDLE: Dictionary[String, Variant] = {
	kind = 3,
	ball = [20.0 + 200.0 * _PADDLE_TIME, -100.0 * _PADDLE_TIME],
	velocity = [-200, 100],
	surface = [0, 100, -120, 190],
	turning = _PADDLE_TURN,
	bounciness = 1.0
}
const _PRESS: Dictionary[String, Variant] = {
	kind = 4, way = 200.0, speed = 300.0, surface_speed = 100.0
}

## With which numbers each kind starts, in the order of [enum MovingSurface.Kind].
const OF_KIND: Array[Dictionary] = [_WALL, _BELT, _PLATFORM, _PADDLE, _PRESS]

## Presets by their titles (source text): what each changes in the model's state.
const ALL: Dictionary[String, Dictionary] = {
	"Head-on":
	{
		kind = 0,
		ball = [200, 0],
		velocity = [-200, 0],
		surface = [-120, -120, -120, 120],
		surface_velocity = [100, 0],
		bounciness = 1.0
	},
	"C = 0.5":
	{
		kind = 0,
		ball = [200, 0],
		velocity = [-200, 0],
		surface = [-120, -120, -120, 120],
		surface_velocity = [100, 0],
		bounciness = 0.5
	},
	"From behind":
	{
		kind = 0,
		ball = [0, -25],
		velocity = [100, 50],
		surface = [-120, -120, -120, 120],
		surface_velocity = [300, 0],
		bounciness = 1.0
	},
	"Uphill":
	{
		kind = 1,
		ball = [-96, 8],
		surface = [-192, 56, 192, -56],
		speed = 0.0,
		surface_speed = 348.0,
		friction = 0.5
	},
}
