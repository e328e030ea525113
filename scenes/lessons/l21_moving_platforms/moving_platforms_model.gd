class_name MovingPlatformsModel
extends LessonModel
## A ball and a surface that moves: a wall, a belt, a platform that goes to and fro, a paddle that
## turns, a press. What comes out, by closed formulas.
##
## Pixels, seconds, y points down; gravity, where a ball lies on something, is
## [constant GRAVITY].

## How the explanation is built up.
enum Step { WATCH, FRAME, LAW, BACK, FLY }

## In px/s²; only where a ball lies on a belt or a platform.
const GRAVITY := 600.0
## The platform is so long, in pixels, and lies so at the start, its middle above the origin.
const PLATFORM_LENGTH := 200.0
## How high the walls of the press are, in pixels.
const PRESS_HEIGHT := 120.0
## The bounce of the press that the formulas are about.
const PRESS_BOUNCE := 3.0

## What moves.
var kind := MovingSurface.Kind.WALL
## The ball's centre at the start. On a belt it lies above the nearest point.
var ball := Vec2.new(200.0, -100.0)
## v: its velocity at the start, in px/s, where it flies to a wall or paddle.
var velocity := Vec2.new(-200.0, 100.0)
## The wall or the belt at the start leads from here, ... The paddle turns about this point.
var surface_start := Vec2.new(-120.0, -120.0)
## ... to here.
var surface_end := Vec2.new(-120.0, 120.0)
## w: the velocity of the wall, in px/s.
var surface_velocity := Vec2.new(100.0, 0.0)
## ω: how fast the paddle turns, in radians per second, clockwise on screen.
var turning := 2.0
## C: the bounciness, 0..1.
var bounciness := 1.0
## The speed at the start along a belt, or away from the moving wall of the press, in px/s.
var speed := 0.0
## s or V: the speed of the belt, of the platform, of the wall of the press, in px/s.
var surface_speed := 90.0
## µ between ball and belt or platform; 0 or more.
var friction := 0.05
## How far the platform goes before it turns back; what is free for the ball in the press; in
## pixels.
var way := 180.0
## Whether the board shows everything as the surface sees it.
var from_surface := false
## The mistake that is switched on, by its number in [MovingPlatformsMistakes]; 0 for none.
var mistake := 0

# What was found for these numbers.
var _solved_for: Array = []
var _impact: SurfaceImpact
var _run: CarriedRun


## Whether a ball flies to a surface that moves or turns.
func is_impact() -> bool:
	return kind in [MovingSurface.Kind.WALL, MovingSurface.Kind.PADDLE]


## Whether a disc lies on a surface.
func is_carried() -> bool:
	return kind in [MovingSurface.Kind.BELT, MovingSurface.Kind.PLATFORM]


## The arrows of velocities show so many seconds of them.
func arrow_seconds() -> float:
	if kind == MovingSurface.Kind.PRESS:
		return 0.25
	return 1.0 if is_carried() else 0.5


## The ball at the start.
func first_ball() -> Ball:
	return Ball.new(place_at(0.0), MovingSurface.RADIUS, first_velocity())


## Its velocity at the start, in px/s.
func first_velocity() -> Vec2:
	if is_impact():
		return velocity.copy()
	return along().scaled(surface_speed if kind == MovingSurface.Kind.PLATFORM else speed)


## The surface at the start.
func first_surface() -> LineSegment:
	match kind:
		MovingSurface.Kind.PLATFORM:
			var half := 0.5 * PLATFORM_LENGTH
			var left := -0.5 * way
			return LineSegment.new(
				Vec2.new(left - half, MovingSurface.RADIUS),
				Vec2.new(left + half, MovingSurface.RADIUS)
			)
		MovingSurface.Kind.PRESS:
			return _press_wall(-0.5 * way - MovingSurface.RADIUS)
	return LineSegment.new(surface_start, surface_end)


## The wall of the press that rests.
func far_wall() -> LineSegment:
	return _press_wall(0.5 * way + MovingSurface.RADIUS)


static func _press_wall(x: float) -> LineSegment:
	return LineSegment.new(Vec2.new(x, -0.5 * PRESS_HEIGHT), Vec2.new(x, 0.5 * PRESS_HEIGHT))


## The direction in which speeds along a line count; length 1.
func along() -> Vec2:
	if kind == MovingSurface.Kind.BELT:
		return surface_end.minus(surface_start).normalized()
	return Vec2.new(1.0, 0.0)


## From a belt or platform to the ball; length 1.
func up() -> Vec2:
	return along().normal().negated()


## Where on the belt or platform the disc lies at the start, in pixels from its left end.
func distance() -> float:
	if kind == MovingSurface.Kind.PLATFORM:
		return 0.5 * PLATFORM_LENGTH
	var belt := first_surface()
	return clampf(belt.share_of(ball), 0.0, 1.0) * belt.length()


## The wall or paddle as it moves.
func moving() -> TurningSegment:
	if kind == MovingSurface.Kind.PADDLE:
		return TurningSegment.new(first_surface(), surface_start, turning)
	return TurningSegment.new(first_surface(), surface_start, 0.0, surface_velocity)


## The line on which a disc lies, as the surface sees it; the belt runs.
func incline() -> Incline:
	var belt := surface_speed if kind == MovingSurface.Kind.BELT else 0.0
	return Incline.new(first_surface(), Vec2.new(0.0, GRAVITY), friction, belt)


## The impact with a wall or paddle, or the first one with the moving wall of the press; null where
## a disc lies on something.
func impact() -> SurfaceImpact:
	_solve()
	return _impact


## How long the ball flies on after an impact with a wall or paddle until it is met again, in
## seconds; INF if it is not, within [constant SurfaceImpact.LONGEST].
func time_to_next_impact() -> float:
	var surface := moving().segment_at(impact().time)
	var now := TurningSegment.new(surface, surface.start, moving().turn, moving().velocity)
	var leaves := Ball.new(impact().center, MovingSurface.RADIUS, impact().leaving)
	var next := SurfaceImpact.of(leaves, now, bounciness)
	return next.time if next.hit else INF


## The disc on the belt; or on the platform, from where that turns back, as the platform sees it.
## Null for the other kinds.
func run() -> CarriedRun:
	_solve()
	return _run


## When the platform turns back, in seconds.
func turn_time() -> float:
	return way / surface_speed


## How fast the ball rolls at last, in px/s, as the lab sees it: on a belt and on the platform.
func rolling_speed() -> float:
	return run().roll_speed - (surface_speed if kind == MovingSurface.Kind.PLATFORM else 0.0)


## How far the platform is to the right of its start after so many seconds, in pixels, until it is
## back.
func platform_way(seconds: float) -> float:
	return surface_speed * minf(seconds, 2.0 * turn_time() - seconds)


## When the moving wall of the press is hit for the time number [param bounce], in seconds.
func press_time(bounce: float) -> float:
	return (way - Press.way_after(bounce, way, speed, surface_speed)) / surface_speed


## When the ball is crushed, in seconds.
func crush_time() -> float:
	return way / surface_speed


## Where the ball's centre is after so many seconds, by the formulas.
func place_at(seconds: float) -> Vec2:
	match kind:
		MovingSurface.Kind.BELT:
			return _above(first_surface().start, run().after(seconds).distance)
		MovingSurface.Kind.PLATFORM:
			var left := first_surface().start
			left.x += platform_way(seconds)
			var since := seconds - turn_time()
			return _above(left, run().after(since).distance if since > 0.0 else distance())
		MovingSurface.Kind.PRESS:
			return _place_in_press(seconds)
	var met := impact()
	if not met.hit or seconds <= met.time:
		return ball.plus(velocity.scaled(seconds))
	return met.center.plus(met.leaving.scaled(seconds - met.time))


func _above(start: Vec2, distance_along: float) -> Vec2:
	return start.plus(along().scaled(distance_along)).plus(up().scaled(MovingSurface.RADIUS))


func _place_in_press(seconds: float) -> Vec2:
	var press := Press.at(seconds, way, speed, surface_speed)
	# What is crushed stays where it was last.
	var from_far_wall := 0.0 if press.is_crushed else press.distance
	return Vec2.new(0.5 * way - from_far_wall, 0.0)


## v′ by the mistake that is switched on, in px/s; for an impact, with a hit.
func wrong_velocity() -> Vec2:
	var tip := moving().velocity_at(surface_end_at(impact().time).minus(surface_start))
	return MovingPlatformsMistakes.velocity(mistake, impact(), bounciness, tip)


## Where the far end of the wall or paddle is after so many seconds.
func surface_end_at(seconds: float) -> Vec2:
	return moving().segment_at(seconds).end


## The ball's speed by the mistake, in px/s: at last on a belt or platform, after the bounce number
## [constant PRESS_BOUNCE] in a press.
func wrong_speed() -> float:
	if kind == MovingSurface.Kind.PRESS:
		return MovingPlatformsMistakes.press_speed(mistake, speed, surface_speed, PRESS_BOUNCE)
	return surface_speed if kind == MovingSurface.Kind.BELT else -surface_speed


## Whether the mistake that is switched on makes something else of this state.
func mistake_shows() -> bool:
	match mistake:
		0:
			return false
		MovingPlatformsMistakes.BELT_SPEED:
			return is_carried() and run().run_case == CarriedRun.Case.ROLLS_LATER
		MovingPlatformsMistakes.FRAME_LATE:
			return kind == MovingSurface.Kind.PLATFORM
	if kind == MovingSurface.Kind.PRESS:
		return absf(wrong_speed() - _press_speed()) > 0.0
	if not is_impact() or not impact().hit:
		return false
	var right := impact().leaving
	return wrong_velocity().distance_to(right) > 1e-9 * (right.length() + impact().seen.length())


func _press_speed() -> float:
	return Press.speed_after(PRESS_BOUNCE, speed, surface_speed)


## Where the mistake changes nothing, the start of a kind is taken in which it does.
func show_mistake(_number: int) -> void:
	for other: Dictionary in (
		MovingPlatformsPresets.OF_KIND + [MovingPlatformsPresets.ALL["C = 0.5"]]
	):
		if mistake != 0 and not mistake_shows():
			Refusal.push(take(other))


## Takes a typed number by its name in the formula. "" if it could be taken; else one sentence with
## the value and what is allowed, and nothing changes.
func enter(name_in_line: String, value: float) -> String:
	var places: Dictionary[String, Array] = {
		"px": ["ball", 0],
		"py": ["ball", 1],
		"vx": ["velocity", 0],
		"vy": ["velocity", 1],
		"ax": ["surface", 0],
		"ay": ["surface", 1],
		"bx": ["surface", 2],
		"by": ["surface", 3],
		"wx": ["surface_velocity", 0],
		"wy": ["surface_velocity", 1],
	}
	if not places.has(name_in_line):
		return take({name_in_line: value})
	var key: String = places[name_in_line][0]
	var at: int = places[name_in_line][1]
	var list: PackedFloat64Array = to_dictionary()[key]
	list[at] = value
	return take({key: list})


func to_dictionary() -> Dictionary:
	var ends := [surface_start.x, surface_start.y, surface_end.x, surface_end.y]
	return {
		"kind": int(kind),
		"ball": PackedFloat64Array([ball.x, ball.y]),
		"velocity": PackedFloat64Array([velocity.x, velocity.y]),
		"surface": PackedFloat64Array(ends),
		"surface_velocity": PackedFloat64Array([surface_velocity.x, surface_velocity.y]),
		"turning": turning,
		"bounciness": bounciness,
		"speed": speed,
		"surface_speed": surface_speed,
		"friction": friction,
		"way": way,
		"from_surface": from_surface,
		"mistake": mistake,
	}


# A link that names a kind alone opens it as it starts.
func link_base(first: Dictionary, wanted: Dictionary) -> Dictionary:
	var named: int = wanted["kind"]
	if named == first["kind"]:
		return first
	var base := MovingPlatformsModel.new()
	base.from_dictionary(first)
	var last := MovingPlatformsPresets.OF_KIND.size() - 1
	Refusal.push(base.take(MovingPlatformsPresets.OF_KIND[clampi(named, 0, last)]))
	# The link has to name the kind itself.
	return base.to_dictionary().merged({"kind": first["kind"]}, true)


func problem_in(stored: Dictionary) -> String:
	return MovingPlatformsCheck.problem_in(stored)


func from_dictionary(stored: Dictionary) -> void:
	var ends: PackedFloat64Array = stored["surface"]
	kind = stored["kind"]
	_put(ball, stored["ball"])
	_put(velocity, stored["velocity"])
	surface_start.set_xy(ends[0], ends[1])
	surface_end.set_xy(ends[2], ends[3])
	_put(surface_velocity, stored["surface_velocity"])
	turning = stored["turning"]
	bounciness = stored["bounciness"]
	speed = stored["speed"]
	surface_speed = stored["surface_speed"]
	friction = stored["friction"]
	way = stored["way"]
	from_surface = stored["from_surface"]
	mistake = stored["mistake"]


static func _put(into: Vec2, stored: Variant) -> void:
	var pair: PackedFloat64Array = stored
	into.set_xy(pair[0], pair[1])


# Once for the numbers as they are.
func _solve() -> void:
	var numbers := to_dictionary().values()
	if numbers == _solved_for:
		return
	_solved_for = numbers
	_impact = null
	_run = null
	match kind:
		MovingSurface.Kind.BELT:
			_run = CarriedRun.new(incline(), friction, distance(), speed)
		MovingSurface.Kind.PLATFORM:
			# The platform turns back at once: seen from it the disc then moves with 2 V.
			_run = CarriedRun.new(incline(), friction, distance(), 2.0 * surface_speed)
		MovingSurface.Kind.PRESS:
			_impact = _first_bounce_in_press()
		_:
			_impact = SurfaceImpact.of(
				Ball.new(ball, MovingSurface.RADIUS, velocity), moving(), bounciness
			)


func _first_bounce_in_press() -> SurfaceImpact:
	var at := press_time(1.0)
	var to_right := Vec2.new(1.0, 0.0)
	return SurfaceImpact.known(
		at,
		Vec2.new(-0.5 * way + surface_speed * at, 0.0),
		to_right,
		Vec2.new(-speed, 0.0),
		Vec2.new(surface_speed, 0.0),
		1.0
	)
