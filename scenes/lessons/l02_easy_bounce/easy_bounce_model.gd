class_name EasyBounceModel
extends LessonModel
## A ball and a line that may be tilted. Two programs handle each frame: the easy one looks at one
## component alone, the right one uses the normal.
##
## The state is the ball in frame 0, after it has moved and before a program reacts. In the frames
## before it flies straight; the frames after are run by the programs. Velocities are in pixels per
## frame.

## The line is tilted by at most this, in degrees, to either side.
const STEEPEST := 45.0
## Pixels from the middle of the drawn line to its ends; for collisions it has no ends.
const HALF_LENGTH := 160.0
## How many frames are shown before frame 0; fewer where the ball would overlap the line there.
const FRAMES_BEFORE := 4
## How many frames are shown after frame 0.
const FRAMES_AFTER := 4
## The largest radius of the ball, in pixels.
const LARGEST_RADIUS := 200.0
## A difference of at most this share of the numbers that it comes from is rounding.
const ROUNDING := 1.0 / 2.0 ** 48

## The ball in frame 0, after its move; pixels, and pixels per frame.
var ball := Ball.new(Vec2.new(0.0, 4.0), 60.0, Vec2.new(20.0, 48.0))
## The middle of the line, about which it is tilted; in pixels.
var pivot := Vec2.new(0.0, 40.0)
## Degrees by which the line is turned clockwise from level (a wall: from upright), within
## -STEEPEST..STEEPEST.
var tilt_degrees := 0.0
## False: a floor below the ball. True: a wall to its right.
var is_wall := false

# Frames since frame 0; in slow motion a part of a frame counts, too.
var _elapsed := 0.0


## The line as it is drawn, with its normal on the side of the ball.
func line() -> LineSegment:
	var reach := along().scaled(HALF_LENGTH)
	return LineSegment.new(pivot.minus(reach), pivot.plus(reach))


## The unit vector along the line.
func along() -> Vec2:
	return Vec2.unit_degrees((90.0 if is_wall else 180.0) + tilt_degrees)


## The unit normal of the line, on the side of the ball.
func normal() -> Vec2:
	return along().normal()


## A floor without tilt, or a wall without: here the easy program is right.
func is_level() -> bool:
	return tilt_degrees == 0.0


## Where the easy program sees the line: the y of the floor right below [param point], or the x of
## the wall right beside it.
func line_at(point: Vec2) -> float:
	var slope := tan(Vec2.deg_to_rad(tilt_degrees))
	if is_wall:
		return pivot.x - (point.y - pivot.y) * slope
	return pivot.y + (point.x - pivot.x) * slope


## The distance that the easy program measures: straight down to the floor, or straight right to the
## wall; in pixels.
func straight_distance(point: Vec2) -> float:
	return line_at(point) - (point.x if is_wall else point.y)


## The point of the line that the easy program measures to.
func straight_foot(point: Vec2) -> Vec2:
	var at := line_at(point)
	return Vec2.new(at, point.y) if is_wall else Vec2.new(point.x, at)


## The right distance: the shortest one, along the perpendicular, in pixels; negative behind the
## line.
func shortest_distance(point: Vec2) -> float:
	return LineDistance.signed_distance(point.minus(pivot), line_at_origin())


## The vector to [param point] from L, the start of the line.
func from_line_start(point: Vec2) -> Vec2:
	return point.minus(pivot).plus(along().scaled(HALF_LENGTH))


## The line with its middle moved to the origin: far away its two ends would be the same point.
func line_at_origin() -> LineSegment:
	return LineSegment.new(Vec2.new(), along())


## The foot of the perpendicular from [param point] on the line.
func shortest_foot(point: Vec2) -> Vec2:
	return point.minus(normal().scaled(shortest_distance(point)))


## Pixels by which [param moved] has sunk in, along the normal; 0 where it does not touch the line.
func depth(moved: Ball) -> float:
	return maxf(moved.radius - shortest_distance(moved.position), 0.0)


## Whether the easy program takes [param moved] for a hit.
func easy_detects(moved: Ball) -> bool:
	if is_wall:
		return AxisBounce.hits_wall(moved, line_at(moved.position))
	return AxisBounce.hits_floor(moved, line_at(moved.position))


## Whether [param moved] is closer to the line than its radius, or behind it: a hit.
func right_detects(moved: Ball) -> bool:
	return shortest_distance(moved.position) < moved.radius


## Whether the easy program flips the velocity of [param moved]: in a hit, and only where the ball
## comes towards a level line.
func easy_flips(moved: Ball) -> bool:
	return easy_detects(moved) and (moved.velocity.x if is_wall else moved.velocity.y) > 0.0


## Whether the velocity of [param moved] is to be reflected: in a hit, and only where the ball comes
## towards the line.
func right_reflects(moved: Ball) -> bool:
	return right_detects(moved) and Bounce.is_approaching(moved.velocity, normal())


## Which component of the velocity changes its sign in the shown frame: 0 for x, 1 for y; -1 where
## none does, and on a tilted line, where that is not all that changes.
func flipped_component() -> int:
	if not is_level() or not right_reflects(moved_ball(frame())):
		return -1
	return 0 if is_wall else 1


## What the easy program makes of the ball [param moved]: detect, put back, flip.
func easy_result(moved: Ball) -> Ball:
	var result := moved.copy()
	if easy_detects(moved):
		if is_wall:
			AxisBounce.put_beside_wall(result, line_at(moved.position))
		else:
			AxisBounce.put_on_floor(result, line_at(moved.position))
	if easy_flips(moved):
		if is_wall:
			AxisBounce.flip_x(result)
		else:
			AxisBounce.flip_y(result)
	return result


## What the ball [param moved] should become: put back along the normal, velocity reflected.
func right_result(moved: Ball) -> Ball:
	var result := moved.copy()
	if right_detects(moved):
		result.position.add(normal().scaled(depth(moved)))
		Bounce.apply(result.velocity, normal())
	return result


## Pixels by which the easy distance of [param moved] differs from the exact shortest one, which is
## the projection of the difference vector on the line's normal, to about 100 bits.
func distance_error(moved: Ball) -> float:
	return exact_error(straight_distance(moved.position), moved.position)


## Pixels by which [param distance] differs from the exact distance of [param point].
func exact_error(distance: float, point: Vec2) -> float:
	var normal_of_any_length := Vec2.new(-along().y, along().x)
	return ExactProjection.error_of_scalar_projection(
		distance, point.minus(pivot), normal_of_any_length
	)


## Pixels between where the easy program puts [param moved] and where it belongs.
func position_error(moved: Ball) -> float:
	return easy_result(moved).position.distance_to(right_result(moved).position)


## Length of the difference of both velocities after the frame, in pixels per frame.
func velocity_error(moved: Ball) -> float:
	return easy_result(moved).velocity.distance_to(right_result(moved).velocity)


## Pixels between the balls of both programs at the end of this frame.
func distance_apart(in_frame: int) -> float:
	var easy := ball_after(in_frame, easy_result)
	return easy.position.distance_to(ball_after(in_frame, right_result).position)


## Whether both programs lead to the same ball in all frames that are shown, but for rounding.
func agrees() -> bool:
	for in_frame in range(FRAMES_AFTER + 1):
		if not is_rounding(distance_apart(in_frame), moved_ball(in_frame)):
			return false
	return true


## Whether [param difference] is nothing but rounding, as small as it is beside the numbers of
## [param moved] and the line.
func is_rounding(difference: float, moved: Ball) -> bool:
	var sizes := moved.position.length() + moved.velocity.length() + pivot.length() + moved.radius
	return absf(difference) <= ROUNDING * sizes


# The line.


## The tilt of the line when its start or, with [param is_start] false, its end is dragged to
## [param point]: whole degrees, within -STEEPEST..STEEPEST.
func tilt_toward(point: Vec2, is_start: bool) -> float:
	var direction := point.minus(pivot)
	if is_start:
		direction.scale(-1.0)
	var level := Vec2.unit_degrees(90.0 if is_wall else 180.0)
	var degrees := roundf(Vec2.rad_to_deg(level.angle_to(direction)))
	return clampf(degrees, -STEEPEST, STEEPEST)


## Makes a wall of the floor or a floor of the wall: x and y change places, so that the picture is
## mirrored and otherwise the same.
func swap_axes() -> void:
	is_wall = not is_wall
	tilt_degrees = -tilt_degrees
	for vector: Vec2 in [ball.position, ball.velocity, pivot]:
		vector.set_xy(vector.y, vector.x)


# The frames.


## The frame that is shown; 0 is the one in which [member ball] is.
func frame() -> int:
	return floori(_elapsed)


## Lets [param frames] pass, backwards if negative. After the last frame comes the first one.
func advance(frames: float) -> void:
	var count := float(FRAMES_AFTER + 1 - first_frame())
	_elapsed = first_frame() + fposmod(_elapsed + frames - first_frame(), count)


## Goes back to frame 0.
func rewind() -> void:
	_elapsed = 0.0


## The ball of the shown frame becomes the ball of frame 0: the student takes hold of it.
func take_hold() -> void:
	ball = moved_ball(frame())
	rewind()


## The first frame shown, 0 or below: as far back as the ball flies free.
func first_frame() -> int:
	for back in range(1, FRAMES_BEFORE + 1):
		if right_detects(_ball_in_flight(-back)):
			return 1 - back
	return -FRAMES_BEFORE


## The easy program's ball in this frame after its move, before it reacts.
func moved_ball(in_frame: int) -> Ball:
	if in_frame <= 0:
		return _ball_in_flight(in_frame)
	var moved := ball_after(in_frame - 1, easy_result)
	moved.position.add(moved.velocity)
	return moved


## The ball at the end of this frame, if each frame from 0 on is handled by [param program]:
## [method easy_result] or [method right_result].
func ball_after(in_frame: int, program: Callable) -> Ball:
	if in_frame < 0:
		return _ball_in_flight(in_frame)
	var current: Ball = program.call(ball)
	for i in in_frame:
		current.position.add(current.velocity)
		current = program.call(current)
	return current


func _ball_in_flight(in_frame: int) -> Ball:
	var there := ball.copy()
	there.position.add(ball.velocity.scaled(in_frame))
	return there


# The numbers.


## Takes the number that has this name in the formula and returns "", or returns its
## [method number_problem] and changes nothing. A place or velocity is that of the shown frame.
func enter(name_in_line: String, value: float) -> String:
	var problem := number_problem(name_in_line, value)
	if problem:
		return problem
	if is_of_moving_ball(name_in_line):
		take_hold()
	match name_in_line:
		"px":
			ball.position.x = value
		"py":
			ball.position.y = value
		"vx":
			ball.velocity.x = value
		"vy":
			ball.velocity.y = value
		"r":
			ball.radius = value
		"tilt":
			tilt_degrees = value
	return ""


## Whether the number with this name changes from frame to frame.
static func is_of_moving_ball(name_in_line: String) -> bool:
	return name_in_line in ["px", "py", "vx", "vy"]


## "" if the number that has this name in the formula may have this value; else a sentence with the
## value and what is allowed, translated.
static func number_problem(name_in_line: String, value: float) -> String:
	var text := NumberText.short(value)
	if name_in_line == "r" and not (value > 0.0 and value <= LARGEST_RADIUS):
		return TranslationServer.translate("r must be above 0 and at most 200, not %s.") % text
	if name_in_line == "tilt" and not absf(value) <= STEEPEST:
		var sentence := LabText.translate("The tilt must be within −45° and 45°, not %s.")
		return Conventions.in_unit(sentence % Conventions.angle_text(value))
	return ""


## All of it but the frame that is shown, for undo and links.
func to_dictionary() -> Dictionary:
	return {
		"ball":
		PackedFloat64Array(
			[ball.position.x, ball.position.y, ball.velocity.x, ball.velocity.y, ball.radius]
		),
		"pivot": PackedFloat64Array([pivot.x, pivot.y]),
		"tilt_degrees": tilt_degrees,
		"is_wall": is_wall,
	}


## "" if radius and tilt are in their ranges; else a sentence from [method number_problem].
func problem_in(stored: Dictionary) -> String:
	var numbers: PackedFloat64Array = stored["ball"]
	var tilt: float = stored["tilt_degrees"]
	return StateCheck.first([number_problem("r", numbers[4]), number_problem("tilt", tilt)])


## Puts back what [method to_dictionary] has told, and goes to frame 0.
func from_dictionary(stored: Dictionary) -> void:
	var numbers: PackedFloat64Array = stored["ball"]
	var middle: PackedFloat64Array = stored["pivot"]
	var velocity := Vec2.new(numbers[2], numbers[3])
	ball = Ball.new(Vec2.new(numbers[0], numbers[1]), numbers[4], velocity)
	pivot.set_xy(middle[0], middle[1])
	tilt_degrees = stored["tilt_degrees"]
	is_wall = stored["is_wall"]
	rewind()
