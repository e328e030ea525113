class_name SurfaceFrame
extends RefCounted
## The frame of reference of a surface that a ball of an [EventWorld] touches. THE LAWS OF CONTACT
## HOLD AS SEEN FROM THE SURFACE: its velocity is taken away from that of the ball, the laws are
## those of a surface at rest, and then it is added again.

## x of the velocity of the frame, in px/s; 0 while no ball is in it.
var x := 0.0
## y of the velocity.
var y := 0.0
## With this speed along its normal a ball leaves the surface at least, in px/s.
var least_speed := 0.0
## Whether a ball can come to rest on the surface.
var can_rest := true
## How fast a belt runs, in px/s, to the right of a normal that points up.
var belt := 0.0

var _segments: SegmentScan
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


## From now on the ball is seen from the segment at this place, whose point [param point] it
## touches, until [method leave].
func enter(index: int, segments: SegmentScan, place: int, point: Vec2) -> void:
	_segments = segments
	_segments.see_from(place)
	var velocity := segments.velocity_at(place, point)
	x = velocity.x
	y = velocity.y
	_change_velocity(index, -1.0)


## The ball hops off the surface, for so many seconds at least. The surface presses on it with
## [param pressure], in px/s².
func hop(pressure: float, seconds: float) -> void:
	can_rest = false
	least_speed = maxf(0.5 * pressure * seconds, least_speed)


## The ball touches the line of the segment with this unit normal, towards the ball.
func note_belt(place: int, normal: Vec2) -> void:
	var speed: float = _segments.belts.get(place, 0.0)
	if speed != 0.0:
		var along := Vec2.new(_segments.normal_y(place), -_segments.normal_x(place))
		belt = speed * signf(normal.cross(along))


## The ball is seen from where the world rests again.
func leave(index: int) -> void:
	_change_velocity(index, 1.0)
	_segments.see_from(-1)
	x = 0.0
	y = 0.0
	belt = 0.0
	least_speed = 0.0
	can_rest = true


func _change_velocity(index: int, times: float) -> void:
	if x != 0.0 or y != 0.0:
		_velocity_x[index] += times * x
		_velocity_y[index] += times * y
		_lasting_speed[index] = NAN
