class_name AngledLinesModel
extends LessonModel
## The lesson on angled lines: a world that is stepped, its past, and the same world with a mistake
## where one is switched on.
##
## A method that takes what a student enters returns "", or one sentence on why it was refused; then
## nothing has changed.

## A frame of the course, in seconds.
const FRAME := 1.0 / 60.0
## How many frames the forecast looks ahead.
const FORECAST_FRAMES := 90
## The gravity that an arrow key gives where there was none, in pixels per second squared.
const USUAL_GRAVITY := 300.0
# The bouncinesses that a key goes through.
const _USUAL_BOUNCINESSES: Array[float] = [1.0, 0.8, 0.5, 0.0]

## The world without a mistake, as right as [member method] is.
var world := SteppedWorld.new(WholeFrameMover.new())
## The world with the mistake; null while none is switched on.
var wrong_world: SteppedWorld
## How a frame is stepped.
var method := SteppingMethods.Method.WHOLE_FRAME
## Whether the lines are those of the lecture's week 4: endless, with one good side. They are known
## by position reset only, and no mistake is shown beside them.
var has_endless_lines := false
## The number of the mistake that is switched on; 0 for none.
var mistake := 0
## The preset that was picked last, 0 to 10.
var preset := 0
## The place of the ball that can be dragged and typed.
var selected := 0
## The latest bounce of the selected ball; null before it.
var last_bounce: BounceRecord
## Goes to any moment, in the event world; null in the other ways of stepping.
var timeline: EventTimeline
## What the latest step, forward or back, was refused with; "" if it was not.
var refusal := ""

# What preset 0 puts up.
var _first: SteppedWorld

var _history := StepHistory.new()
var _starts := BallStarts.new()
var _first_energy := 0.0


## Begins with a copy of [param first] as preset 0; without it, with the course's assignment.
func _init(first: SteppedWorld = AngledLinesPresets.world_of(0)) -> void:
	_first = first
	set_up(0)


## Puts up a preset, 0 to 10, with its kind of line. The method and the mistake stay where they can
## be with that kind.
func set_up(number: int) -> void:
	preset = number
	_put_up(
		_first if number == 0 else AngledLinesPresets.world_of(number),
		number == AngledLinesPresets.WEEK_4
	)


## Puts up a copy of [param other], such as the world of a question, with lines that end.
func put_up(other: SteppedWorld) -> void:
	_put_up(other, false)


func _put_up(other: SteppedWorld, with_endless_lines: bool) -> void:
	selected = 0
	world = other.copy()
	_starts.take(world)
	has_endless_lines = with_endless_lines
	_begin()


## Switches to the way of stepping [param new_method]. A mistake is switched off where there is no
## right way beside it; see [method AngledLinesMistakes.can_be_beside]. Refused where the way does
## not know the kind of line.
func set_method(new_method: SteppingMethods.Method) -> String:
	var problem := AngledLinesLink.problem_of_kind(has_endless_lines, new_method)
	if not problem:
		method = new_method
		_begin()
	return problem


## Takes endless lines or lines that end. Endless ones bring the way that knows them along.
func set_endless_lines(on: bool) -> void:
	has_endless_lines = on
	_begin()


## Switches a mistake on and puts up a preset that shows it; 0 switches it off.
func set_mistake(number: int) -> void:
	mistake = number
	if number:
		method = SteppingMethods.Method.WHOLE_FRAME
		set_up(AngledLinesMistakes.PRESETS[number])
	else:
		_begin()


## One frame on; see [member refusal].
func step() -> void:
	if timeline:
		refusal = go_to(timeline.time + FRAME)
		return
	_history.remember(_worlds())
	refusal = ""
	for some in _worlds():
		var problem := some.step(FRAME)
		refusal = refusal if refusal else problem
	for record in world.latest_bounces:
		if record.ball_index == selected:
			last_bounce = record


## One frame back, to the last bit; see [member refusal]. False where nothing older is known.
func step_back() -> bool:
	refusal = ""
	if timeline:
		var has_past := timeline.time > 0.0
		refusal = go_to(maxf(timeline.time - FRAME, 0.0))
		return has_past
	last_bounce = null
	return _history.go_back(_worlds())


## Goes to a moment of the [member timeline], in seconds since its start.
func go_to(seconds: float) -> String:
	var problem := timeline.go_to(seconds)
	last_bounce = timeline.last_bounce(selected)
	return problem


## Seconds that have passed in the world.
func elapsed_seconds() -> float:
	return timeline.elapsed_seconds() if timeline else world.frames * FRAME


## Energy now as a share of the energy at the start: of [member world], or of [member wrong_world].
## NaN where there was none, or where a ball has taken its energy along.
func energy_share(of_world: SteppedWorld) -> float:
	if of_world.lost_count() > 0 or _first_energy <= 0.0:
		return NAN
	return of_world.energy() / _first_energy


## Takes gravity in pixels per second squared.
func set_gravity(gravity: Vec2) -> String:
	var problem := world.surroundings.set_gravity(gravity)
	if not problem:
		_begin()
	return problem


## Gravity along [param direction] as strong as it was, or as usual where there was none.
func point_gravity(direction: Vec2) -> String:
	var strength := world.surroundings.gravity.length()
	return set_gravity(direction.scaled(strength if strength > 0.0 else USUAL_GRAVITY))


## Takes the next of the usual bouncinesses.
func take_next_bounciness() -> String:
	var place := _USUAL_BOUNCINESSES.find(world.surroundings.bounciness)
	return set_bounciness(_USUAL_BOUNCINESSES[(place + 1) % _USUAL_BOUNCINESSES.size()])


## Takes the bounciness C.
func set_bounciness(bounciness: float) -> String:
	var problem := world.surroundings.set_bounciness(bounciness)
	if not problem:
		_begin()
	return problem


## Takes other lines.
func set_lines(new_lines: Array[LineSegment]) -> String:
	if new_lines.size() > AngledLinesLink.MOST_LINES:
		var sentence := tr("There is room for %d lines: delete one first.")
		return sentence % AngledLinesLink.MOST_LINES
	var problem := world.surroundings.set_segments(new_lines)
	if not problem:
		_begin()
	return problem


## Copies of all lines.
func lines() -> Array[LineSegment]:
	var copies: Array[LineSegment] = []
	for line in world.surroundings.segments:
		copies.append(line.copy())
	return copies


## Puts the selected ball elsewhere; its velocity stays.
func move_ball(position: Vec2) -> String:
	return change_ball(position, ball().velocity)


## Puts the selected ball elsewhere or gives it another velocity.
func change_ball(position: Vec2, velocity: Vec2) -> String:
	var problem := world.change_ball(selected, position, velocity)
	if not problem:
		# Brought back to outside of all lines, a lost ball would only be lost again.
		if _is_among_lines(position):
			_starts.change(selected, ball())
		_begin()
	return problem


## What the selected ball will do in [param of_world] in the next 1.5 s.
func forecast(of_world: SteppedWorld) -> BallForecast:
	return BallForecast.of(of_world, selected, FRAME, FORECAST_FRAMES)


## Where the centre of the selected ball is at its next bounce, a [Vec2]; null where none comes
## soon.
func next_touch() -> Variant:
	var bounce := forecast(world).next_bounce
	return bounce.position if bounce else null


## The ball that is selected.
func ball() -> Ball:
	return world.balls[selected]


## Brings every lost ball back to where it began.
func fetch_balls() -> void:
	for some in _worlds():
		_starts.fetch(some)
	if timeline:
		timeline = EventTimeline.new(world, FRAME)


func to_dictionary() -> Dictionary:
	return {
		"preset": preset,
		"method": method,
		"endless": has_endless_lines,
		"mistake": mistake,
		"selected": selected,
		"world": WorldState.of(world),
		"first": _starts.numbers(),
	}


func from_dictionary(stored: Dictionary) -> void:
	var stored_world: Dictionary = stored["world"]
	preset = stored["preset"]
	var stored_method: int = stored["method"]
	method = stored_method as SteppingMethods.Method
	has_endless_lines = stored["endless"]
	mistake = stored["mistake"]
	selected = stored["selected"]
	Refusal.push(WorldState.put(stored_world, world))
	_starts.take(world)
	var numbers: PackedFloat64Array = stored["first"]
	_starts.put(numbers)
	_begin()


## The start of the preset that was picked last.
func reset_state(_first_state: Dictionary) -> Dictionary:
	return _at_start_of(preset).to_dictionary()


func link_state() -> Dictionary:
	return AngledLinesLink.of_state(to_dictionary())


## The start of the preset that [param wanted] names, with the method and the mistake of
## [param first] where its lines end.
func link_base(first: Dictionary, wanted: Dictionary) -> Dictionary:
	var named: int = wanted["scene"]
	var place := clampi(named, 0, AngledLinesPresets.TITLES.size() - 1)
	return AngledLinesLink.with_picked(_at_start_of(place).link_state(), first)


func problem_in(stored: Dictionary) -> String:
	return AngledLinesLink.problem_in(stored)


func state_of_link(linked: Dictionary) -> Dictionary:
	return AngledLinesLink.to_state(linked)


func _at_start_of(wanted_preset: int) -> AngledLinesModel:
	var fresh := AngledLinesModel.new(_first)
	fresh.method = method
	fresh.mistake = mistake
	fresh.set_up(wanted_preset)
	return fresh


# Whether a point lies in the upright rectangle around all lines.
func _is_among_lines(point: Vec2) -> bool:
	var low := Vec2.new(INF, INF)
	var high := Vec2.new(-INF, -INF)
	for line in world.surroundings.segments:
		for end: Vec2 in [line.start, line.end]:
			low.set_xy(minf(low.x, end.x), minf(low.y, end.y))
			high.set_xy(maxf(high.x, end.x), maxf(high.y, end.y))
	var is_between := point.x >= low.x and point.x <= high.x
	return is_between and point.y >= low.y and point.y <= high.y


# From here on energy is compared and the past is counted.
func _begin() -> void:
	if has_endless_lines:
		method = SteppingMethods.Method.POSITION_RESET
		mistake = 0
	world.mover = _mover()
	wrong_world = null
	if not AngledLinesMistakes.can_be_beside(mistake, method):
		mistake = 0
	if mistake:
		wrong_world = world.copy()
		wrong_world.mover = AngledLinesMistakes.mover(mistake)
	_history.clear()
	last_bounce = null
	_first_energy = world.energy()
	timeline = null
	if method == SteppingMethods.Method.EVENT_WORLD:
		timeline = EventTimeline.new(world, FRAME)


func _mover() -> BallMover:
	return EndlessLineMover.new() if has_endless_lines else SteppingMethods.mover_of(method)


func _worlds() -> Array[SteppedWorld]:
	var worlds: Array[SteppedWorld] = [world]
	if wrong_world:
		worlds.append(wrong_world)
	return worlds
