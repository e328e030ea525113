class_name SurfaceFrame
extends RefCounted
## The frame of reference of a surface that a ball of an [EventWorld] touches. THE LAWS OF CONTACT
## HOLD AS SEEN FROM THE SURFACE: its velocity is taken away from that of the ball, the laws are
## those of a surface at rest, and then it is added again.
##
## On a segment that turns a ball never lies: its short bounces end in hops, which are too low to be
## seen. So do those of a ball that is shaken, to and fro between surfaces that move.

## A hop off a segment that turns takes [constant BallPiles.LEAST_HOP], or no longer than the
## segment takes to turn by this, in radians.
const HOP_TURN := 0.02

const _LEAST_SHARE := 1.0 / 2.0 ** 44

## x of the velocity of the frame, in px/s; 0 while no ball is in it.
var x := 0.0
## y of the velocity.
var y := 0.0
## How fast the surface turns, in rad/s.
var turn := 0.0
## With this speed along its normal a ball leaves the surface at least, in px/s.
var least_speed := 0.0
## Whether a ball can come to rest on the surface.
var can_rest := true
## How fast a belt runs, in px/s, to the right of a normal that points up.
var belt := 0.0

var _segments: SegmentScan
# px/s².
var _gravity: Vec2
# The ball and the unit normal of the surface towards it.
var _ball: Ball
var _normal: Vec2
# The arrays of the world, which are never assigned anew.
var _velocity_x: PackedFloat64Array
var _velocity_y: PackedFloat64Array
var _lasting_speed: PackedFloat64Array


func _init(
	velocity_x: PackedFloat64Array,
	velocity_y: PackedFloat64Array,
	lasting_speed: PackedFloat64Array
) -> void:
	_velocity_x = velocity_x
	_velocity_y = velocity_y
	_lasting_speed = lasting_speed


## Takes the segments of the world and its gravity, in px/s².
func set_up(segments: SegmentScan, gravity: Vec2) -> void:
	_segments = segments
	_gravity = gravity


## From now on the ball is seen from the surface at this place, which it touches with this unit
## normal, until [method leave].
func enter(index: int, place: int, ball: Ball, normal: Vec2) -> void:
	_ball = ball
	_normal = normal
	var touched := ball.position.minus(normal.scaled(ball.radius))
	var velocity := _segments.velocity_at(place, touched)
	x = velocity.x
	y = velocity.y
	turn = _segments.turn_of(place)
	can_rest = can_rest and turn == 0.0
	_segments.see_from(place)
	_change_velocity(index, -1.0)


## The ball touches the line of the segment at this place, not its round end.
func note_belt(place: int) -> void:
	belt = _normal.cross(_segments.belt_velocity(place))


## A ball that has come back to a segment that turns within this time, in seconds, hops.
func hop_if_short(place: int, since_last_touch: float) -> void:
	var seconds := minf(BallPiles.LEAST_HOP, HOP_TURN / absf(turn))
	if since_last_touch < seconds:
		var pressure := _segments.pressure_at(place, _ball.position, _ball.velocity, _normal)
		least_speed = maxf(least_speed, 0.5 * (pressure - _gravity.dot(_normal)) * seconds)
		# What is not pressed leaves by more than rounding.
		var fastest := _ball.velocity.length() + Vec2.new(x, y).length()
		least_speed = maxf(least_speed, _LEAST_SHARE * fastest)


## At its next touch the ball hops, and does not come to rest.
func shake() -> void:
	can_rest = false
	least_speed = 0.5 * _gravity.length() * BallPiles.LEAST_HOP


## The ball is seen from where the world rests again.
func leave(index: int) -> void:
	_change_velocity(index, 1.0)
	_segments.see_from(-1)
	x = 0.0
	y = 0.0
	turn = 0.0
	belt = 0.0
	least_speed = 0.0
	can_rest = true


func _change_velocity(index: int, times: float) -> void:
	if x != 0.0 or y != 0.0:
		_velocity_x[index] += times * x
		_velocity_y[index] += times * y
		_lasting_speed[index] = NAN
