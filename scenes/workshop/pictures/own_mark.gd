class_name OwnMark
extends RefCounted
## One thing that is drawn of what the student's code answers: a shape on the board, without words.

## NOTE: words alone. ARROW: from one point to another. LENGTH: the same without a direction. BALL:
## a circle, of which only the rim is drawn. WAY: the way of a shot.
enum Shape { NOTE, ARROW, LENGTH, BALL, WAY }

## What it is.
var shape := Shape.NOTE
## Where it begins, or the middle of a ball, or where the words stand.
var from := Vec2.new()
## Where it ends; the same as [member from] for a note and a ball.
var to := Vec2.new()
## The radius of a ball, in units of the plane.
var radius := 0.0
## Whether the ball is filled.
var is_filled := false
## The places through which a way goes, from [member from] to [member to].
var places: Array[Vec2] = []


## Words at a point of the plane.
static func note(at: Vec2) -> OwnMark:
	return _of(Shape.NOTE, at, at)


## An arrow between two points of the plane.
static func arrow(tail: Vec2, head: Vec2) -> OwnMark:
	return _of(Shape.ARROW, tail, head)


## A length between two points of the plane.
static func length(first: Vec2, last: Vec2) -> OwnMark:
	return _of(Shape.LENGTH, first, last)


## A ball.
static func ball(center: Vec2, its_radius: float, is_full: bool = false) -> OwnMark:
	var made := _of(Shape.BALL, center, center)
	made.radius = its_radius
	made.is_filled = is_full
	return made


## A way through [param through], which is not empty.
static func way(through: Array[Vec2]) -> OwnMark:
	var made := _of(Shape.WAY, through[0], through[-1])
	made.places = through
	return made


static func _of(its_shape: Shape, first: Vec2, last: Vec2) -> OwnMark:
	var made := OwnMark.new()
	made.shape = its_shape
	made.from = first.copy()
	made.to = last.copy()
	return made
