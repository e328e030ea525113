class_name MyVec2
extends RefCounted
## Your own vector, in pixels, with y pointing down as in Godot. Save this file, and the lab looks
## at it at once.
##
## Verbs change the vector itself and give nothing back: [method rotate], [method reflect]. Nouns
## and participles leave it alone and give something back: [method normalized], [method normal].

## The component to the right.
var x := 0.0
## The component downwards.
var y := 0.0


func _init(x_component: float = 0.0, y_component: float = 0.0) -> void:
	x = x_component
	y = y_component


func _to_string() -> String:
	return "(%s, %s)" % [x, y]


## A new vector: this one and [param other] together.
func plus(other: MyVec2) -> MyVec2:
	return MyVec2.new(x + other.x, y + other.y)


## A new vector: the way from [param other] to this one.
func minus(other: MyVec2) -> MyVec2:
	return MyVec2.new(x - other.x, y - other.y)


## A new vector: this one, [param factor] times as long.
func scaled(factor: float) -> MyVec2:
	return MyVec2.new(x * factor, y * factor)


## The length in pixels.
func length() -> float:
	return sqrt(x * x + y * y)


## Exercise 0: rotate this vector by [param angle] radians, from the x axis towards the y axis.
## Change x and y; give nothing back.
func rotate(angle: float) -> void:
	var old_x := x
	x = old_x * cos(angle) - y * sin(angle)
	y = old_x * sin(angle) + y * cos(angle)


## Exercise 0: rotate this position around [param point] by [param angle] radians. Change x and y.
func rotate_around(point: MyVec2, angle: float) -> void:
	x -= point.x
	y -= point.y
	rotate(angle)
	x += point.x
	y += point.y


## Exercise 1: a new vector of length 1 in the same direction. A zero vector gives (0, 0).
func normalized() -> MyVec2:
	var size := length()
	if size == 0.0:
		return MyVec2.new()
	return MyVec2.new(x / size, y / size)


## Exercise 2: the unit normal as a new vector: turned from (x, y) to (-y, x), with length 1. A zero
## vector gives (0, 0).
func normal() -> MyVec2:
	return MyVec2.new(-y, x).normalized()


## Exercise 3: the dot product with [param other]. Nothing is normalized in here.
func dot(other: MyVec2) -> float:
	return x * other.x + y * other.y


## Exercise 4: the signed length of the shadow of this vector on [param onto], which may have any
## length. 0 for a zero onto.
func scalar_projection(onto: MyVec2) -> float:
	return dot(onto.normalized())


## Exercise 4: the shadow of this vector on [param onto] as a new vector. (0, 0) for a zero onto.
func vector_projection(onto: MyVec2) -> MyVec2:
	return onto.normalized().scaled(scalar_projection(onto))


## Exercise 9: reflect this velocity off a line with the unit normal [param normal], which stays as
## it is. [param bounciness] is C: 1 keeps the speed, 0 slides along the line. Change x and y.
func reflect(normal: MyVec2, bounciness: float = 1.0) -> void:
	var change := (1.0 + bounciness) * dot(normal)
	x -= change * normal.x
	y -= change * normal.y
