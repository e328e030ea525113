class_name Axonometry
extends RefCounted
## A parallel view of three axes: which point of the picture a point of space is seen at.
##
## Before the view is turned, x points right, y down and z away; or, turned over about the x axis, y
## up and z towards the eye. Both are right-handed.

## The view goes no further up or down than this, in radians.
const STEEPEST := 1.4

## The view turned about the y axis, in radians.
var yaw := 0.5
## The view tilted from above (negative: from below), in radians, within [constant STEEPEST].
var pitch := -0.45

## y points up, and z towards the eye.
var is_y_up := false


## Turns the view; the tilt stays within [constant STEEPEST].
func turn(yaw_change: float, pitch_change: float) -> void:
	yaw += yaw_change
	pitch = clampf(pitch + pitch_change, -STEEPEST, STEEPEST)


## Where the point ([param x], [param y], [param z]) of space is seen, in the same units.
func seen_at(x: float, y: float, z: float) -> Vec2:
	var space: PackedFloat64Array = [x, y, z]
	return Vec2.new(
		ComponentLists.dot(space, _rightwards()), ComponentLists.dot(space, _downwards())
	)


## The step in space, parallel to the picture, that is seen as [param step]: x, y and z.
func step_in_space(step: Vec2) -> PackedFloat64Array:
	var right := _rightwards()
	var down := _downwards()
	var found: PackedFloat64Array = []
	for i in 3:
		found.append(step.x * right[i] + step.y * down[i])
	return found


# What lies one unit to the right in the picture.
func _rightwards() -> PackedFloat64Array:
	return [cos(yaw), 0.0, sin(yaw) * _side()]


# What lies one unit down in the picture.
func _downwards() -> PackedFloat64Array:
	return [-sin(yaw) * sin(pitch), cos(pitch) * _side(), cos(yaw) * sin(pitch) * _side()]


func _side() -> float:
	return -1.0 if is_y_up else 1.0
