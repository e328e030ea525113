class_name AngledLinesModel
extends RefCounted
## The lesson on angled lines: a world that is stepped, its past, and beside it, where a mistake is
## switched on, the same world with that mistake.
##
## What a student enters is refused with one sentence where it cannot be taken; "" means taken.

## A frame of the course, in seconds.
const FRAME := 1.0 / 60.0
## So many frames are looked ahead.
const FORECAST_FRAMES := 90
## More lines than this would leave no room on the board.
const MOST_LINES := 60
## Gravity that an arrow key gives where there was none, in pixels per second squared.
const USUAL_GRAVITY := 300.0

## The world that is right as far as [member method] is.
var world := SteppedWorld.new(WholeFrameMover.new())
## The world with the mistake; null while none is switched on.
var wrong_world: SteppedWorld
## How a frame is stepped.
var method := SteppingMethods.Method.WHOLE_FRAME
## Number of the mistake that is switched on, 0 for none.
var mistake := 0
## The ready-made situation that was picked last, 0 to 9.
var scene := 0
## The ball that can be dragged and typed, by its place.
var selected := 0
## The latest bounce of the selected ball; null before it.
var last_bounce: BounceRecord
## In the event world any moment can be gone to; null in the other ways of stepping.
var timeline: EventTimeline
## What the latest step, forward or back, was refused with; "" if it was not.
var refusal := ""

var _history := StepHistory.new()
var _starts := BallStarts.new()
var _first_energy := 0.0


## The situation on key 0.
func _init() -> void:
	set_up(0)


## Puts up one of the ready-made situations, 0 to 9, with the method and mistake as they are.
func set_up(number: int) -> void:
	scene = number
	selected = 0
	AngledLinesScenes.set_up(number, world)
	_starts.take(world)
	_begin()


## Another model, at the start of the situation that was picked last.
func start_again() -> AngledLinesModel:
	var fresh := AngledLinesModel.new()
	fresh.method = method
	fresh.mistake = mistake
	fresh.set_up(scene)
	return fresh


## Puts up the situation of [param other], such as that of a question.
func take(other: SteppedWorld) -> void:
	selected = 0
	world = other.copy()
	_starts.take(world)
	_begin()


## Switches to the way of stepping [param new_method]. All mistakes are made in stepping: in the
## event world none is left.
func set_method(new_method: SteppingMethods.Method) -> void:
	method = new_method
	if method == SteppingMethods.Method.EVENT_WORLD:
		mistake = 0
	_begin()


## Switches a mistake on, beside the right way, in a situation that shows it; 0 switches it off.
func set_mistake(number: int) -> void:
	mistake = number
	if number:
		method = SteppingMethods.Method.WHOLE_FRAME
		set_up(AngledLinesMistakes.SCENES[number])
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


## Goes to a moment of the [member timeline], in seconds since its beginning.
func go_to(seconds: float) -> String:
	var problem := timeline.go_to(seconds)
	last_bounce = timeline.last_bounce(selected)
	return problem


## Seconds that have passed in the world.
func elapsed_seconds() -> float:
	return timeline.elapsed_seconds() if timeline else world.frames * FRAME


## Energy now as a share of the energy at the start: of [member world], or of [member wrong_world].
## 1 where there was none.
func energy_share(of_world: SteppedWorld) -> float:
	return of_world.energy() / _first_energy if _first_energy != 0.0 else 1.0


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


## Takes the bounciness C.
func set_bounciness(bounciness: float) -> String:
	var problem := world.surroundings.set_bounciness(bounciness)
	if not problem:
		_begin()
	return problem


## Takes other lines.
func set_lines(new_lines: Array[LineSegment]) -> String:
	if new_lines.size() > MOST_LINES:
		return _translate("There is room for %d lines: delete one first.") % MOST_LINES
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


## Puts the selected ball elsewhere or gives it another velocity.
func change_ball(position: Vec2, velocity: Vec2) -> String:
	var problem := world.change_ball(selected, position, velocity)
	if not problem:
		_starts.change(selected, ball())
		_begin()
	return problem


## What the selected ball will do in [param of_world] within a second and a half.
func forecast(of_world: SteppedWorld) -> BallForecast:
	return BallForecast.of(of_world, selected, FRAME, FORECAST_FRAMES)


## The ball that is selected.
func ball() -> Ball:
	return world.balls[selected]


## Brings every lost ball back to where it began.
func fetch_balls() -> void:
	for some in _worlds():
		_starts.fetch(some)
	if timeline:
		timeline = EventTimeline.new(world)


## All of it, for undo and links.
func to_dictionary() -> Dictionary:
	return {
		"scene": scene,
		"method": method,
		"mistake": mistake,
		"selected": selected,
		"world": WorldState.of(world),
		"first": _starts.numbers(),
	}


## Puts back what [method to_dictionary] has told.
func from_dictionary(stored: Dictionary) -> void:
	var stored_world: Dictionary = stored["world"]
	scene = stored["scene"]
	var stored_method: int = stored["method"]
	method = stored_method as SteppingMethods.Method
	mistake = stored["mistake"]
	selected = stored["selected"]
	Refusal.push(WorldState.put(stored_world, world))
	_starts.take(world)
	var numbers: PackedFloat64Array = stored["first"]
	_starts.put(numbers)
	_begin()


# From here on energy is compared and the past is counted.
func _begin() -> void:
	world.mover = SteppingMethods.mover_of(method)
	wrong_world = null
	if mistake:
		wrong_world = world.copy()
		wrong_world.mover = AngledLinesMistakes.mover(mistake)
	_history.clear()
	last_bounce = null
	_first_energy = world.energy()
	timeline = null
	if method == SteppingMethods.Method.EVENT_WORLD:
		timeline = EventTimeline.new(world)


func _worlds() -> Array[SteppedWorld]:
	var worlds: Array[SteppedWorld] = [world]
	if wrong_world:
		worlds.append(wrong_world)
	return worlds


static func _translate(sentence: String) -> String:
	return TranslationServer.translate(sentence)
