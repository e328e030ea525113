class_name EventMover
extends BallMover
## Goes beyond the lecture: each ball flies in an [EventWorld] of its own, because in a
## [SteppedWorld] balls do not touch each other. The next impact is computed once, from exact
## formulas, and holds for all frames until something changes.
##
## The mover remembers the balls that it moves, so a copied world gets a new one; see
## [method for_copy].

## A ball with more impacts than this within one second stays where it is, such as a ball between
## two lines that touch it on both sides. A larger number would let such a ball take longer than a
## frame.
const MOST_IMPACTS := 2000
## Such a ball that cannot rise by more than this, in pixels, has come to rest as far as anybody can
## see: it bounces in the corner of two lines, off one and then the other, without end.
const UNSEEN_HEIGHT := 0.5

var _worlds: Dictionary[Ball, EventWorld] = {}
# The surroundings for which the worlds were made, and their count of changes at that time.
var _surroundings: Surroundings
var _changes := -1


## An event world in which [param ball] alone flies among the lines of [param surroundings].
static func world_of(ball: Ball, surroundings: Surroundings) -> EventWorld:
	var world := EventWorld.new()
	world.most_impacts_per_second = MOST_IMPACTS
	world.keeps_events = true
	# What a SteppedWorld takes, an EventWorld takes: its limits are wider.
	Refusal.push(world.set_gravity(surroundings.gravity))
	Refusal.push(world.set_bounciness(surroundings.bounciness))
	Refusal.push(world.set_segments(surroundings.segments))
	Refusal.push(world.set_balls([ball]))
	return world


## The record of an event. The frame starts at [param frame_start] and lasts [param seconds]; from
## these follows the fraction of the frame before the event.
static func record_of(
	event: WorldEvent, radius: float, frame_start: float, seconds: float
) -> BounceRecord:
	var record := BounceRecord.new()
	record.position = event.point.plus(event.normal.scaled(radius))
	record.normal = event.normal
	record.velocity_before = event.velocity_before
	record.velocity_after = event.velocity_after
	record.fraction = (event.time - frame_start) / seconds
	return record


## A new mover: two worlds never share what is remembered about a ball.
func for_copy() -> BallMover:
	return EventMover.new()


## See [method BallMover.move]. Coming to rest and sliding off an end do not count as bounces.
func move(ball: Ball, seconds: float, surroundings: Surroundings) -> Array[BounceRecord]:
	_forget_where_changed(surroundings)
	if not _knows(ball):
		_worlds[ball] = world_of(ball, surroundings)
	var world := _worlds[ball]
	var frame_start := world.time
	refusal = world.advance(seconds)
	if refusal and _looks_at_rest(world, surroundings.gravity):
		refusal = ""
	ball.position = world.position(0)
	ball.velocity = world.velocity(0)
	var bounces: Array[BounceRecord] = []
	for event in world.events:
		if event.kind == WorldEvent.Kind.SEGMENT:
			bounces.append(record_of(event, ball.radius, frame_start, seconds))
	world.events.clear()
	return bounces


static func _looks_at_rest(world: EventWorld, gravity: Vec2) -> bool:
	return world.velocity(0).length_squared() <= 2.0 * gravity.length() * UNSEEN_HEIGHT


func _forget_where_changed(surroundings: Surroundings) -> void:
	if surroundings != _surroundings or surroundings.changes != _changes:
		_worlds.clear()
		_surroundings = surroundings
		_changes = surroundings.changes


# False for a ball that something else has moved since the last frame: it gets a new world.
func _knows(ball: Ball) -> bool:
	var world: EventWorld = _worlds.get(ball)
	if not world:
		return false
	var velocity := world.velocity(0)
	if velocity.x != ball.velocity.x or velocity.y != ball.velocity.y:
		return false
	return world.position_x(0) == ball.position.x and world.position_y(0) == ball.position.y
