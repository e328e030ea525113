class_name SlideAndRollModel
extends LessonModel
## A ball that slips or rolls down a line, or along a level one, with friction; and two more with
## which it races: one without friction, and one that rolls from the start.
##
## All motion comes from [method incline], by [RacingBall].

## How the explanation is built up.
enum Step { SLIDE, PULL, SLIP, MARK, ROLL, RACE, ERROR }
## What becomes of the ball: nothing moves it; it rolls at once; it slips and then rolls; it would
## roll, but the line ends before; it slips all the way.
enum Case { RESTS, ROLLS, ROLLS_LATER, ENDS_BEFORE, SLIPS }

const _SLOPE_START: PackedFloat64Array = [-48.0, -36.0]
const _SLOPE_END: PackedFloat64Array = [48.0, 36.0]
## Presets by their titles (source text): what each changes in the model's state.
const PRESETS: Dictionary[String, Dictionary] = {
	"Rolls":
	{
		start = _SLOPE_START,
		end = _SLOPE_END,
		friction = 0.4,
		speed = 0.0,
		gravity = 600.0,
		radius = 10.0
	},
	"At the mark":
	{
		start = _SLOPE_START,
		end = _SLOPE_END,
		friction = 0.25,
		speed = 0.0,
		gravity = 600.0,
		radius = 10.0
	},
	"Slips":
	{
		start = _SLOPE_START,
		end = _SLOPE_END,
		friction = 0.125,
		speed = 0.0,
		gravity = 600.0,
		radius = 10.0
	},
	"Pushed":
	{
		start = _SLOPE_START,
		end = _SLOPE_END,
		friction = 0.5,
		speed = 90.0,
		gravity = 600.0,
		radius = 10.0
	},
	"Level":
	{
		start = [-187.5, 0.0],
		end = [187.5, 0.0],
		friction = 0.2,
		speed = 300.0,
		gravity = 600.0,
		radius = 15.0
	},
	"Too short":
	{
		start = [-60.0, 0.0],
		end = [60.0, 0.0],
		friction = 0.2,
		speed = 300.0,
		gravity = 600.0,
		radius = 10.0
	},
}

## No place has a component larger than this, and no speed or gravity is larger.
const LARGEST := 1e6
## No line is shorter than this, in pixels.
const SHORTEST := 1.0
## The smallest speed above 0, in px/s.
const SLOWEST := 1e-3
## The smallest gravity, in px/s².
const LEAST_GRAVITY := 1e-3
## The largest friction µ.
const MOST_FRICTION := 10.0
## The smallest and the largest radius, in pixels.
const SMALLEST_RADIUS := 0.1
const LARGEST_RADIUS := 1e4
# How sentences on what is wrong call a number.
const _SYMBOLS: Dictionary[String, String] = {"friction": "µ", "gravity": "g", "radius": "r"}
# Two ways that differ by less than this share of the line are one.
const _SAME_WAY := 1e-9

## The line leads from here, in pixels, ...
var start := Vec2.new(-48.0, -36.0)
## ... to here: to the right, and down or level.
var end := Vec2.new(48.0, 36.0)
## The friction µ between ball and line; 0 or more.
var friction := 0.4
## The ball's speed v₀ along the line at the start, in px/s; 0 or more. It does not turn then.
var speed := 0.0
## Gravity g, downwards, in px/s²; above 0.
var gravity := 600.0
## The radius r of all balls, in pixels.
var radius := 10.0
## The mistake that is switched on, by its number in [SlideAndRollMistakes]; 0 for none.
var mistake := 0
## Whether Godot's own body runs beside.
var has_engine := false
## Seconds since the start. No part of the state: it is played, not kept.
var time := 0.0


## The line.
func segment() -> LineSegment:
	return LineSegment.new(start, end)


## The line with the friction [param with_friction].
func incline(with_friction: float) -> Incline:
	return Incline.new(segment(), Vec2.new(0.0, gravity), with_friction)


## The direction from the line to the balls on it; length 1.
func up() -> Vec2:
	return segment().along().normal().negated()


## Where the centre of a ball is that has come [param distance] pixels along the line.
func center_at(distance: float) -> Vec2:
	var share := distance / segment().length()
	return start.lerped(end, share).plus(up().scaled(radius))


## The ball with the friction µ.
func ball() -> RacingBall:
	return RacingBall.new(incline(friction), radius, speed, 0.0)


## A ball without friction.
func sliding_ball() -> RacingBall:
	return RacingBall.new(incline(0.0), radius, speed, 0.0)


## A ball with enough friction that rolls from the start.
func rolling_ball() -> RacingBall:
	return RacingBall.new(incline(slope() + 1.0), radius, speed, speed / radius)


## The way of a ball by the mistake with this number; null for none.
func wrong_run(number: int) -> WrongRun:
	var given := incline(friction)
	return SlideAndRollMistakes.run(number, speed, given.pull, given.pressure, friction)


## How far the line leads to the right, w, in pixels; above 0.
func width() -> float:
	return end.x - start.x


## How far it falls, h, in pixels; 0 where it is level.
func height() -> float:
	return end.y - start.y


## The tangent of the angle of the line: h / w.
func slope() -> float:
	return height() / width()


## From this µ on the ball rolls: a third of [method slope].
func mark() -> float:
	return slope() / Friction.YIELD


## By how much the slip of a ball that slips forward grows each second, in px/s²: G - 3 µ N.
func slip_growth() -> float:
	var given := incline(friction)
	return given.pull - Friction.YIELD * friction * given.pressure


## Which of the cases this is. It takes what [method ball] has found.
func run_case(of_ball: RacingBall) -> Case:
	if height() == 0.0 and speed == 0.0:
		return Case.RESTS
	if of_ball.roll_time == 0.0:
		return Case.ROLLS
	if of_ball.roll_time > 0.0:
		return Case.ROLLS_LATER
	return Case.ENDS_BEFORE if slip_growth() < 0.0 else Case.SLIPS


## Its acceleration when it comes to the end, in px/s²: two thirds of the pull where it rolls.
func last_acceleration(of_case: Case) -> float:
	var given := incline(friction)
	if of_case in [Case.ROLLS, Case.ROLLS_LATER]:
		return given.pull - given.pull / Friction.YIELD
	return 0.0 if of_case == Case.RESTS else given.pull - friction * given.pressure


## How late [param seconds] is for the end of the line, in seconds; only for a ball that comes
## there.
func error_of_end(seconds: float, of_ball: RacingBall) -> float:
	var exact := ExactIncline.new(segment(), gravity, friction, speed)
	return exact.error_of(seconds, of_ball.roll_time >= 0.0)


## Whether the mistake that is switched on lets the ball be elsewhere than it is when it comes to
## the end.
func shows_mistake() -> bool:
	var wrong := wrong_run(mistake)
	var right := ball()
	if not wrong or run_case(right) == Case.RESTS:
		return false
	var length := segment().length()
	return absf(wrong.distance_after(right.end_time) - length) > _SAME_WAY * length


## Switches a mistake on. Where it changes nothing, a preset is taken in which it does.
func show_mistake(number: int) -> void:
	mistake = number
	for preset: String in ["Rolls", "Level"]:
		if number != 0 and not shows_mistake():
			Refusal.push(take(PRESETS[preset]))


## Takes a typed number by its name in the formula. "" if it could be taken; else one sentence with
## the value and what is allowed, and nothing changes.
func enter(name_in_line: String, value: float) -> String:
	if name_in_line in ["friction", "speed", "gravity", "radius"]:
		return take({name_in_line: value})
	var key := "start" if name_in_line[0] == "A" else "end"
	var place := (start if key == "start" else end).copy()
	place.set(name_in_line[1], value)
	return take({key: PackedFloat64Array([place.x, place.y])})


func to_dictionary() -> Dictionary:
	return {
		"start": PackedFloat64Array([start.x, start.y]),
		"end": PackedFloat64Array([end.x, end.y]),
		"friction": friction,
		"speed": speed,
		"gravity": gravity,
		"radius": radius,
		"mistake": mistake,
		"has_engine": has_engine,
	}


func problem_in(stored: Dictionary) -> String:
	var problems: PackedStringArray = []
	var from: PackedFloat64Array = stored["start"]
	var to: PackedFloat64Array = stored["end"]
	for number in from:
		problems.append(StateCheck.within("start", number, -LARGEST, LARGEST))
	for number in to:
		problems.append(StateCheck.within("end", number, -LARGEST, LARGEST))
	problems.append(_problem_of_line(from, to))
	var limits: Dictionary[String, PackedFloat64Array] = {
		"friction": [0.0, MOST_FRICTION],
		"gravity": [LEAST_GRAVITY, LARGEST],
		"radius": [SMALLEST_RADIUS, LARGEST_RADIUS],
	}
	for key in limits:
		var number: float = stored[key]
		var limit := limits[key]
		problems.append(StateCheck.within(_SYMBOLS[key], number, limit[0], limit[1]))
	var wanted_speed: float = stored["speed"]
	problems.append(_problem_of_speed(wanted_speed))
	var wanted_mistake: int = stored["mistake"]
	problems.append(StateCheck.mistake(wanted_mistake, SlideAndRollMistakes.infos()))
	return StateCheck.first(problems)


func from_dictionary(stored: Dictionary) -> void:
	_put(start, stored["start"])
	_put(end, stored["end"])
	friction = stored["friction"]
	speed = stored["speed"]
	gravity = stored["gravity"]
	radius = stored["radius"]
	mistake = stored["mistake"]
	has_engine = stored["has_engine"]


# A line that climbs, or that nothing presses on, is not of this lesson.
static func _problem_of_line(from: PackedFloat64Array, to: PackedFloat64Array) -> String:
	if to[0] - from[0] >= SHORTEST and to[1] >= from[1]:
		return ""
	var sentence := LabText.translate(
		"The line must lead at least %s px to the right and not climb: from %s to %s it does not."
	)
	var pairs := [NumberText.pair(from[0], from[1], 9), NumberText.pair(to[0], to[1], 9)]
	return sentence % [NumberText.short(SHORTEST), pairs[0], pairs[1]]


static func _problem_of_speed(wanted: float) -> String:
	if wanted == 0.0 or wanted >= SLOWEST and wanted <= LARGEST:
		return ""
	var sentence := LabText.translate("v₀ must be 0, or within %s..%s, not %s.")
	return sentence % [SLOWEST, LARGEST, wanted].map(NumberText.short)


static func _put(into: Vec2, stored: Variant) -> void:
	var pair: PackedFloat64Array = stored
	into.set_xy(pair[0], pair[1])
