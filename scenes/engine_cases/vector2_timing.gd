class_name Vector2Timing
extends RefCounted
## When to fire, as users of Godot write it with Vector2, whose components have 32 bits.

const _STEP := 1.0 / 60.0
# Seconds.
const _LONGEST := 60.0

## What is asked, in the lab's vectors.
var asked: TimedQuestion

var _muzzle: Vector2
var _target: Vector2
var _velocity: Vector2
var _bullet: Vector2


func _init(question: TimedQuestion) -> void:
	asked = question
	_muzzle = question.muzzle.to_vector2()
	_target = question.target.position.to_vector2()
	_velocity = question.target.velocity.to_vector2()
	_bullet = question.bullet.to_vector2()


## Where both ways cross, who needs how long to come there; NAN for never.
func by_formula() -> float:
	var way := _target - _muzzle
	return way.cross(_bullet - _velocity) / _bullet.cross(_velocity)


## Where the bullet's way meets the circle, and when the target is there.
func on_circle() -> float:
	var from := _muzzle - _target
	var a := _bullet.length_squared()
	var b := from.dot(_bullet)
	var root := sqrt(b * b - a * (from.length_squared() - asked.circle_radius ** 2))
	var best := INF
	for side: float in [-1.0, 1.0]:
		var flight := (-b + side * root) / a
		if flight > 0.0:
			var angle := (from + _bullet * flight).angle() - asked.phase
			best = minf(best, fposmod(angle / asked.circle_turn - flight, TAU / asked.circle_turn))
	return best


## Frame by frame: fires when the barrel is nearer to the lead than it turns in half a frame.
func frame_by_frame() -> float:
	var time := 0.0
	while time < _LONGEST:
		var lead := _lead(_target + _velocity * time - _muzzle)
		var barrel := asked.angle + asked.turn * time
		if lead and absf(angle_difference(barrel, lead.angle())) <= 0.5 * asked.turn * _STEP:
			return time
		time += _STEP
	return NAN


## By how much a shot after so many seconds misses, in pixels; NAN for no shot.
func miss(fire: float) -> float:
	return asked.miss(fire) if is_finite(fire) else NAN


# The direction to aim at a target that is there now; zero without one.
func _lead(way: Vector2) -> Vector2:
	var a := _velocity.length_squared() - asked.speed * asked.speed
	var b := way.dot(_velocity)
	var discriminant := b * b - a * way.length_squared()
	if discriminant < 0.0:
		return Vector2.ZERO
	return way + _velocity * ((-b - sqrt(discriminant)) / a)
