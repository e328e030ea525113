class_name MyAim
extends RefCounted
## Your own aiming, with the methods of your [MyVec2]: in which direction must a shot go to hit? All
## directions that you give back have length 1.

## What [method MyAim.lead_time] gives back when no shot hits. The others give (0, 0) then.
const NO_SHOT := INF


## Exercise 13: after how many seconds the first shot hits a target that moves. [param place] is the
## way from you to the target, [param velocity] is the target's. The bullet flies with
## [param speed], which is above 0. [constant NO_SHOT] if the target gets away.
static func lead_time(place: MyVec2, velocity: MyVec2, speed: float) -> float:
	var a := velocity.dot(velocity) - speed * speed
	var b := 2.0 * place.dot(velocity)
	var c := place.dot(place)
	if a == 0.0:
		return -c / b if b < 0.0 else NO_SHOT
	var discriminant := b * b - 4.0 * a * c
	if discriminant < 0.0:
		return NO_SHOT
	var one := (-b - sqrt(discriminant)) / (2.0 * a)
	var other := (-b + sqrt(discriminant)) / (2.0 * a)
	if minf(one, other) >= 0.0:
		return minf(one, other)
	return maxf(one, other) if maxf(one, other) >= 0.0 else NO_SHOT


## Exercise 13: the direction of that shot.
static func lead(place: MyVec2, velocity: MyVec2, speed: float) -> MyVec2:
	var time := lead_time(place, velocity, speed)
	if time == NO_SHOT:
		return MyVec2.new(0.0, 0.0)
	return place.plus(velocity.scaled(time)).normalized()


## Exercise 14: the direction of the flat arc to a target that rests. [param place] is the way from
## you to the target. [param gravity] pulls down, so along y; it is above 0. (0, 0) if the target is
## out of reach.
static func flat_arc(place: MyVec2, gravity: float, speed: float) -> MyVec2:
	return _arc(place, gravity, speed, -1.0)


## Exercise 14: the same for the high arc.
static func high_arc(place: MyVec2, gravity: float, speed: float) -> MyVec2:
	return _arc(place, gravity, speed, 1.0)


## Exercise 15: the direction in which a ball starts that comes to [param target] after one bounce
## off the line. [param bounciness] is C, above 0. Start and target are on the same side of the
## line, and both are farther from it than [param radius].
static func bank(
	start: MyVec2,
	target: MyVec2,
	radius: float,
	bounciness: float,
	line_start: MyVec2,
	line_end: MyVec2
) -> MyVec2:
	var image := _image(start, target, radius, 1.0 + 1.0 / bounciness, line_start, line_end)
	return image.minus(start).normalized()


## Exercise 15: the same for a ball that bounces off the first line and then off the second one,
## with bounciness 1.
static func bank_twice(
	start: MyVec2,
	target: MyVec2,
	radius: float,
	first_start: MyVec2,
	first_end: MyVec2,
	second_start: MyVec2,
	second_end: MyVec2
) -> MyVec2:
	var image := _image(start, target, radius, 2.0, second_start, second_end)
	image = _image(start, image, radius, 2.0, first_start, first_end)
	return image.minus(start).normalized()


static func _arc(place: MyVec2, gravity: float, speed: float, sign_of_root: float) -> MyVec2:
	var b := speed * speed + gravity * place.y
	var c := gravity * place.length()
	var squared_time := 2.0 * (b + sign_of_root * sqrt(b * b - c * c)) / (gravity * gravity)
	return place.minus(MyVec2.new(0.0, gravity * squared_time / 2.0)).normalized()


static func _image(
	start: MyVec2, point: MyVec2, radius: float, factor: float, a: MyVec2, b: MyVec2
) -> MyVec2:
	var normal := b.minus(a).normal()
	if normal.dot(start.minus(a)) < 0.0:
		normal = normal.scaled(-1.0)
	var height := normal.dot(point.minus(a)) - radius
	return point.minus(normal.scaled(factor * height))
