class_name Vec2
extends RefCounted
## A vector in the plane with two 64-bit components, in pixels, y downwards as in Godot.
##
## Verbs change the vector and return nothing ([method normalize]); nouns and participles leave it
## alone and return a value or a new vector ([method normalized]). A Vec2 is an object:
## [code]old = position[/code] shares it, [code]old = position.copy()[/code] does not.
## [br][br]
## Arithmetic is that of IEEE doubles: what is too large for a double becomes infinite, and what is
## computed from a component that is not finite means nothing; [method is_finite] tells.

## Between these bounds squares and products of lengths neither overflow nor lose digits.
const _SMALLEST_ORDINARY := 1.0 / 2.0 ** 400
const _LARGEST_ORDINARY := 2.0 ** 400

## How far the length of a normal handed to [method reflect] may be from 1.
const _NORMAL_TOLERANCE := 1e-9

## The horizontal component in pixels, to the right.
var x: float

## The vertical component in pixels, downwards.
var y: float


## Makes the vector (x_component, y_component), in pixels; without arguments the zero vector.
func _init(x_component: float = 0.0, y_component: float = 0.0) -> void:
	x = x_component
	y = y_component


## The text (3, 4) or (0.5, -1.25), short: at most six digits after the point. A component too
## large or too small for that is written as 1e+300, with all its digits.
func _to_string() -> String:
	return "(%s, %s)" % [_number_text(x), _number_text(y)]


## The zero vector, a new one at each call.
static func zero() -> Vec2:
	return Vec2.new()


## The vector of length 1 that points at [param angle] radians: 0 is right, PI / 2 is down.
static func unit_radians(angle: float) -> Vec2:
	return Vec2.new(cos(angle), sin(angle))


## The vector of length 1 that points at [param angle] degrees: 0 is right, 90 is down. Multiples
## of 90 give exact whole numbers, and large angles are as good as small ones.
static func unit_degrees(angle: float) -> Vec2:
	# Whole turns and quarter turns are taken off in degrees, where that is exact: pi is not a
	# double.
	var within_one_turn := fmod(angle, 360.0)
	var quarter_turns := roundf(within_one_turn / 90.0)
	var unit := unit_radians(deg_to_rad(within_one_turn - 90.0 * quarter_turns))
	for _quarter: int in posmod(int(quarter_turns), 4):
		unit.set_xy(-unit.y, unit.x)
	return unit


## A vector of length 1 in a random direction, every one of 2^32 evenly spread angles equally
## likely. A generator with a fixed seed gives the same directions again.
static func random_unit(rng: RandomNumberGenerator) -> Vec2:
	return unit_radians(TAU * rng.randi() / 2.0 ** 32)


## The Vec2 with the components of Godot's [param vector]; nothing is lost.
static func from_vector2(vector: Vector2) -> Vec2:
	return Vec2.new(vector.x, vector.y)


## Converts [param degrees] to radians.
static func deg_to_rad(degrees: float) -> float:
	return degrees * (PI / 180.0)


## Converts [param radians] to degrees.
static func rad_to_deg(radians: float) -> float:
	return radians * (180.0 / PI)


## Sets both components, in pixels.
func set_xy(x_component: float, y_component: float) -> void:
	x = x_component
	y = y_component


## Adds [param other]. Twin: [method plus].
func add(other: Vec2) -> void:
	x += other.x
	y += other.y


## Subtracts [param other]. Twin: [method minus].
func subtract(other: Vec2) -> void:
	x -= other.x
	y -= other.y


## Multiplies both components by [param factor]. Twin: [method scaled].
func scale(factor: float) -> void:
	x *= factor
	y *= factor


## Makes the length 1 (within 2 units in the last place) and keeps the direction, however short or
## long the vector is. A zero vector stays zero. Twin: [method normalized].
func normalize() -> void:
	var size := length()
	if not (size > _SMALLEST_ORDINARY and size < _LARGEST_ORDINARY):
		scale(_factor_to_about_one(x, y))
		size = length()
	if size != 0.0:
		x /= size
		y /= size


## Reflects this velocity off a line: v - (1 + C)(v . n) n with the normal n and the bounciness C
## (coefficient of restitution; 1 keeps the speed, 0 slides along the line). Both normals of the
## line give the same. A normal whose length is not 1 within 1e-9 and a bounciness outside 0..1
## are refused with an error, and the vector stays as it was. Twin: [method reflected].
func reflect(unit_normal: Vec2, bounciness: float = 1.0) -> void:
	if not _can_reflect(unit_normal, bounciness):
		return
	var change := (1.0 + bounciness) * dot(unit_normal)
	x -= change * unit_normal.x
	y -= change * unit_normal.y


## Rotates by [param angle] radians, from the x axis towards the y axis: clockwise on screen.
func rotate_radians(angle: float) -> void:
	_rotate(cos(angle), sin(angle))


## Rotates by [param angle] degrees, clockwise on screen; exactly for multiples of 90.
func rotate_degrees(angle: float) -> void:
	var unit := unit_degrees(angle)
	_rotate(unit.x, unit.y)


## Rotates this position around [param point] by [param angle] radians, clockwise on screen.
func rotate_around_radians(point: Vec2, angle: float) -> void:
	_rotate_around(point, cos(angle), sin(angle))


## Rotates this position around [param point] by [param angle] degrees, clockwise on screen.
func rotate_around_degrees(point: Vec2, angle: float) -> void:
	var unit := unit_degrees(angle)
	_rotate_around(point, unit.x, unit.y)


## Turns the vector to [param angle] radians and keeps its length. A zero vector stays zero.
func set_angle_radians(angle: float) -> void:
	var size := length()
	set_xy(size * cos(angle), size * sin(angle))


## Turns the vector to [param angle] degrees and keeps its length. A zero vector stays zero.
func set_angle_degrees(angle: float) -> void:
	var unit := unit_degrees(angle)
	var size := length()
	set_xy(size * unit.x, size * unit.y)


## Makes the length [param wanted] pixels and keeps the direction. A zero vector stays zero. A
## length that is negative or not finite is refused with an error, and the vector stays as it was.
func set_length(wanted: float) -> void:
	if not (wanted >= 0.0 and wanted < INF):
		push_error("Vec2.set_length: the length must be finite and 0 or more, but is %s." % wanted)
		return
	normalize()
	scale(wanted)


## Shortens the vector to [param maximum] pixels if it is longer. A negative maximum is refused
## with an error, and the vector stays as it was.
func limit_length(maximum: float) -> void:
	if not maximum >= 0.0:
		push_error("Vec2.limit_length: the maximum must be 0 or more, but is %s." % maximum)
	elif length() > maximum:
		set_length(maximum)


## A new vector with the same components.
func copy() -> Vec2:
	return Vec2.new(x, y)


## The sum of this vector and [param other]. Twin: [method add].
func plus(other: Vec2) -> Vec2:
	return Vec2.new(x + other.x, y + other.y)


## This vector less [param other]: the difference vector that leads from other to here. Twin:
## [method subtract].
func minus(other: Vec2) -> Vec2:
	return Vec2.new(x - other.x, y - other.y)


## This vector times [param factor]. Twin: [method scale].
func scaled(factor: float) -> Vec2:
	return Vec2.new(x * factor, y * factor)


## This vector divided by [param divisor]. A divisor of 0 is refused with an error, and the result
## is a copy.
func divided(divisor: float) -> Vec2:
	if divisor == 0.0:
		push_error("Vec2.divided: the divisor must not be 0; %s stays undivided." % self)
		return copy()
	return Vec2.new(x / divisor, y / divisor)


## The opposite vector.
func negated() -> Vec2:
	return Vec2.new(-x, -y)


## The vector of length 1 in the same direction; zero for a zero vector. Twin: [method normalize].
func normalized() -> Vec2:
	var unit := copy()
	unit.normalize()
	return unit


## The unit normal: (-y, x) divided by the length, which is 90 degrees clockwise on screen. Zero
## for a zero vector.
func normal() -> Vec2:
	var unit := normalized()
	unit.set_xy(-unit.y, unit.x)
	return unit


## This velocity reflected off a line; a copy where that is refused. Twin: [method reflect].
func reflected(unit_normal: Vec2, bounciness: float = 1.0) -> Vec2:
	var result := copy()
	result.reflect(unit_normal, bounciness)
	return result


## The shadow of this vector on the line along [param onto], which need not be a unit vector. Zero
## for a zero onto.
func vector_projection(onto: Vec2) -> Vec2:
	var squared := onto.length_squared()
	if not _are_ordinary(squared, length_squared()):
		return onto.normalized().scaled(scalar_projection(onto))
	var product := dot(onto)
	return Vec2.new(product * onto.x / squared, product * onto.y / squared)


## What [method vector_projection] leaves over: perpendicular to [param onto]. A copy for a zero
## onto.
func rejection(onto: Vec2) -> Vec2:
	if onto.x == 0.0 and onto.y == 0.0:
		return copy()
	var squared := onto.length_squared()
	if not _are_ordinary(squared, length_squared()):
		return vector_projection(onto.normal())
	var product := onto.cross(self)
	return Vec2.new(-product * onto.y / squared, product * onto.x / squared)


## The point on the way from here to [param to]: here for weight 0, exactly [param to] for weight
## 1. Other weights go on along the line.
func lerped(to: Vec2, weight: float) -> Vec2:
	# Starting from the nearer end makes both ends exact and never passes them.
	if weight < 0.5:
		return Vec2.new(x + (to.x - x) * weight, y + (to.y - y) * weight)
	var left := 1.0 - weight
	return Vec2.new(to.x - (to.x - x) * left, to.y - (to.y - y) * left)


## The point [param distance] pixels from here towards [param to], or [param to] if that is
## nearer. A negative distance is refused with an error, and the result is a copy.
func moved_toward(to: Vec2, distance: float) -> Vec2:
	if not distance >= 0.0:
		push_error("Vec2.moved_toward: the distance must be 0 or more, but is %s." % distance)
		return copy()
	var whole := distance_to(to)
	return to.copy() if whole <= distance else lerped(to, distance / whole)


## The length in pixels, for any finite components: infinite only if the length itself is too large
## for a double.
func length() -> float:
	var squared := x * x + y * y
	if squared > _SMALLEST_ORDINARY and squared < _LARGEST_ORDINARY:
		return sqrt(squared)
	return _extreme_length(x, y)


## The square of the length, x² + y², in square pixels. Overflows beyond a length of about 1e154.
func length_squared() -> float:
	return x * x + y * y


## The distance in pixels between the positions this vector and [param other], for any finite
## components: infinite only if the distance itself is too large for a double.
func distance_to(other: Vec2) -> float:
	var across := x - other.x
	var down := y - other.y
	var squared := across * across + down * down
	if squared > _SMALLEST_ORDINARY and squared < _LARGEST_ORDINARY:
		return sqrt(squared)
	return _extreme_length(across, down)


## The dot product x ox + y oy: positive if the angle between both is below 90 degrees, 0 at 90.
## Nothing is normalized; overflows where the products do.
func dot(other: Vec2) -> float:
	return x * other.x + y * other.y


## The determinant x oy - y ox: positive if [param other] is clockwise of this vector on screen.
## Overflows where the products do.
func cross(other: Vec2) -> float:
	return x * other.y - y * other.x


## The signed length in pixels of the shadow of this vector on [param onto], which need not be a
## unit vector: negative beyond 90 degrees. 0 for a zero onto.
func scalar_projection(onto: Vec2) -> float:
	var squared := onto.length_squared()
	if _are_ordinary(squared, x * x + y * y):
		# The dot product, without another call: that is a fifth of the run time.
		return (x * onto.x + y * onto.y) / sqrt(squared)
	var factor := _factor_to_about_one(x, y)
	return scaled(factor).dot(onto.normalized()) / factor


## The direction in radians, in (-PI, PI], clockwise on screen from the x axis. 0 for a zero
## vector.
func angle_radians() -> float:
	return _angle_of(x, y)


## The direction in degrees, in (-180, 180], clockwise on screen from the x axis. 0 for a zero
## vector.
func angle_degrees() -> float:
	return rad_to_deg(angle_radians())


## The signed angle in radians, in (-PI, PI], by which this vector must be rotated to point along
## [param other]. 0 if one of them is zero.
func angle_to(other: Vec2) -> float:
	var from := self
	var to := other
	if not _are_ordinary(from.length_squared(), to.length_squared()):
		from = scaled(_factor_to_about_one(x, y))
		to = other.scaled(_factor_to_about_one(other.x, other.y))
	return _angle_of(from.dot(to), from.cross(to))


## Whether both components differ from those of [param other] by at most [param tolerance] pixels.
## Never true where a component is NaN, nor for two infinite ones.
func equals_approx(other: Vec2, tolerance: float) -> bool:
	return absf(x - other.x) <= tolerance and absf(y - other.y) <= tolerance


## Whether neither component is infinite or NaN.
func is_finite() -> bool:
	return absf(x) < INF and absf(y) < INF


## Whether both components are within -[param largest]..[param largest]. False where one is NaN.
func is_within(largest: float) -> bool:
	return absf(x) <= largest and absf(y) <= largest


## Godot's vector with the components rounded to 32 bits: 7 digits are kept.
func to_vector2() -> Vector2:
	return Vector2(x, y)


static func _extreme_length(across: float, down: float) -> float:
	var factor := _factor_to_about_one(across, down)
	across *= factor
	down *= factor
	return sqrt(across * across + down * down) / factor


static func _angle_of(across: float, down: float) -> float:
	# Adding 0.0 turns -0.0 into 0.0; for a negative zero atan2 answers -0.0, -PI or PI.
	var angle := atan2(down + 0.0, across + 0.0)
	return PI if angle == -PI else angle


static func _are_ordinary(a: float, b: float) -> bool:
	return minf(a, b) > _SMALLEST_ORDINARY and maxf(a, b) < _LARGEST_ORDINARY


# The power of two that brings the larger component near 1. Multiplying by it loses no digit that
# matters beside that component.
static func _factor_to_about_one(across: float, down: float) -> float:
	var exponent := floorf(log(maxf(absf(across), absf(down))) / log(2.0))
	return pow(2.0, clampf(-exponent, -1000.0, 1000.0))


func _rotate(cosine: float, sine: float) -> void:
	set_xy(x * cosine - y * sine, x * sine + y * cosine)


func _rotate_around(point: Vec2, cosine: float, sine: float) -> void:
	# Kept apart, because the point may be this vector itself.
	var centre_x := point.x
	var centre_y := point.y
	set_xy(x - centre_x, y - centre_y)
	_rotate(cosine, sine)
	set_xy(x + centre_x, y + centre_y)


static func _can_reflect(unit_normal: Vec2, bounciness: float) -> bool:
	var size := unit_normal.length()
	if not absf(size - 1.0) <= _NORMAL_TOLERANCE:
		push_error("Vec2.reflect: the normal must have length 1, but has length %s." % size)
		return false
	if not (bounciness >= 0.0 and bounciness <= 1.0):
		push_error("Vec2.reflect: the bounciness must be within 0..1, but is %s." % bounciness)
		return false
	return true


static func _number_text(number: float) -> String:
	var size := absf(number)
	if size == 0.0 or (size >= 1e-4 and size < 1e15):
		return String.num(number + 0.0, 6).trim_suffix(".0")
	return String.num_scientific(number)
