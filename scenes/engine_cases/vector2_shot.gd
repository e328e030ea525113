class_name Vector2Shot
extends RefCounted
## Where to aim, as users of Godot write it with Vector2, whose components have 32 bits.

## What is asked, in the lab's vectors.
var asked: AimQuestion

var _shooter: Vector2
var _target: Vector2
var _velocity: Vector2
var _speed: float
var _gravity: float


func _init(question: AimQuestion) -> void:
	asked = question
	_shooter = question.shooter.to_vector2()
	_target = question.target.position.to_vector2()
	_velocity = question.target.velocity.to_vector2()
	_speed = question.speed
	_gravity = question.gravity.y


## The earlier time at which the bullet's circle reaches the target; zero without one.
func by_quadratic_equation() -> Vector2:
	var way := _target - _shooter
	var a := _velocity.length_squared() - _speed * _speed
	var b := 2.0 * way.dot(_velocity)
	var c := way.length_squared()
	var discriminant := b * b - 4.0 * a * c
	if discriminant < 0.0 or is_zero_approx(a):
		return Vector2.ZERO
	var root := sqrt(discriminant)
	var times: Array[float] = [(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)]
	times.sort()
	for time in times:
		if time > 0.0:
			return (way + _velocity * time).normalized()
	return Vector2.ZERO


## At where the target is after the time that the bullet needs to where it is now.
func by_one_guess() -> Vector2:
	var time := _shooter.distance_to(_target) / _speed
	return _shooter.direction_to(_target + _velocity * time)


## The flat arc by the tangent of the angle, at where the target is after that time; zero where it
## cannot be reached.
func by_tangent() -> Vector2:
	var time := _shooter.distance_to(_target) / _speed
	var way := _target + _velocity * time - _shooter
	var square := _speed * _speed
	var inside := square * square - _gravity * (_gravity * way.x * way.x - 2.0 * way.y * square)
	if inside < 0.0:
		return Vector2.ZERO
	var tangent := (square - sqrt(inside)) / (_gravity * absf(way.x))
	return Vector2(signf(way.x), -tangent).normalized()


## By how much a direction misses, in pixels; NAN for zero, which is none.
func miss(direction: Vector2) -> float:
	return asked.miss(Vec2.from_vector2(direction)) if direction else NAN
